// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_change.h"

#include <algorithm>

namespace scan
{

SurfaceChange compareSurfaces(
  const WrapComplex& before, const WrapComplex& after, const WrapEditor& editor)
{
  const DelaunayComplex& complex = before.flow().delaunay();
  std::vector<Facet> changed;
  const auto look = [&](Facet facet)
  {
    if (isOnSurface(before, facet) != isOnSurface(after, facet))
    {
      changed.push_back(complex.canonical(facet));
    }
  };
  for (const Index tet : editor.touchedTets())
  {
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      look(facet);
    }
  }
  for (const Facet facet : editor.touchedSheets())
  {
    look(facet);
  }
  std::ranges::sort(changed);
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  SurfaceChange change;
  for (const Facet facet : changed)
  {
    (isOnSurface(after, facet) ? change.added : change.gone).push_back(facet);
  }
  return change;
}

} // namespace scan
