// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "readers/source.h"

#include <cmath>
#include <cstddef>

namespace scan
{

/// Counts points that no operation could work with, so that a reader can refuse them all at once.
class CoordinateCheck
{
public:
  /// The largest usable coordinate: products of three still fit a double with room to spare.
  static constexpr double kLargest = 1e50;

  /// @param at where the point stands in the file
  void see(const Vec3& point, const char* at)
  {
    const bool isUsable = std::abs(point.x) <= kLargest && std::abs(point.y) <= kLargest &&
      std::abs(point.z) <= kLargest; // false for NaN
    if (!isUsable)
    {
      this->First = this->Count++ == 0 ? at : this->First;
    }
  }

  /// Adds the points of a later part of the file.
  void append(const CoordinateCheck& later);

  enum class Place
  {
    line,
    byte
  };

  /// Throws Error parse with the count and the first place when a point was unusable.
  void finish(const Source& source, std::size_t total, Place place) const;

private:
  std::size_t Count = 0;
  const char* First = nullptr;
};

} // namespace scan
