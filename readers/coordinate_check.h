// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
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

  /// False for NaN.
  static bool isUsable(const Vec3& p)
  {
    return std::abs(p.x) <= kLargest && std::abs(p.y) <= kLargest && std::abs(p.z) <= kLargest;
  }

  /// @param at where the point stands in the file, if that is known
  void see(const Vec3& point, const char* at = nullptr)
  {
    if (!isUsable(point))
    {
      this->count(point, at);
    }
  }

  /// Adds the points of a later part of the file.
  void append(const CoordinateCheck& later);

  enum class Place
  {
    line,
    byte,
    unknown
  };

  /// Throws Error parse with the count and the first place when a point was unusable.
  void finish(const Source& source, std::size_t total, Place place) const;

  /// Drops the points of a scan that are not a number, which depth cameras write for pixels without
  /// depth, and notes how many; then as above. Throws Error parse when no point is left.
  void finish(const Source& source, Model& model, Place place) const;

private:
  void count(const Vec3& point, const char* at);

  std::size_t Count = 0;
  std::size_t Missing = 0; // not a number, and nothing else wrong
  const char* First = nullptr;
};

} // namespace scan
