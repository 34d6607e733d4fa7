// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/single_tets.h"

#include <algorithm>

namespace scan
{
namespace
{

void sortOnce(std::vector<Index>& names)
{
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

} // namespace

EditReport pushTets(WrapModel& model, std::span<const Facet> triangles, Execution& execution)
{
  execution.step("push", 0, 1);
  const DelaunayComplex& complex = model.scan->delaunay();
  std::vector<Index> tets;
  std::vector<Facet> sheets;
  for (const Facet triangle : triangles)
  {
    if (model.current->isSheet(triangle))
    {
      sheets.push_back(complex.canonical(triangle));
    }
    else if (isOnSurface(*model.current, triangle))
    {
      tets.push_back(model.current->keptTetAt(triangle));
    }
  }
  sortOnce(tets);
  sortOnce(sheets);
  ModelEdit edit(model);
  edit.removeWhole(tets);
  for (const Facet sheet : sheets)
  {
    edit.editor().removeSheet(sheet);
  }
  execution.step("push", 1, 1);
  return edit.finish(execution);
}

EditReport fillTets(WrapModel& model, std::span<const Facet> triangles, Execution& execution)
{
  execution.step("fill", 0, 1);
  const DelaunayComplex& complex = model.scan->delaunay();
  ModelEdit edit(model);
  for (const Facet triangle : triangles)
  {
    const Index tet = model.current->keepsTet(triangle / 4)
      ? complex.neighbour(triangle / 4, static_cast<int>(triangle % 4))
      : triangle / 4;
    if (tet != kNone && isOnSurface(*model.current, triangle))
    {
      edit.editor().addTet(tet);
    }
  }
  execution.step("fill", 1, 1);
  return edit.finish(execution);
}

} // namespace scan
