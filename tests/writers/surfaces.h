// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/consistent_surface.h"
#include "tests/writers/models.h"

#include <utility>

/// Surfaces that are not what files should hold.
namespace scan::test
{

/// Three sheets of two triangles that meet in one edge.
inline TriMesh threeSheetsOnOneEdge()
{
  TriMesh mesh;
  mesh.points = { { 0, 0, 0 }, { 0, 0, 1 } };
  for (const auto& [x, y] : { std::pair{ 1.0, 0.0 }, { -1.0, 1.0 }, { -1.0, -1.0 } })
  {
    const auto first = static_cast<Index>(mesh.points.size());
    mesh.points.push_back({ x, y, 0 });
    mesh.points.push_back({ x, y, 1 });
    mesh.triangles.push_back({ 0, first, first + 1 });
    mesh.triangles.push_back({ 0, first + 1, 1 });
  }
  return mesh;
}

/// The surface as it should be in a file.
inline TriMesh mended(const TriMesh& mesh)
{
  Execution execution;
  return makeConsistent(mesh, 0.0, execution).mesh;
}

struct DamagedSurface
{
  TriMesh mesh;
  TriMesh mended; ///< what it should become: written down, not computed
};

/// A closed grid that faces inwards, with some triangles turned over, some that name a point twice,
/// and one cut at the middle of an edge where its neighbour is not, with a flat triangle between.
inline DamagedSurface damagedGrid()
{
  const TriMesh good = grid(20, 16, true);
  DamagedSurface result{ good, good };
  std::vector<Triangle>& triangles = result.mesh.triangles;
  const auto middle = static_cast<Index>(good.points.size());
  const auto [a, b, c] = good.triangles[100]; // cut at the middle of a b
  const Vec3 p = (good.points[a] + good.points[b]) * 0.5;
  result.mesh.points.push_back(p);
  result.mended.points.push_back(p);
  triangles[100] = { a, middle, c };
  triangles.push_back({ middle, b, c });
  triangles.push_back({ a, b, middle }); // flat
  result.mended.triangles[100] = { a, middle, c };
  result.mended.triangles.push_back({ middle, b, c });
  for (std::size_t t = 0; t < good.triangles.size(); ++t) // the neighbour at the edge b a
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Triangle n = good.triangles[t];
      if (n[k] == b && n[(k + 1) % 3] == a)
      {
        result.mended.triangles[t] = { b, middle, n[(k + 2) % 3] };
        result.mended.triangles.push_back({ middle, a, n[(k + 2) % 3] });
      }
    }
  }
  triangles.push_back({ 7, 7, 9 });
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    if (t % 5 != 0) // inwards, most of them
    {
      std::swap(triangles[t][1], triangles[t][2]);
    }
  }
  return result;
}

} // namespace scan::test
