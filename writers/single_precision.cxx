// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/single_precision.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace scan
{
namespace
{

double largest(const Vec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

} // namespace

[[gnu::noinline]] std::array<float, 3> asFloats(const Vec3& point)
{
  return { static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z) };
}

Vec3 roundedToFloat(const Vec3& point)
{
  const auto [x, y, z] = asFloats(point);
  return { x, y, z };
}

void requireFloatRange(const TriMesh& mesh, const std::string& file, const std::string& format)
{
  const auto fits = [](double value)
  { return std::abs(value) <= std::numeric_limits<float>::max(); };
  if (!std::all_of(mesh.points.begin(), mesh.points.end(),
        [&](const Vec3& p) { return fits(p.x) && fits(p.y) && fits(p.z); }))
  {
    throw Error(ErrorCode::limit,
      file + ": a coordinate exceeds 3.4e38, the limit of " + format + "; write PLY or OBJ");
  }
}

Vec3 originForFloats(const std::vector<Vec3>& points)
{
  const BoundingBox box(points);
  const bool isFar = std::max(largest(box.low), largest(box.high)) > largest(box.high - box.low);
  const auto isFloat = [](const Vec3& p) { return roundedToFloat(p) == p; };
  return isFar && !std::ranges::all_of(points, isFloat) ? (box.low + box.high) * 0.5 : Vec3{};
}

std::vector<Vec3> roundedToFloat(const std::vector<Vec3>& points, const Vec3& origin)
{
  std::vector<Vec3> result(points.size());
  std::ranges::transform(
    points, result.begin(), [&](const Vec3& point) { return roundedToFloat(point - origin); });
  return result;
}

std::string noteOnRounding(const std::vector<Vec3>& points)
{
  constexpr double kNoteworthy = 1e-6; // of the size
  double most = 0.0;
  for (const Vec3& point : points)
  {
    const Vec3 change = roundedToFloat(point) - point;
    most = std::max(most, dot(change, change));
  }
  most = std::sqrt(most);
  const double size = BoundingBox(points).diagonal();
  if (!(most > kNoteworthy * size) || !std::isfinite(most))
  {
    return {};
  }
  std::array<char, 32> digits = {};
  char* const end =
    std::to_chars(digits.begin(), digits.end(), most, std::chars_format::general, 2).ptr;
  return "the format holds 7 digits, so that points of this model, which is far from the origin, "
         "move by up to " +
    std::string(digits.data(), end) + "; write PLY, OBJ or ascii STL to keep them";
}

} // namespace scan
