// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/webs.h"

#include "filters/geometry/scan_spacing.h"

#include <algorithm>
#include <queue>

namespace scan
{
namespace
{

std::vector<Facet> sheetsIn(const WrapComplex& kept, const Region& region, Execution& execution)
{
  std::vector<Facet> sheets = sheetsOf(kept, execution);
  std::erase_if(sheets, [&](Facet facet) { return !region.contains(facet); });
  return sheets;
}

double radiusSquared(const DelaunayComplex& complex, Facet facet)
{
  return circumradiusSquared(complex, complex.facetVertices(facet));
}

/// A sheet with a free edge and no edge that has two triangles.
bool hangs(const WrapComplex& kept, Facet sheet)
{
  int free = 0;
  int crowded = 0;
  for (const Index apex : kept.flow().delaunay().facetVertices(sheet))
  {
    const int triangles = keptTrianglesAtEdge(kept, { sheet, apex }, 3);
    free += triangles == 1 ? 1 : 0;
    crowded += triangles == 3 ? 1 : 0;
  }
  return free > 0 && free + crowded == 3;
}

Index removeSparse(ModelEdit& edit, const std::vector<Facet>& sheets,
  const std::vector<float>& spacing, double factor)
{
  const DelaunayComplex& complex = edit.kept().flow().delaunay();
  Index removed = 0;
  for (const Facet sheet : sheets)
  {
    const Triangle v = complex.facetVertices(sheet);
    const double limit = factor * std::max({ spacing[v[0]], spacing[v[1]], spacing[v[2]] });
    if (radiusSquared(complex, sheet) > limit * limit)
    {
      edit.editor().removeSheet(sheet);
      ++removed;
    }
  }
  return removed;
}

Index removeHanging(
  ModelEdit& edit, const std::vector<Facet>& sheets, const Region& region, Execution& execution)
{
  const DelaunayComplex& complex = edit.kept().flow().delaunay();
  std::priority_queue<std::pair<double, Facet>> largestFirst;
  const auto offer = [&](Facet sheet)
  {
    if (edit.kept().isSheet(sheet) && region.contains(sheet) && hangs(edit.kept(), sheet))
    {
      largestFirst.emplace(radiusSquared(complex, sheet), complex.canonical(sheet));
    }
  };
  std::ranges::for_each(sheets, offer);
  Index removed = 0;
  while (!largestFirst.empty())
  {
    const Facet sheet = largestFirst.top().second;
    largestFirst.pop();
    if (!edit.kept().isSheet(sheet) || !hangs(edit.kept(), sheet))
    {
      continue;
    }
    edit.editor().removeSheet(sheet);
    if (++removed % 1024 == 0)
    {
      execution.step("webs", 0, 1);
    }
    for (const Index apex : complex.facetVertices(sheet))
    {
      forEachTriangleAtEdge(complex, { sheet, apex },
        [&](Facet at, Index)
        {
          offer(at);
          return true;
        });
    }
  }
  return removed;
}

} // namespace

WebReport removeWebs(WrapModel& model, std::span<const Facet> triangles, const WebOptions& options,
  Execution& execution)
{
  const std::vector<float> spacing = localSpacing(model.scan->flow(), execution);
  execution.step("webs", 0, 1);
  const Region region(model.scan->delaunay(), triangles);
  const std::vector<Facet> sheets = sheetsIn(*model.current, region, execution);

  ModelEdit edit(model);
  WebReport report;
  report.sparse = removeSparse(edit, sheets, spacing, options.factor);
  if (!model.inside) // the automatic wrap's sheets do not hang on the flow
  {
    edit.editor().collapse(execution);
  }
  report.hanging = removeHanging(edit, sheets, region, execution);
  execution.step("webs", 1, 1);
  static_cast<EditReport&>(report) = edit.finish(execution);
  return report;
}

} // namespace scan
