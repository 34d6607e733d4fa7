// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/vertex_normals.h"

#include "filters/geometry/triangle_measures.h"

#include <algorithm>

namespace scan
{

std::vector<Vec3> vertexNormals(const TriMesh& mesh)
{
  std::vector<Vec3> normals(mesh.points.size());
  for (const Triangle& triangle : mesh.triangles)
  {
    const Vec3 normal = normalOf(mesh.points, triangle);
    for (std::size_t k = 0; k < 3; ++k)
    {
      normals[triangle[k]] = normals[triangle[k]] + normal * angleAt(mesh.points, triangle, k);
    }
  }
  std::ranges::transform(normals, normals.begin(), unitVector);
  return normals;
}

} // namespace scan
