// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/view_framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scan
{
namespace
{

Vec3 normalized(const Vec3& v)
{
  return v * (1.0 / std::sqrt(dot(v, v)));
}

/// Smallest interval of the values that were added.
struct Range
{
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    this->low = std::min(this->low, value);
    this->high = std::max(this->high, value);
  }
  double middle() const { return 0.5 * (this->low + this->high); }
  double half() const { return 0.5 * (this->high - this->low); }
};

} // namespace

// In camera axes (x right, y up, z towards the camera) the camera at c sees a point when
//   |x - cx| <= tx (cz - z)  and  |y - cy| <= ty (cz - z).
// The two bounds for x say that cx + tx cz is at least the maximum of x + tx z and cx - tx cz at
// most the minimum of x - tx z: their middle is cx, half their distance tx cz.
ViewFrame frameView(std::span<const Vec3> points, const ViewOptions& options)
{
  const Vec3 back = normalized(options.towards);
  const Vec3 right = normalized(cross(options.up, back));
  const Vec3 up = cross(back, right);
  const double slopeY =
    (1.0 - options.margin) * std::tan(std::max(options.viewAngle, 0.0) * std::numbers::pi / 360.0);
  const double slopeX = slopeY * options.aspect;

  Range leftX, rightX, lowerY, upperY, depth;
  const Vec3 first = points.front(); // from here, so that coinciding points give plain zeros
  for (const Vec3& p : points)
  {
    const double x = dot(p - first, right);
    const double y = dot(p - first, up);
    const double z = dot(p - first, back);
    leftX.add(x - slopeX * z);
    rightX.add(x + slopeX * z);
    lowerY.add(y - slopeY * z);
    upperY.add(y + slopeY * z);
    depth.add(z);
  }
  const Range acrossX = { leftX.low, rightX.high };
  const Range acrossY = { lowerY.low, upperY.high };
  const double fitting = std::max(acrossX.half() / options.aspect, acrossY.half());

  ViewFrame frame;
  frame.up = up;
  double eye = 0.0;
  if (slopeY > 0.0)
  {
    eye = fitting / slopeY;
    // at least as far in front of the model as the model is deep: a line of sight has no width
    eye = std::max(eye, depth.high + depth.half());
    eye = eye > depth.high ? eye : depth.high + 1.0 / slopeY;
    frame.halfHeight = (eye - depth.middle()) * slopeY / (1.0 - options.margin);
  }
  else
  {
    frame.halfHeight = fitting > 0.0 ? fitting / (1.0 - options.margin) : 1.0;
    eye = depth.high + std::max(depth.half(), frame.halfHeight);
  }
  const Vec3 across = first + right * acrossX.middle() + up * acrossY.middle();
  frame.position = across + back * eye;
  frame.target = across + back * depth.middle();
  return frame;
}

} // namespace scan
