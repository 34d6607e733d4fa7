// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <vector>

namespace scan::test
{

/// Whether CGAL finds a self-intersection, too; fails where it finds no manifold.
inline bool intersectsItself(const TriMesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  CGAL::Surface_mesh<Kernel::Point_3> other;
  std::vector<CGAL::SM_Vertex_index> vertices;
  for (const Vec3& p : mesh.points)
  {
    vertices.push_back(other.add_vertex({ p.x, p.y, p.z }));
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    EXPECT_NE(other.add_face(vertices[a], vertices[b], vertices[c]), other.null_face())
      << "no manifold";
  }
  return CGAL::Polygon_mesh_processing::does_self_intersect(other);
}

} // namespace scan::test
