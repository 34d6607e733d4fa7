// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/random.h"
#include "filters/geometry/refine.h"

#include <cstdint>
#include <string>
#include <vector>

namespace scan::test
{

struct NamedMesh
{
  std::string name;
  TriMesh mesh;
};

/// Twenty oriented manifolds: closed and open ones, of several genera, with many and few
/// neighbours a point, even and random ones.
std::vector<NamedMesh> manifolds();

/// What is no oriented manifold: edges and points where more meets, a twist, doubled and collapsed
/// triangles, triangles without area.
std::vector<NamedMesh> awkwardMeshes();

/// Two cones of n triangles each, tip to tip by their rims.
TriMesh bipyramid(Index n);

/// n x n squares of a height field, each cut in two.
TriMesh monkeySaddle(Index n);

/// A region of all triangles.
inline std::vector<std::uint8_t> allOf(const TriMesh& mesh)
{
  return std::vector<std::uint8_t>(mesh.triangles.size(), 1);
}

/// Random balls of triangles, or single ones here and there.
std::vector<std::uint8_t> randomRegion(const TriMesh& mesh, Random& random);

RefineResult refined(const TriMesh& mesh, const RefineOptions& options,
  const std::vector<std::uint8_t>& isChosen, const std::vector<std::uint8_t>& halves = {},
  unsigned threads = 2);

/// Radians.
double smallestAngle(const TriMesh& mesh);

/// The largest angle between the normals of two triangles that share an edge, in radians.
double largestBend(const TriMesh& mesh);

} // namespace scan::test
