// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <span>

namespace scan
{

/// A convex piece of a triangle.
class ConvexPiece
{
public:
  static constexpr std::size_t kMostCorners = 9;

  ConvexPiece() = default;
  explicit ConvexPiece(const std::array<Vec3, 3>& triangle);

  std::span<const Vec3> corners() const { return { this->Corners.data(), this->Count }; }

  /// The mean of the corners.
  Vec3 middle() const;
  /// How far the farthest corner is from a point.
  double radius(const Vec3& from) const;

  /// Keeps what is on the side of a plane that `inwards` points to, dot(inwards, p) >= offset, and
  /// returns the rest; either may be empty. There are fewer than kMostCorners corners.
  ConvexPiece cut(const Vec3& inwards, double offset);

  /// Keeps one half and returns the other: cuts from the middle of the longest side.
  ConvexPiece halve();

private:
  void add(const Vec3& corner) { this->Corners[this->Count++] = corner; }

  std::array<Vec3, kMostCorners> Corners;
  std::size_t Count = 0;
};

} // namespace scan
