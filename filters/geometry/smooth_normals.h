// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/float4.h"
#include "filters/geometry/point_links.h"

#include <cstdint>
#include <span>

namespace scan
{

/// Points of a surface and what is around them.
struct NormalSurface
{
  std::span<const Triangle> triangles;
  const PointLists& trianglesOfPoints;
  const PointLists& neighbours;          ///< per point; points without keep their own normal
  std::span<const std::uint8_t> isSharp; ///< per point 1 where no plane touches the surface
};

/// Unit normals of a noisy surface at its points, each from a wide neighbourhood; (0, 0, 0) at
/// sharp points, and where nothing is known.
///
/// Vectors of areas, which cancel the noise inside a neighbourhood, are averaged over it, and so
/// are the places. Such a mean is the normal at the mean place, on triangles of many sizes far from
/// the point: there the surface has turned. How it turns, its shape operator, is fitted to the
/// means of the neighbours, and leads back to the point.
class SmoothNormals
{
public:
  explicit SmoothNormals(const NormalSurface& surface);

  /// Computes them anew from where the points are.
  void compute(const LargeArray<Float4>& places, Execution& execution);
  const Float4& of(std::size_t point) const { return this->Normals[point]; }

private:
  /// A mean over a neighbourhood that grows.
  struct Mean
  {
    Float4 area;  ///< vector; once averaged, of length 1
    Float4 place; ///< times its weight, the last number; once averaged, alone
  };

  Float4 areaVector(const LargeArray<Float4>& places, std::size_t point) const;
  void average(Execution& execution);
  Float4 normalAt(const Float4& place, std::size_t point) const;

  NormalSurface Surface;
  std::size_t Count;
  LargeArray<Mean> Means;
  LargeArray<Mean> Next;
  LargeArray<Float4> Normals;
};

} // namespace scan
