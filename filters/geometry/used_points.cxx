// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/used_points.h"

#include <algorithm>

namespace scan
{

std::vector<Index> dropUnusedPoints(TriMesh& mesh)
{
  std::vector<Index> numbers(mesh.points.size(), kNone);
  for (const Triangle& t : mesh.triangles)
  {
    std::ranges::for_each(t, [&](Index point) { numbers[point] = 0; });
  }
  std::vector<Index> kept;
  std::vector<Vec3> points;
  for (Index i = 0; i < numbers.size(); ++i)
  {
    if (numbers[i] != kNone)
    {
      numbers[i] = static_cast<Index>(kept.size());
      kept.push_back(i);
      points.push_back(mesh.points[i]);
    }
  }
  for (Triangle& t : mesh.triangles)
  {
    std::ranges::for_each(t, [&](Index& point) { point = numbers[point]; });
  }
  mesh.points.swap(points);
  return kept;
}

} // namespace scan
