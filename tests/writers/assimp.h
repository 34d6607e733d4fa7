// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/readers/parsing.h"
#include "tests/readers/temporary_folder.h"

#include "filters/geometry/model.h"
#include "readers/ply.h"
#include "writers/output_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

namespace scan::test
{

/// Whether the program assimp (package assimp-utils), an independent reader, is there.
inline bool hasAssimp()
{
  return std::system("assimp version >/dev/null 2>&1") == 0;
}

/// What assimp reads from a file, in the coordinates of the file's root; empty on failure.
inline TriMesh readWithAssimp(const TemporaryFolder& folder, const std::string& path)
{
  const std::string ply = folder.file("assimp.ply");
  const std::string command = "assimp export " + path + " " + ply + " -fplyb -jiv -ptv >/dev/null";
  if (std::system(command.c_str()) != 0)
  {
    return {};
  }
  return parse(parsePly, contentOf(ply));
}

/// The volume that the triangles enclose.
inline double volumeOf(const TriMesh& mesh)
{
  double volume = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3& origin = mesh.points.front();
    const Vec3 u = mesh.points[a] - origin;
    volume += dot(u, cross(mesh.points[b] - origin, mesh.points[c] - origin)) / 6.0;
  }
  return volume;
}

struct Bounds
{
  Vec3 low;
  Vec3 high;
};

inline Bounds boundsOf(const TriMesh& mesh)
{
  Bounds bounds{ mesh.points.front(), mesh.points.front() };
  for (const Vec3& p : mesh.points)
  {
    bounds.low = { std::min(bounds.low.x, p.x), std::min(bounds.low.y, p.y),
      std::min(bounds.low.z, p.z) };
    bounds.high = { std::max(bounds.high.x, p.x), std::max(bounds.high.y, p.y),
      std::max(bounds.high.z, p.z) };
  }
  return bounds;
}

/// A closed torus of 2 n * n triangles, n > 2, about `centre`.
inline Model torus(Index n, const Vec3& centre)
{
  Model model;
  for (Index i = 0; i < n; ++i)
  {
    for (Index k = 0; k < n; ++k)
    {
      const double u = 2.0 * std::numbers::pi * i / n;
      const double v = 2.0 * std::numbers::pi * k / n;
      const double radius = 30.0 + 10.0 * std::cos(v);
      model.points.push_back(
        centre + Vec3{ radius * std::cos(u), radius * std::sin(u), 10.0 * std::sin(v) });
      const Index right = (i + 1) % n * n;
      const Index up = (k + 1) % n;
      model.triangles.push_back({ i * n + k, right + k, right + up });
      model.triangles.push_back({ i * n + k, right + up, i * n + up });
    }
  }
  return model;
}

/// The bytes of a model in a format.
/// @param write (model, file, execution)
template <class Write>
std::string bytesOfModel(const Write& write, const Model& model, unsigned threads = 1)
{
  const TemporaryFolder folder;
  Execution execution(threads);
  OutputFile file(folder.file("out"));
  write(model, file, execution);
  file.commit();
  return contentOf(folder.file("out"));
}

} // namespace scan::test
