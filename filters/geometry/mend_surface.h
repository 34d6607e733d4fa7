// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/surface_edit.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

struct ConsistentSurface;

/// A surface in the course of its repair. Points are only added, behind the others, so that those
/// of the input keep their numbers until finish().
class MendSurface
{
public:
  /// @param isActive per triangle: whether its defects are to be repaired
  MendSurface(const TriMesh& input, std::vector<std::uint8_t> isActive);

  TriMesh mesh;
  std::vector<Index> pointOrigin;     ///< per point: of the input, kNone for a new one
  std::vector<PointBlend> blends;     ///< per point behind those of the input
  std::vector<Index> triangleOrigin;  ///< per triangle: of the input, kNone for a new one
  std::vector<std::uint8_t> isActive; ///< per triangle

  /// The triangle may be repaired further.
  void addTriangle(const Triangle& corners, Index origin);
  void addPoint(const Vec3& at, const PointBlend& blend);
  void removeTriangles(const std::vector<std::uint8_t>& isGone);

  /// Takes over what makeConsistent() made of the mesh.
  void become(ConsistentSurface&& surface);

  /// How far a point is from where it was; 0 for a new one.
  double shiftOf(Index point) const;

  /// Corners of a triangle of the input, weighted so that they make `at`, as near as it gets.
  PointBlend blendIn(Index triangle, const Vec3& at) const;

  /// What became of the input. Points that have lost all their triangles are left out.
  SurfaceEdit finish() const;

private:
  const TriMesh* Input; // so that states can be kept
};

} // namespace scan
