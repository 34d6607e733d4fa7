// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstddef>
#include <vector>

namespace scan
{

/// A run of consecutive triangles and how many points they use.
struct MeshPart
{
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t pointCount = 0;
};

/// Numbers the points of one part after another from 0, in the order of their use.
class PartNumbering
{
public:
  explicit PartNumbering(const TriMesh& mesh);

  /// Starts a part without points.
  void startPart();

  /// The number of a point in the part, which it joins if it is not there.
  Index numberOf(Index point);

  /// How many of the corners are not yet in the part.
  std::size_t newPoints(const Triangle& triangle) const;

  /// The model's indices of the part's points, by their number.
  const std::vector<Index>& points() const { return this->Points; }

private:
  bool has(Index point) const;

  std::vector<Index> Points;
  std::vector<Index> Numbers; // per point of the mesh; valid when Points agrees
};

/// Cuts the triangles into runs that use at most maxPoints points and have at most maxTriangles
/// triangles; points of borders belong to both sides, points without a triangle to none.
/// @param maxPoints at least 3
/// @param maxTriangles at least 1
/// Throws Cancelled.
std::vector<MeshPart> splitIntoParts(
  const TriMesh& mesh, std::size_t maxPoints, std::size_t maxTriangles, Execution& execution);

} // namespace scan
