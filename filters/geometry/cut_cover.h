// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <algorithm>
#include <vector>

namespace scan
{

/// Counts the cut triangles at every point: a point is covered when it has one.
class CutCover
{
public:
  explicit CutCover(std::size_t pointCount)
    : CutTriangles(pointCount, 0)
  {
  }

  std::size_t pointCount() const { return this->CutTriangles.size(); }
  int cutTriangles(Index point) const { return this->CutTriangles[point]; }

  bool coversAll() const
  {
    return std::find(this->CutTriangles.begin(), this->CutTriangles.end(), 0) ==
      this->CutTriangles.end();
  }

  /// Adds `change` cut triangles at a point; returns the change in covered points.
  int count(Index point, int change)
  {
    const int before = this->CutTriangles[point];
    this->CutTriangles[point] = before + change;
    return (before + change > 0) - (before > 0);
  }

  /// Takes a triangle into the cut (sign +1) or out of it (-1); returns the change in covered
  /// points.
  int count(const Triangle& triangle, int sign)
  {
    return this->count(triangle[0], sign) + this->count(triangle[1], sign) +
      this->count(triangle[2], sign);
  }

private:
  std::vector<int> CutTriangles;
};

} // namespace scan
