// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/vertex_normals.h"

#include "filters/geometry/local_plane.h"

#include <algorithm>
#include <cmath>

namespace scan
{

std::vector<Vec3> vertexNormals(const TriMesh& mesh)
{
  std::vector<Vec3> normals(mesh.points.size());
  for (const Triangle& triangle : mesh.triangles)
  {
    const auto corner = [&](std::size_t k) { return mesh.points[triangle[k % 3]]; };
    const Vec3 normal = unitVector(cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3 ahead = unitVector(corner(k + 1) - corner(k));
      const Vec3 back = unitVector(corner(k + 2) - corner(k));
      const double angle = std::acos(std::clamp(dot(ahead, back), -1.0, 1.0));
      normals[triangle[k]] = normals[triangle[k]] + normal * angle;
    }
  }
  std::ranges::transform(normals, normals.begin(), unitVector);
  return normals;
}

} // namespace scan
