// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shoot.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_predicates.h"
#include "filters/geometry/model_edit.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/tet_star.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace scan
{
namespace
{

/// A face of a tetrahedron, by its sorted vertices.
struct Face
{
  std::vector<Index> vertices;
  Index tet; ///< one that has it

  bool has(Index vertex) const { return std::ranges::binary_search(this->vertices, vertex); }
};

struct Line
{
  Vec3 from;
  Vec3 to;
};

/// Calls visit(tet) for all tetrahedra that have the face.
template <class Visit>
void forEachTetAt(const DelaunayComplex& complex, const Face& face, Visit&& visit)
{
  forEachTetAround(complex, face.vertices, face.tet,
    [&](Index tet)
    {
      visit(tet);
      return true;
    });
}

/// Calls visit(facet) for the facets of a tetrahedron that have the face.
template <class Visit>
void forEachFacetAt(const DelaunayComplex& complex, const Face& face, Index tet, Visit&& visit)
{
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    if (!face.has(complex.tetrahedra[tet][facet % 4]))
    {
      visit(facet);
    }
  }
}

/// The smallest face of a triangle that the line crosses it in, on its way out of the facet's
/// tetrahedron. Nothing when it misses the triangle, comes in or runs in its plane.
std::optional<Face> leavingThrough(
  const DelaunayComplex& complex, const Line& line, const Triangle& triangle, Index tet)
{
  const auto& p = complex.points;
  Face face{ .vertices = {}, .tet = tet };
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int side =
      orientation(line.from, line.to, p[triangle[(k + 1) % 3]], p[triangle[(k + 2) % 3]]);
    if (side < 0)
    {
      return {};
    }
    if (side > 0)
    {
      face.vertices.push_back(triangle[k]);
    }
  }
  std::ranges::sort(face.vertices);
  return face.vertices.empty() ? std::nullopt : std::optional(face);
}

/// Where a line leaves a tetrahedron that it touches.
std::optional<Face> leaving(const DelaunayComplex& complex, const Line& line, Index tet)
{
  std::optional<Face> face;
  for (Facet facet = 4 * tet; facet < 4 * tet + 4 && !face; ++facet)
  {
    face = leavingThrough(complex, line, complex.facetVertices(facet), tet);
  }
  return face;
}

/// Where the line is next in a smaller face than between here and there.
std::optional<Face> nextFace(const DelaunayComplex& complex, const Line& line, const Face& here)
{
  std::optional<Face> next;
  forEachTetAt(complex, here,
    [&](Index tet)
    {
      const std::optional<Face> there = leaving(complex, line, tet);
      if (there && there->vertices != here.vertices)
      {
        next = there;
      }
    });
  return next;
}

bool isKeptBetween(const WrapComplex& kept, const Face& here, const Face& there)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  Face both{ .vertices = {}, .tet = there.tet };
  std::ranges::set_union(here.vertices, there.vertices, std::back_inserter(both.vertices));
  bool isKept = false;
  forEachTetAt(complex, both,
    [&](Index tet)
    {
      isKept = isKept || kept.keepsTet(tet);
      forEachFacetAt(
        complex, both, tet, [&](Facet facet) { isKept = isKept || kept.isSheet(facet); });
    });
  return isKept;
}

/// The second point of a line: far enough that rounding it does not turn the line, and a power of
/// two times the direction, so that lines through points of a grid stay so.
Vec3 farPoint(const Vec3& from, const Vec3& edge, const Vec3& direction)
{
  const double far = std::sqrt(dot(from, from)) + std::sqrt(dot(edge, edge));
  const double length = std::sqrt(dot(direction, direction));
  return from + direction * std::exp2(std::ceil(std::log2(far / length)));
}

/// The face of the marked triangle that the line crosses; its point is moved onto the triangle, and
/// a little to the middle where rounding has put it beside the triangle.
Face startOf(const DelaunayComplex& complex, Facet triangle, const Vec3& direction, Line& line)
{
  Triangle v = complex.facetVertices(triangle);
  const Vec3& a = complex.points[v[0]];
  const Vec3& b = complex.points[v[1]];
  const Vec3& c = complex.points[v[2]];
  const Vec3 nearest = nearestPointOnTriangle(line.from, a, b, c);
  const Vec3 middle = (a + b + c) * (1.0 / 3.0);
  const double length2 = dot(direction, direction);
  constexpr double kNudge = 1e-9;
  for (const Vec3& from : { nearest, nearest + (middle - nearest) * kNudge })
  {
    line = { from, farPoint(from, b - a, direction) };
    for (int side = 0; side < 2 && length2 > 0.0 && std::isfinite(length2); ++side)
    {
      if (const auto start = leavingThrough(complex, line, v, triangle / 4))
      {
        return *start;
      }
      std::swap(v[1], v[2]);
    }
  }
  throw Error(ErrorCode::badInput,
    "cannot shoot from triangle " + std::to_string(triangle) +
      " along its plane or without a direction; give a direction that leaves it");
}

/// The blocks of everything kept that has the face, in the order of first meeting.
class Hits
{
public:
  Hits(const WrapModel& model, const Blocks& blocks)
    : Model(model)
    , TheBlocks(blocks)
  {
  }

  void meet(const Face& face)
  {
    const DelaunayComplex& complex = this->Model.scan->delaunay();
    forEachTetAt(complex, face,
      [&](Index tet)
      {
        if (this->Model.current->keepsTet(tet))
        {
          this->add(4 * tet);
        }
        forEachFacetAt(complex, face, tet,
          [&](Facet facet)
          {
            if (this->Model.current->isSheet(facet))
            {
              this->add(facet);
            }
          });
      });
  }

  std::vector<BlockName> take() { return std::move(this->Names); }

private:
  void add(Facet facet)
  {
    const BlockName name = blockBehind(this->Model, this->TheBlocks, facet);
    if (this->Known.insert(name).second)
    {
      this->Names.push_back(name);
    }
  }

  const WrapModel& Model;
  const Blocks& TheBlocks;
  std::set<BlockName> Known;
  std::vector<BlockName> Names;
};

} // namespace

std::vector<BlockName> blocksInSight(const WrapModel& model, Facet triangle, const Vec3& point,
  const Vec3& direction, Execution& execution)
{
  if (!isOnSurface(*model.current, triangle))
  {
    throw Error(ErrorCode::badInput,
      "triangle " + std::to_string(triangle) + " is not on the surface; mark one that is");
  }
  const DelaunayComplex& complex = model.scan->delaunay();
  Hits hits(model, model.scan->blocks(execution));
  Line line{ point, point };
  std::optional<Face> here = startOf(complex, triangle, direction, line);
  while (here)
  {
    execution.step("shoot", 0, 1);
    hits.meet(*here);
    std::optional<Face> next = nextFace(complex, line, *here);
    here = next && isKeptBetween(*model.current, *here, *next) ? next : std::nullopt;
  }
  return hits.take();
}

} // namespace scan
