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
constexpr int kMostCuts = 16; // without a halving between them: they may take off next to nothing
constexpr double kRoomUsed = 0.1; // of the goal: by what borders are moved out

} // namespace

DeviationBounds DeviationBounder::bound(const CornerPlaces& triangle, Index nearest,
  double middleDistance, const DeviationBounds& known, double limit)
{
  this->start(triangle, limit, kDeviationSpare);
  this->Known = known;
  this->take({ ConvexPiece(triangle), nearest, true }, middleDistance);
  this->refineAll(false);
  return this->Known;
}

bool DeviationBounder::isWithin(
  const CornerPlaces& triangle, Index nearest, double middleDistance, double limit)
{
  this->start(triangle, limit, 0.0);
  this->Known = {};
  this->take({ ConvexPiece(triangle), nearest, true }, middleDistance);
  this->refineAll(true);
  return this->Known.atMost <= limit;
}

/// @param spare how far the bound may be above what was found: times this
void DeviationBounder::start(const CornerPlaces& triangle, double limit, double spare)
{
  this->Spare = spare;
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
  return std::max(this->Limit, this->Known.atLeast * this->Spare);
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

/// Keeps a piece, whose triangle is the nearest to its middle, if its bound is above the goal.
void DeviationBounder::take(Piece piece, double middleDistance)
{
  const Vec3 middle = piece.shape.middle();
  if (middleDistance > this->Known.atLeast)
  {
    this->Known.atLeast = middleDistance;
    this->Known.where = middle;
  }
  piece.bound = std::min(piece.bound, middleDistance + piece.shape.radius(middle));
  if (piece.bound > this->goal())
  {
    piece.bound = std::min(piece.bound, this->boundBy(piece.shape, piece.triangle));
  }
  if (piece.bound <= this->goal())
  {
    this->Known.atMost = std::max(this->Known.atMost, piece.bound);
    return;
  }
  this->Pieces.push_back(piece);
}

/// Finds the nearest triangle for a piece.
void DeviationBounder::look(Piece piece)
{
  if (!this->IsNear)
  {
    this->Near.moveTo(this->Around, this->goal());
    this->IsNear = true;
  }
  this->Budget -= this->Budget > 0 ? 1 : 0;
  const SurfacePlace place = this->Near.nearest(piece.shape.middle(), piece.triangle);
  piece.triangle = place.triangle;
  piece.isNearest = true;
  this->take(piece, std::sqrt(place.squaredDistance));
}

/// Takes a part of a piece whose nearest triangle is probably that over the border.
void DeviationBounder::tryNeighbour(const Part& part, Piece origin)
{
  origin.shape = part.shape;
  if (part.neighbour == kNone)
  {
    this->look(origin);
    return;
  }
  const double bound = this->boundBy(part.shape, part.neighbour);
  if (bound <= this->goal())
  {
    this->Known.atMost = std::max(this->Known.atMost, bound);
    return;
  }
  origin.triangle = part.neighbour;
  origin.isNearest = false;
  this->Pieces.push_back(origin);
}

/// Makes parts of a piece and takes them.
void DeviationBounder::refine(Piece& piece)
{
  this->Budget -= this->Budget > 0 ? 1 : 0;
  if (piece.cutAlong != piece.triangle && piece.cuts < kMostCuts && this->cut(piece))
  {
    piece.cutAlong = piece.triangle;
    ++piece.cuts;
    for (const Part& part : this->Parts)
    {
      this->tryNeighbour(part, piece);
    }
    return;
  }
  if (!piece.isNearest)
  {
    this->look(piece);
    return;
  }
  piece.cuts = 0;
  Piece half = piece;
  half.shape = piece.shape.halve();
  this->look(half);
  this->look(piece);
}

Index DeviationBounder::neighbour(Index triangle, std::size_t side) const
{
  const Index mate = this->Mates.empty() ? kNone : this->Mates[3 * triangle + side];
  return mate == kNone ? kNone : mate / 3;
}

/// Parts a piece along the borders of its triangle, moved out as far as the goal allows. False
/// where it is on one side, or where the triangle is a guess and does not bound what is inside.
bool DeviationBounder::cut(const Piece& piece)
{
  this->Parts.clear();
  ConvexPiece inside = piece.shape;
  if (inside.corners().size() + 3 > ConvexPiece::kMostCorners)
  {
    return false;
  }
  const CornerPlaces t = cornerPlaces(this->To.mesh(), piece.triangle);
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double room = kRoomUsed * this->goal();
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 inwards = unitVector(cross(normal, t[(k + 1) % 3] - t[k]));
    const ConvexPiece outside = inside.cut(inwards, dot(inwards, t[k]) - room);
    if (inside.corners().empty())
    {
      return false;
    }
    if (!outside.corners().empty())
    {
      this->Parts.push_back({ outside, this->neighbour(piece.triangle, k) });
    }
  }
  if (this->Parts.empty())
  {
    return false;
  }
  const double bound = this->boundBy(inside, piece.triangle);
  if (bound <= this->goal())
  {
    this->Known.atMost = std::max(this->Known.atMost, bound);
    return true;
  }
  this->Parts.push_back({ inside, kNone });
  return piece.isNearest;
}

} // namespace scan
