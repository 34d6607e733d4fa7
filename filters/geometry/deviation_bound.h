// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/convex_piece.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/triangle_tree.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace scan
{

/// What is known of the distances of a triangle's points from a surface.
struct DeviationBounds
{
  double atLeast = 0.0; ///< the largest that was found
  double atMost = 0.0;  ///< of all points
  Vec3 where;           ///< the point where the largest was found
};

/// How far a bound may be above what was found: times this.
inline constexpr double kDeviationSpare = 1.01;

/// Bounds how far the points of a triangle are from a surface. The distance from a convex set is
/// convex: the distance of a convex piece from one triangle of the surface is largest at corners of
/// the piece. Where that is too much, the piece is cut along the borders of the surface's triangle
/// that is nearest to its middle, and the parts beyond them are tried on its neighbours. Compare
/// Tang, Lee, Kim, "Interactive Hausdorff distance computation for general polygonal models"
/// (2009), who bound pieces the same way but halve them. For use on one thread.
class DeviationBounder
{
public:
  /// @param mates of the half-edges of the surface, see EdgePairs; empty: does without, slower
  DeviationBounder(const TriangleTree& to, std::span<const Index> mates)
    : To(to)
    , Mates(mates)
    , Near(to)
  {
  }

  /// Bounds that are less than a hundredth apart, or at most `limit`, or the best within a
  /// reasonable time.
  /// @param nearest the triangle nearest to the middle of the corners, whose distance is
  ///   `middleDistance`
  /// @param known distances that were found
  DeviationBounds bound(const CornerPlaces& triangle, Index nearest, double middleDistance,
    const DeviationBounds& known, double limit);

  /// Whether all points are within the limit, as far as that is found in a reasonable time.
  bool isWithin(const CornerPlaces& triangle, Index nearest, double middleDistance, double limit);

private:
  /// A piece whose bound is above the goal.
  struct Piece
  {
    ConvexPiece shape;
    Index triangle = kNone; // of the surface, the nearest to the middle or one that may be
    bool isNearest = false;
    double bound = std::numeric_limits<double>::infinity();
    int cuts = 0;           // since it was halved
    Index cutAlong = kNone; // the last triangle along whose borders it was cut
  };

  /// A piece beyond a border of a triangle.
  struct Part
  {
    ConvexPiece shape;
    Index neighbour = kNone; // over the border
  };

  void start(const CornerPlaces& triangle, double limit, double spare);
  void refineAll(bool stopsBeyond);
  double goal() const;
  double boundBy(const ConvexPiece& shape, Index triangle) const;
  void take(Piece piece, double middleDistance);
  void look(Piece piece);
  void tryNeighbour(const Part& part, Piece origin);
  void refine(Piece& piece);
  bool cut(const Piece& piece);
  Index neighbour(Index triangle, std::size_t side) const;

  const TriangleTree& To;
  std::span<const Index> Mates;
  TrianglesNear Near;
  Box Around;
  bool IsNear = false; // whether Near is around the triangle
  double Limit = 0.0;
  double Spare = 0.0;
  std::size_t Budget = 0; // pieces that may still be looked at
  DeviationBounds Known;
  std::vector<Piece> Pieces;
  std::vector<Part> Parts;
};

} // namespace scan
