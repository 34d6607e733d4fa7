// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/convex_piece.h"

#include <algorithm>
#include <cmath>

namespace scan
{

ConvexPiece::ConvexPiece(const std::array<Vec3, 3>& triangle)
  : Count(3)
{
  std::ranges::copy(triangle, this->Corners.begin());
}

Vec3 ConvexPiece::middle() const
{
  Vec3 sum;
  for (const Vec3& corner : this->corners())
  {
    sum = sum + corner;
  }
  return sum * (1.0 / static_cast<double>(this->Count));
}

double ConvexPiece::radius(const Vec3& from) const
{
  double most = 0.0;
  for (const Vec3& corner : this->corners())
  {
    most = std::max(most, dot(corner - from, corner - from));
  }
  return std::sqrt(most);
}

ConvexPiece ConvexPiece::cut(const Vec3& inwards, double offset)
{
  std::array<double, kMostCorners> height;
  double least = 0.0;
  double most = 0.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    height[i] = dot(inwards, this->Corners[i]) - offset;
    least = std::min(least, height[i]);
    most = std::max(most, height[i]);
  }
  if (least >= 0.0)
  {
    return {};
  }
  ConvexPiece outside;
  if (most <= 0.0)
  {
    std::swap(outside, *this);
    return outside;
  }
  ConvexPiece inside;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const std::size_t next = i + 1 < this->Count ? i + 1 : 0;
    const Vec3& corner = this->Corners[i];
    if (height[i] >= 0.0)
    {
      inside.add(corner);
    }
    if (height[i] <= 0.0)
    {
      outside.add(corner);
    }
    if ((height[i] < 0.0 && height[next] > 0.0) || (height[i] > 0.0 && height[next] < 0.0))
    {
      const double share = height[i] / (height[i] - height[next]);
      const Vec3 crossing = corner + (this->Corners[next] - corner) * share;
      inside.add(crossing);
      outside.add(crossing);
    }
  }
  *this = inside;
  return outside;
}

ConvexPiece ConvexPiece::halve()
{
  std::size_t longest = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Vec3 side = this->Corners[(i + 1) % this->Count] - this->Corners[i];
    if (dot(side, side) > most)
    {
      most = dot(side, side);
      longest = i;
    }
  }
  const auto at = [&](std::size_t i) { return this->Corners[(longest + i) % this->Count]; };
  const Vec3 halfway = (at(0) + at(1)) * 0.5;
  const std::size_t opposite = (this->Count + 2) / 2; // from there back to the middle
  ConvexPiece first;
  ConvexPiece second;
  first.add(halfway);
  for (std::size_t i = 1; i <= opposite; ++i)
  {
    first.add(at(i));
  }
  second.add(halfway);
  for (std::size_t i = opposite; i <= this->Count; ++i)
  {
    second.add(at(i));
  }
  *this = first;
  return second;
}

} // namespace scan
