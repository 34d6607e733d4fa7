// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_change.h"

#include "filters/geometry/collect.h"

#include <algorithm>

namespace scan
{
namespace
{

/// Appends the triangles of a tetrahedron that are on the surface of one state only. Of two
/// tetrahedra that changed the one that names a triangle speaks for both.
void compareAt(
  const WrapComplex& before, const WrapComplex& after, Index tet, std::vector<Facet>& changed)
{
  const DelaunayComplex& complex = before.flow().delaunay();
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    const Facet name = complex.canonical(facet);
    if ((name == facet || before.isEqualAt(after, name / 4)) &&
      isOnSurface(before, facet) != isOnSurface(after, facet))
    {
      changed.push_back(name);
    }
  }
}

} // namespace

SurfaceChange compareSurfaces(
  const WrapComplex& before, const WrapComplex& after, Execution& execution)
{
  constexpr Index kRun = 256; // tetrahedra compared in one go
  const Index count = before.flow().delaunay().tetCount();
  std::vector<Facet> changed = collect<Facet>((count + kRun - 1) / kRun, execution,
    [&](Index run, auto& found)
    {
      const Index end = std::min(count, kRun * (run + 1));
      if (before.isEqualIn(after, kRun * run, end))
      {
        return;
      }
      for (Index tet = kRun * run; tet < end; ++tet)
      {
        if (!before.isEqualAt(after, tet))
        {
          compareAt(before, after, tet, found);
        }
      }
    });
  std::ranges::sort(changed);
  SurfaceChange change;
  for (const Facet facet : changed)
  {
    (isOnSurface(after, facet) ? change.added : change.gone).push_back(facet);
  }
  return change;
}

} // namespace scan
