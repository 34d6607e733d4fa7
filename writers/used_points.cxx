// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/used_points.h"

#include "filters/geometry/flat_triangles.h"

namespace scan
{

std::vector<bool> usedPoints(
  const std::vector<Triangle>& triangles, const Polylines& curves, std::size_t pointCount)
{
  std::vector<bool> isUsed(pointCount);
  for (const Triangle& triangle : triangles)
  {
    for (const Index corner : triangle)
    {
      isUsed[corner] = true;
    }
  }
  for (const Index corner : curves.corners)
  {
    isUsed[corner] = true;
  }
  return isUsed;
}

std::vector<Vec3> shapePoints(const Model& model)
{
  if (model.isScan())
  {
    return model.points;
  }
  const std::vector<Vec3>& points = model.points;
  std::vector<Triangle> triangles = model.triangles;
  std::erase_if(
    triangles, [&](const Triangle& t) { return isFlat(points[t[0]], points[t[1]], points[t[2]]); });
  const std::vector<bool> isUsed = usedPoints(triangles, model.curves, points.size());
  std::vector<Vec3> shape;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isUsed[i])
    {
      shape.push_back(points[i]);
    }
  }
  return shape;
}

} // namespace scan
