// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>
#include <numbers>

/// Tiny meshes with telling names; closed ones face outwards.
namespace corpus
{

using scan::Index;
using scan::TriMesh;

/// Edges of length sqrt(2), volume 1/3.
inline TriMesh tetrahedron()
{
  return { { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } } };
}

/// Adds a tetrahedron of a size about a point; hollow: facing inwards.
inline void addTetrahedron(
  TriMesh& mesh, double size, const scan::Vec3& centre, bool isHollow = false)
{
  const TriMesh piece = tetrahedron();
  const auto first = static_cast<Index>(mesh.points.size());
  for (const scan::Vec3& p : piece.points)
  {
    mesh.points.push_back((p - scan::Vec3{ 0.5, 0.5, 0.5 }) * size + centre);
  }
  for (const auto& [a, b, c] : piece.triangles)
  {
    mesh.triangles.push_back(isHollow ? scan::Triangle{ first + a, first + c, first + b }
                                      : scan::Triangle{ first + a, first + b, first + c });
  }
}

/// Two triangles of a unit square.
inline TriMesh square()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 3 } } };
}

/// Two tetrahedra, opposite each other, that share the edge 0-1.
inline TriMesh tetrahedraOnOneEdge()
{
  return { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } },
    { { 0, 3, 2 }, { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, //
      { 0, 5, 4 }, { 0, 4, 1 }, { 0, 1, 5 }, { 1, 4, 5 } } };
}

/// Two tetrahedra that share point 0 only.
inline TriMesh tetrahedraOnOnePoint()
{
  return { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { -1, 0, 0 }, { 0, -1, 0 },
             { 0, 0, -1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 }, //
      { 0, 4, 5 }, { 0, 6, 4 }, { 0, 5, 6 }, { 4, 6, 5 } } };
}

/// A strip of five triangles closed with a half twist.
inline TriMesh moebius()
{
  TriMesh mesh;
  for (int i = 0; i < 5; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / 5.0;
    mesh.points.push_back({ std::cos(angle), std::sin(angle), i % 2 == 0 ? 0.2 : -0.2 });
  }
  for (Index i = 0; i < 5; ++i)
  {
    const Index a = i;
    const Index b = (i + 1) % 5;
    const Index c = (i + 2) % 5;
    mesh.triangles.push_back(i % 2 == 0 ? scan::Triangle{ a, b, c } : scan::Triangle{ b, a, c });
  }
  return mesh;
}

/// n × n quads, radii 2 and 1, split in two triangles each.
inline TriMesh torus(Index n)
{
  TriMesh mesh;
  for (Index i = 0; i < n; ++i)
  {
    for (Index j = 0; j < n; ++j)
    {
      const double u = 2.0 * std::numbers::pi * i / n;
      const double v = 2.0 * std::numbers::pi * j / n;
      const double r = 2.0 + std::cos(v);
      mesh.points.push_back({ r * std::cos(u), r * std::sin(u), std::sin(v) });
      const auto at = [&](Index a, Index b) { return (a % n) * n + b % n; };
      mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

/// The border of the union of the unit cubes of an n × n × n grid that `isSolid(i, j, k)` picks;
/// it touches itself along edges and at corners as it pleases.
template <typename IsSolid>
TriMesh voxelBorder(Index n, IsSolid&& isSolid)
{
  TriMesh mesh;
  const Index row = n + 1;
  for (Index k = 0; k <= n; ++k)
  {
    for (Index j = 0; j <= n; ++j)
    {
      for (Index i = 0; i <= n; ++i)
      {
        mesh.points.push_back({ double(i), double(j), double(k) });
      }
    }
  }
  const std::array<Index, 3> stride = { 1, row, row * row };
  for (Index cell = 0; cell < n * n * n; ++cell)
  {
    const std::array<Index, 3> at = { cell % n, cell / n % n, cell / n / n };
    if (!isSolid(at[0], at[1], at[2]))
    {
      continue;
    }
    const Index base = at[0] + at[1] * row + at[2] * row * row;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const bool upper : { false, true })
      {
        std::array<Index, 3> next = at;
        next[axis] += upper ? 1 : ~Index{ 0 }; // below 0 wraps to a number above n
        if (next[axis] < n && isSolid(next[0], next[1], next[2]))
        {
          continue;
        }
        const Index u = stride[(axis + 1) % 3];
        const Index v = stride[(axis + 2) % 3];
        const Index a = base + (upper ? stride[axis] : 0);
        const std::array<Index, 4> quad = { a, a + u, a + u + v, a + v };
        const Index second = upper ? 1 : 3;
        mesh.triangles.push_back({ quad[0], quad[second], quad[2] });
        mesh.triangles.push_back({ quad[0], quad[2], quad[4 - second] });
      }
    }
  }
  return mesh;
}

} // namespace corpus
