// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/deviation_bound.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kMostPieces = 1 << 18;
constexpr int kMostCuts = 4; // without a halving between them: they may take off next to nothing
constexpr double kSlackUsed = 0.4; // of the distance by which borders may be moved out, for corners

} // namespace

CornerPlaces cornerPlaces(const TriMesh& mesh, Index triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return { mesh.points[a], mesh.points[b], mesh.points[c] };
}

DeviationBounds DeviationBounder::bound(const CornerPlaces& triangle, Index nearest,
  double middleDistance, const DeviationBounds& known, double limit)
{
  this->start(triangle, limit);
  this->Known = known;
  this->take(ConvexPiece(triangle), nearest, middleDistance, {});
  this->refineAll(false);
  return this->Known;
}

bool DeviationBounder::isWithin(
  const CornerPlaces& triangle, Index nearest, double middleDistance, double limit)
{
  this->start(triangle, limit);
  this->Known = {};
  this->take(ConvexPiece(triangle), nearest, middleDistance, {});
  this->refineAll(true);
  return this->Known.atMost <= limit;
}

void DeviationBounder::start(const CornerPlaces& triangle, double limit)
{
  const BoundingBox box(triangle);
  this->Around = { box.low, box.high };
  this->IsNear = false;
  this->Limit = limit;
  this->Budget = kMostPieces;
  this->Pieces.clear();
}

/// @param stopsBeyond whether to stop at a point beyond the limit
void DeviationBounder::refineAll(bool stopsBeyond)
{
  while (!this->Pieces.empty())
  {
    Piece piece = this->Pieces.back();
    this->Pieces.pop_back();
    const bool isDone = this->Budget == 0 || (stopsBeyond && this->Known.atLeast > this->Limit);
    if (piece.bound <= this->goal() || isDone)
    {
      this->Known.atMost = std::max(this->Known.atMost, piece.bound);
    }
    else
    {
      this->refine(piece);
    }
  }
  this->Known.atMost = std::max(this->Known.atMost, this->Known.atLeast);
}

/// What a bound need not be less than.
double DeviationBounder::goal() const
{
  return std::max(this->Limit, this->Known.atLeast * kDeviationSpare);
}

/// The distance of the corners from a triangle, or infinity where it is more than the goal.
double DeviationBounder::boundBy(const ConvexPiece& shape, Index triangle) const
{
  const CornerPlaces t = cornerPlaces(this->To.mesh(), triangle);
  const double goal2 = this->goal() * this->goal();
  double most2 = 0.0;
  for (const Vec3& corner : shape.corners())
  {
    most2 = std::max(most2, squaredDistance(corner, t[0], t[1], t[2]));
    if (most2 > goal2)
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  return std::sqrt(most2);
}

/// @param origin tells how the piece was cut
void DeviationBounder::take(
  const ConvexPiece& shape, Index nearest, double middleDistance, const Piece& origin)
{
  const Vec3 middle = shape.middle();
  if (middleDistance > this->Known.atLeast)
  {
    this->Known.atLeast = middleDistance;
    this->Known.where = middle;
  }
  double bound = middleDistance + shape.radius(middle);
  if (bound > this->goal())
  {
    bound = std::min(bound, this->boundBy(shape, nearest));
  }
  if (bound <= this->goal())
  {
    this->Known.atMost = std::max(this->Known.atMost, bound);
    return;
  }
  this->Pieces.push_back({ shape, nearest, origin.cutAlong, origin.cuts, middleDistance, bound });
}

/// Looks at parts of a piece.
void DeviationBounder::refine(Piece& piece)
{
  if (!this->IsNear)
  {
    this->Near.moveTo(this->Around, this->goal());
    this->IsNear = true;
  }
  if (piece.cutAlong != piece.nearest && piece.cuts < kMostCuts && this->cut(piece))
  {
    piece.cutAlong = piece.nearest;
    ++piece.cuts;
  }
  else
  {
    this->Parts.clear();
    this->Parts.push_back(piece.shape.halve());
    this->Parts.push_back(piece.shape);
    piece.cuts = 0;
  }
  for (const ConvexPiece& part : this->Parts)
  {
    this->Budget -= this->Budget > 0 ? 1 : 0;
    const SurfacePlace place = this->Near.nearest(part.middle(), piece.nearest);
    this->take(part, place.triangle, std::sqrt(place.squaredDistance), piece);
  }
}

/// Parts a piece along the borders of its nearest triangle, moved out as far as the goal allows.
/// False where it is on one side.
bool DeviationBounder::cut(const Piece& piece)
{
  this->Parts.clear();
  ConvexPiece inside = piece.shape;
  if (inside.corners().size() + 3 > ConvexPiece::kMostCorners)
  {
    return false;
  }
  const CornerPlaces t = cornerPlaces(this->To.mesh(), piece.nearest);
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double slack2 = this->goal() * this->goal() - piece.middleDistance * piece.middleDistance;
  const double slack = kSlackUsed * std::sqrt(std::max(slack2, 0.0));
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 inwards = unitVector(cross(normal, t[(k + 1) % 3] - t[k]));
    const ConvexPiece outside = inside.cut(inwards, dot(inwards, t[k]) - slack);
    if (inside.corners().empty())
    {
      return false;
    }
    if (!outside.corners().empty())
    {
      this->Parts.push_back(outside);
    }
  }
  if (this->Parts.empty())
  {
    return false;
  }
  const double bound = this->boundBy(inside, piece.nearest);
  if (bound <= this->goal())
  {
    this->Known.atMost = std::max(this->Known.atMost, bound);
  }
  else
  {
    this->Parts.push_back(inside);
  }
  return true;
}

} // namespace scan
