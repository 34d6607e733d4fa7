// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// The vector that begins at a place among numbers.
inline Vec3 vectorAt(std::span<const double> numbers, std::size_t place)
{
  return { numbers[place], numbers[place + 1], numbers[place + 2] };
}

/// How a rule of a region looks at the model, as it is written: a name and its numbers.
struct RegionView
{
  std::string name = "front";  ///< of kViewSides, or "from", "along"
  std::vector<double> numbers; ///< of from: eye, target, up; of along: direction, up

  friend bool operator==(const RegionView&, const RegionView&) = default;
};

/// How many numbers a view of that name takes; none for a name that no view has.
std::optional<std::size_t> viewNumbers(std::string_view name);

/// A place on the screen: x to the right and y up, in model units.
struct ScreenPoint
{
  double x = 0.0;
  double y = 0.0;
};

/// What a view shows where. Parallel views measure from the origin, a perspective from the target,
/// on the plane through it that is parallel to the screen.
class Screen
{
public:
  /// @throws Error{badParameter} for directions that are zero or parallel
  explicit Screen(const RegionView& view);

  /// Where a point is seen; nowhere when it is not before the eye.
  std::optional<ScreenPoint> project(const Vec3& point) const;

  /// How much nearer to the eye one point is than another, across the screen.
  double nearer(const Vec3& point, const Vec3& than) const;

private:
  void aim(const Vec3& towards, const Vec3& up);

  Vec3 Right;
  Vec3 Up;
  Vec3 Back; ///< to the eye
  Vec3 Eye;
  double Distance = 0.0; ///< of the target from the eye; 0 for parallel views
};

} // namespace scan
