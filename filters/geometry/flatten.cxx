// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/flatten.h"

#include "filters/geometry/dihedral_angle.h"

#include <algorithm>
#include <functional>
#include <numbers>

namespace scan
{
namespace
{

/// Kept tetrahedra that hang together by triangles, and their boundary seen from them.
struct Part
{
  std::vector<Index> tets;
  std::vector<Facet> boundary; ///< in increasing order
};

/// A piece of a part's boundary.
using Piece = std::vector<Facet>;

/// Where the boundary of a part goes on across an edge, and the angle inside the part.
struct Fold
{
  Facet next;
  double angle;
};

Part partAround(const WrapComplex& kept, Index first, std::vector<bool>& seen)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  Part part{ .tets = { first }, .boundary = {} };
  seen[first] = true;
  for (std::size_t i = 0; i < part.tets.size(); ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Index beyond = complex.neighbour(part.tets[i], k);
      if (beyond == kNone || !kept.keepsTet(beyond))
      {
        part.boundary.push_back(4 * part.tets[i] + static_cast<Facet>(k));
      }
      else if (!seen[beyond])
      {
        seen[beyond] = true;
        part.tets.push_back(beyond);
      }
    }
  }
  std::ranges::sort(part.boundary);
  return part;
}

Fold foldAt(const WrapComplex& kept, Facet triangle, Index apex, const Segment& edge)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  const auto& p = complex.points;
  Fold fold{ .next = kNone, .angle = 0.0 };
  Index behind = apex;
  complex.walkAroundEdge(triangle, apex,
    [&](Facet entering, Facet leaving, Facet beyond)
    {
      const Index ahead = complex.tetrahedra[entering / 4][entering % 4];
      fold.angle += dihedralAngle(p[edge[0]], p[edge[1]], p[behind], p[ahead]);
      fold.next = leaving;
      behind = ahead;
      return beyond != kNone && kept.keepsTet(beyond / 4);
    });
  return fold;
}

/// What of the boundary hangs together with number `first` by edges that are not acute.
Piece pieceAround(
  const WrapComplex& kept, const Part& part, std::size_t first, std::vector<bool>& isTaken)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  Piece piece{ part.boundary[first] };
  isTaken[first] = true;
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    const Triangle v = complex.facetVertices(piece[i]);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Fold fold = foldAt(kept, piece[i], v[(k + 2) % 3], { v[k], v[(k + 1) % 3] });
      const auto next = static_cast<std::size_t>(
        std::ranges::lower_bound(part.boundary, fold.next) - part.boundary.begin());
      if (fold.angle >= 0.5 * std::numbers::pi && !isTaken[next])
      {
        isTaken[next] = true;
        piece.push_back(fold.next);
      }
    }
  }
  return piece;
}

std::vector<Piece> piecesOf(const WrapComplex& kept, const Part& part)
{
  std::vector<Piece> pieces;
  std::vector<bool> isTaken(part.boundary.size(), false);
  for (std::size_t i = 0; i < isTaken.size(); ++i)
  {
    if (!isTaken[i])
    {
      pieces.push_back(pieceAround(kept, part, i, isTaken));
    }
  }
  return pieces;
}

/// A disk whose vertices all lie on its rim. Triangles that hang together by edges have at most two
/// vertices more than triangles; exactly two when they are a tree and meet nowhere else.
bool isPolygon(const DelaunayComplex& complex, const Piece& piece)
{
  std::vector<Index> vertices;
  for (const Facet facet : piece)
  {
    const Triangle v = complex.facetVertices(facet);
    vertices.insert(vertices.end(), v.begin(), v.end());
  }
  std::ranges::sort(vertices);
  const auto count = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
  return piece.size() + 2 == static_cast<std::size_t>(count);
}

/// Radii from large to small, the triangles' names at the end: smaller is better.
std::pair<std::vector<double>, std::vector<Facet>> rankOf(
  const DelaunayComplex& complex, const Piece& piece)
{
  std::vector<double> radii2;
  std::vector<Facet> names;
  for (const Facet facet : piece)
  {
    radii2.push_back(circumradiusSquared(complex, complex.facetVertices(facet)));
    names.push_back(complex.canonical(facet));
  }
  std::ranges::sort(radii2, std::greater{});
  std::ranges::sort(names);
  return { radii2, names };
}

/// The triangles of a thin part that are not wanted; none when the part is not thin.
Piece worseHalf(const WrapComplex& kept, const Part& part)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  const std::vector<Piece> halves = piecesOf(kept, part);
  if (halves.size() != 2 || !isPolygon(complex, halves[0]) || !isPolygon(complex, halves[1]))
  {
    return {};
  }
  return rankOf(complex, halves[0]) < rankOf(complex, halves[1]) ? halves[1] : halves[0];
}

void replaceByHalf(ModelEdit& edit, const Part& part, const Piece& unwanted)
{
  const DelaunayComplex& complex = edit.kept().flow().delaunay();
  std::vector<Facet> inner; // between tetrahedra of the part
  for (const Index tet : part.tets)
  {
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      if (edit.kept().keptSides(facet) == 2 && complex.canonical(facet) == facet)
      {
        inner.push_back(facet);
      }
    }
  }
  for (const Index tet : part.tets)
  {
    edit.editor().removeTet(tet);
  }
  for (const Facet facet : inner)
  {
    edit.editor().removeSheet(facet);
  }
  for (const Facet facet : unwanted)
  {
    edit.editor().removeSheet(facet);
  }
}

} // namespace

FlattenReport flatten(WrapModel& model, std::span<const Facet> triangles, Execution& execution)
{
  const DelaunayComplex& complex = model.scan->delaunay();
  const Region region(complex, triangles);
  ModelEdit edit(model);
  FlattenReport report;
  std::vector<bool> seen(complex.tetCount(), false);
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    if (tet % (1 << 14) == 0)
    {
      execution.step("flatten", tet, complex.tetCount());
    }
    if (!model.current->keepsTet(tet) || seen[tet])
    {
      continue;
    }
    const Part part = partAround(*model.current, tet, seen);
    if (std::ranges::none_of(part.boundary, [&](Facet facet) { return region.contains(facet); }))
    {
      continue;
    }
    const Piece unwanted = worseHalf(*model.current, part);
    if (!unwanted.empty())
    {
      replaceByHalf(edit, part, unwanted);
      ++report.parts;
    }
  }
  execution.step("flatten", 1, 1);
  static_cast<EditReport&>(report) = edit.finish(execution);
  model.isSolid = model.isSolid && report.parts == 0;
  return report;
}

} // namespace scan
