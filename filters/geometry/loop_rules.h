// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/refine_plan.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// Per triangle a bit for each edge, corner k to k + 1, where two triangles face apart by more than
/// the angle. Triangles without area make none. Empty for an angle of 180 degrees.
std::vector<std::uint8_t> creasesOf(
  const TriMesh& mesh, const EdgeFans& fans, double degrees, Execution& execution);

/// The rules of Loop (1987), with creases by Hoppe et al. (1994) as OpenSubdiv has them, in the
/// part of a mesh that is chosen; elsewhere points stay and middles are middles.
class LoopRules
{
public:
  /// @param isChosen per triangle 0 or 1
  /// @param creases of creasesOf()
  LoopRules(const TriMesh& mesh, const EdgeFans& fans, std::span<const std::uint8_t> isChosen,
    std::span<const std::uint8_t> creases);

  /// Where a point goes.
  Vec3 pointAt(Index point) const;

  /// Where the new point of an edge goes.
  Vec3 middleAt(Index half) const;

private:
  struct Ring;
  /// What is known of a point.
  struct Corner
  {
    Index half = kNone;  ///< from the point
    Index triangles = 0; ///< kNone: it stays
  };

  bool isCrease(Index half) const
  {
    return !this->Creases.empty() && ((this->Creases[half / 3] >> (half % 3)) & 1U) != 0;
  }
  bool turn(Index point, Index half, Index neighbour, Ring& ring) const;
  Ring ringOf(Index point) const;

  const TriMesh& Mesh;
  const EdgeFans& Fans;
  std::span<const std::uint8_t> IsChosen;
  std::span<const std::uint8_t> Creases;
  std::vector<Corner> Corners;
};

} // namespace scan
