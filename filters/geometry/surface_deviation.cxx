// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_deviation.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/convex_piece.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/hilbert_order.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace scan
{
namespace
{

constexpr double kSpare = 1.01; // how far the bound may be above what was found
constexpr std::size_t kGrain = 1 << 10;

struct Corners3
{
  Vec3 a;
  Vec3 b;
  Vec3 c;
};

Corners3 cornersOf(const TriMesh& mesh, Index triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return { mesh.points[a], mesh.points[b], mesh.points[c] };
}

/// What is known about the distances of a triangle's points.
struct Bounds
{
  double atLeast = 0.0; ///< the largest that was found
  double atMost = 0.0;
  Vec3 where; ///< of the one that was found
};

/// Bounds the distance from a triangle to a surface. The distance from a convex set is convex, so
/// that of the points of a convex piece from one triangle of the surface is largest at the corners
/// of the piece. Where that is too much the piece is cut along the triangle's borders, and the rest
/// has other nearest triangles.
class Bounder
{
public:
  explicit Bounder(const TriangleTree& to)
    : To(to)
  {
  }

  /// @param limit where the bound is below it is as good as 0
  /// @param known the nearest place to the middle, and bounds from points that were looked at
  Bounds bound(const Corners3& triangle, const SurfacePlace& nearest, const Bounds& known,
    double limit, bool stopsBeyond)
  {
    this->Known = known;
    this->Known.atMost = known.atLeast;
    this->Limit = limit;
    this->Pieces.clear();
    this->Budget = kMostPieces;
    this->take(ConvexPiece({ triangle.a, triangle.b, triangle.c }), nearest, {});
    while (!this->Pieces.empty() && !(stopsBeyond && this->Known.atLeast > limit))
    {
      const Waiting next = this->Pieces.back();
      this->Pieces.pop_back();
      if (next.bound <= this->goal() || this->Budget == 0)
      {
        this->Known.atMost = std::max(this->Known.atMost, next.bound);
        continue;
      }
      this->refine(next);
    }
    for (const Waiting& left : this->Pieces)
    {
      this->Known.atMost = std::max(this->Known.atMost, left.bound);
    }
    return this->Known;
  }

private:
  static constexpr std::size_t kMostPieces = 1 << 20; // of a triangle

  static constexpr int kMostCuts = 4; // without a halving between them: they may be next to nothing

  struct Waiting
  {
    ConvexPiece piece;
    Index nearest = kNone;       // triangle to the middle of the piece
    Index cutAlong = kNone;      // the last triangle along which it was cut
    int cuts = 0;                // since it was halved
    double middleDistance = 0.0; // of the middle
    double bound = 0.0;
  };

  double goal() const { return std::max(this->Limit, this->Known.atLeast * kSpare); }

  double bound(const ConvexPiece& piece, const Corners3& nearest) const
  {
    double most = 0.0;
    for (const Vec3& corner : piece.corners())
    {
      most = std::max(most, squaredDistance(corner, nearest.a, nearest.b, nearest.c));
    }
    return std::sqrt(most);
  }

  /// @param origin tells along what the piece was cut
  void take(const ConvexPiece& piece, const SurfacePlace& nearest, const Waiting& origin)
  {
    const Vec3 middle = piece.middle();
    const double middleDistance = std::sqrt(nearest.squaredDistance);
    if (middleDistance > this->Known.atLeast)
    {
      this->Known.atLeast = middleDistance;
      this->Known.where = middle;
    }
    const double reach = middleDistance + piece.radius(middle);
    const double bound =
      std::min(reach, this->bound(piece, cornersOf(this->To.mesh(), nearest.triangle)));
    if (bound <= this->goal())
    {
      this->Known.atMost = std::max(this->Known.atMost, bound);
      return;
    }
    this->Pieces.push_back(
      { piece, nearest.triangle, origin.cutAlong, origin.cuts, middleDistance, bound });
  }

  void look(const ConvexPiece& piece, const Waiting& origin)
  {
    this->Budget -= this->Budget > 0 ? 1 : 0;
    this->take(piece, this->To.nearest(piece.middle(), origin.nearest), origin);
  }

  /// Cuts the piece along the borders of its nearest triangle, or in the middle.
  void refine(Waiting waiting)
  {
    if (waiting.cutAlong == waiting.nearest || waiting.cuts == kMostCuts || !this->cut(waiting))
    {
      this->Parts.clear();
      this->Parts.push_back(waiting.piece.halve());
      this->Parts.push_back(waiting.piece);
      waiting.cuts = 0;
    }
    else
    {
      waiting.cutAlong = waiting.nearest;
      ++waiting.cuts;
    }
    for (const ConvexPiece& part : this->Parts)
    {
      this->look(part, waiting);
    }
  }

  /// Makes parts of a piece inside and outside the borders of its nearest triangle, widened as far
  /// as the goal allows; false where it is on one side.
  bool cut(const Waiting& waiting)
  {
    this->Parts.clear();
    ConvexPiece inside = waiting.piece;
    if (inside.corners().size() + 3 > ConvexPiece::kMostCorners)
    {
      return false;
    }
    const Corners3 t = cornersOf(this->To.mesh(), waiting.nearest);
    const Vec3 normal = cross(t.b - t.a, t.c - t.a);
    const double slack2 =
      this->goal() * this->goal() - waiting.middleDistance * waiting.middleDistance;
    const double slack = kSlackUsed * std::sqrt(std::max(slack2, 0.0));
    const std::array<std::array<const Vec3*, 2>, 3> edges = { { { &t.a, &t.b }, { &t.b, &t.c },
      { &t.c, &t.a } } };
    for (const auto& [from, to] : edges)
    {
      const Vec3 inwards = unitVector(cross(normal, *to - *from));
      const ConvexPiece outside = inside.cut(inwards, dot(inwards, *from) - slack);
      if (inside.corners().empty())
      {
        return false;
      }
      if (!outside.corners().empty())
      {
        this->Parts.push_back(outside);
      }
    }
    this->Parts.push_back(inside);
    return this->Parts.size() > 1;
  }

  static constexpr double kSlackUsed = 0.4;

  const TriangleTree& To;
  double Limit = 0.0;
  std::size_t Budget = 0;
  Bounds Known;
  std::vector<Waiting> Pieces;
  std::vector<ConvexPiece> Parts;
};

Vec3 middleOf(const Corners3& t)
{
  return (t.a + t.b + t.c) * (1.0 / 3.0);
}

/// The nearest places to points that are looked up in an order in which neighbours are near.
template <class At>
std::vector<SurfacePlace> nearestPlaces(
  std::span<const Index> order, const TriangleTree& to, Execution& execution, At&& at)
{
  std::vector<SurfacePlace> places(order.size());
  execution.parallelFor(order.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      Index hint = kNone;
      for (std::size_t i = begin; i < end; ++i)
      {
        places[order[i]] = to.nearest(at(order[i]), hint);
        hint = places[order[i]].triangle;
      }
    });
  return places;
}

std::vector<Vec3> middles(const TriMesh& mesh)
{
  std::vector<Vec3> points(mesh.triangles.size());
  for (Index t = 0; t < points.size(); ++t)
  {
    points[t] = middleOf(cornersOf(mesh, t));
  }
  return points;
}

} // namespace

SurfaceDeviation deviationFrom(const TriMesh& from, const TriangleTree& to, Execution& execution)
{
  requireCorners(from);
  if (to.mesh().triangles.empty())
  {
    throw Error(ErrorCode::badInput, "the surface to measure from has no triangles");
  }
  SurfaceDeviation result;
  if (from.triangles.empty())
  {
    return result;
  }
  const std::vector<Vec3> middle = middles(from);
  const std::vector<Index> order = hilbertOrder(middle, execution);
  const std::vector<SurfacePlace> ofMiddles =
    nearestPlaces(order, to, execution, [&](Index t) { return middle[t]; });
  std::vector<double> ofPoints(from.points.size(), -1.0);
  std::vector<Index> pointOrder; // as the triangles come
  std::vector<Index> pointHint;
  for (const Index t : order)
  {
    for (const Index corner : from.triangles[t])
    {
      if (ofPoints[corner] < 0.0)
      {
        ofPoints[corner] = 0.0;
        pointOrder.push_back(corner);
        pointHint.push_back(ofMiddles[t].triangle);
      }
    }
  }
  execution.parallelFor(pointOrder.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        ofPoints[pointOrder[i]] =
          std::sqrt(to.nearest(from.points[pointOrder[i]], pointHint[i]).squaredDistance);
      }
    });
  double area = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  std::vector<Bounds> bounds(from.triangles.size());
  for (Index t = 0; t < from.triangles.size(); ++t)
  {
    const Corners3 c = cornersOf(from, t);
    const double own = length(cross(c.b - c.a, c.c - c.a));
    const auto& [i, j, k] = from.triangles[t];
    const double atMiddle = std::sqrt(ofMiddles[t].squaredDistance);
    area += own;
    sum += own * (0.75 * atMiddle + (ofPoints[i] + ofPoints[j] + ofPoints[k]) / 12.0);
    squares += own *
      (0.75 * atMiddle * atMiddle +
        (ofPoints[i] * ofPoints[i] + ofPoints[j] * ofPoints[j] + ofPoints[k] * ofPoints[k]) / 12.0);
    Bounds& known = bounds[t];
    known = { atMiddle, 0.0, middle[t] };
    for (const Index corner : from.triangles[t])
    {
      if (ofPoints[corner] > known.atLeast)
      {
        known.atLeast = ofPoints[corner];
        known.where = from.points[corner];
      }
    }
    if (t == 0 || known.atLeast > result.largest)
    {
      result.largest = known.atLeast;
      result.where = known.where;
    }
  }
  result.mean = area > 0.0 ? sum / area : 0.0;
  result.rms = area > 0.0 ? std::sqrt(squares / area) : 0.0;
  const double diagonal =
    std::max(BoundingBox(from.points).diagonal(), BoundingBox(to.mesh().points).diagonal());
  const double limit = std::max(result.largest * kSpare, 1e-6 * diagonal);
  execution.parallelFor(order.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      Bounder bounder(to);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index t = order[i];
        bounds[t] = bounder.bound(cornersOf(from, t), ofMiddles[t], bounds[t], limit, false);
      }
    });
  for (const Bounds& known : bounds)
  {
    if (known.atLeast > result.largest)
    {
      result.largest = known.atLeast;
      result.where = known.where;
    }
    result.atMost = std::max({ result.atMost, known.atMost, known.atLeast });
  }
  return result;
}

std::vector<Index> trianglesBeyond(
  const TriMesh& from, const TriangleTree& to, double limit, Execution& execution)
{
  requireCorners(from);
  if (to.mesh().triangles.empty())
  {
    throw Error(ErrorCode::badInput, "the surface to measure from has no triangles");
  }
  const std::vector<Index> order = hilbertOrder(middles(from), execution);
  std::vector<std::uint8_t> isBeyond(order.size(), 0);
  execution.parallelFor(order.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      Bounder bounder(to);
      Index hint = kNone;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Corners3 t = cornersOf(from, order[i]);
        const SurfacePlace nearest = to.nearest(middleOf(t), hint);
        hint = nearest.triangle;
        const Bounds bounds = bounder.bound(t, nearest, {}, limit, true);
        isBeyond[order[i]] = std::max(bounds.atMost, bounds.atLeast) > limit ? 1 : 0;
      }
    });
  return collect<Index>(static_cast<Index>(order.size()), execution,
    [&](Index t, std::vector<Index>& found)
    {
      if (isBeyond[t] != 0)
      {
        found.push_back(t);
      }
    });
}

} // namespace scan
