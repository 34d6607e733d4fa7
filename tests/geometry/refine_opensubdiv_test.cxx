// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/neighbours.h"
#include "tests/geometry/refine_fixtures.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

namespace scan::test
{
namespace
{

namespace far = OpenSubdiv::Far;

/// A point as OpenSubdiv mixes it.
struct Mixed : Vec3
{
  void Clear(void* = nullptr) { *this = {}; }
  void AddWithWeight(const Mixed& other, double weight)
  {
    static_cast<Vec3&>(*this) = *this + other * weight;
  }
};

/// The ends of the edges where triangles face apart by more, two by two.
std::vector<int> creaseEnds(const TriMesh& mesh, double degrees)
{
  const EdgePairs pairs = pairEdges(mesh);
  std::vector<int> ends;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    const Index mate = pairs.mate[half];
    if (mate != kNone && half < mate &&
      largestBend({ mesh.points, { mesh.triangles[half / 3], mesh.triangles[mate / 3] } }) >
        degrees * std::numbers::pi / 180.0)
    {
      ends.push_back(static_cast<int>(originOf(mesh, half)));
      ends.push_back(static_cast<int>(originOf(mesh, nextHalf(half))));
    }
  }
  return ends;
}

/// The points of OpenSubdiv's last level.
std::vector<Vec3> openSubdiv(const TriMesh& mesh, int levels, const std::vector<int>& creases)
{
  using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
  std::vector<int> corners;
  for (const Triangle& t : mesh.triangles)
  {
    corners.insert(corners.end(), t.begin(), t.end());
  }
  const std::vector<int> sizes(mesh.triangles.size(), 3);
  const std::vector<float> weights(creases.size() / 2, OpenSubdiv::Sdc::Crease::SHARPNESS_INFINITE);
  far::TopologyDescriptor topology;
  topology.numVertices = static_cast<int>(mesh.points.size());
  topology.numFaces = static_cast<int>(sizes.size());
  topology.numVertsPerFace = sizes.data();
  topology.vertIndicesPerFace = corners.data();
  topology.numCreases = static_cast<int>(weights.size());
  topology.creaseVertexIndexPairs = creases.data();
  topology.creaseWeights = weights.data();
  OpenSubdiv::Sdc::Options rules;
  rules.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  const std::unique_ptr<far::TopologyRefiner> refiner(
    Factory::Create(topology, Factory::Options(OpenSubdiv::Sdc::SCHEME_LOOP, rules)));
  refiner->RefineUniform(far::TopologyRefiner::UniformOptions(levels));
  std::vector<Mixed> points(mesh.points.size());
  std::ranges::transform(mesh.points, points.begin(), [](const Vec3& p) { return Mixed{ p }; });
  for (int level = 1; level <= levels; ++level)
  {
    std::vector<Mixed> next(refiner->GetLevel(level).GetNumVertices());
    far::PrimvarRefinerReal<double>(*refiner).Interpolate(level, points, next);
    points.swap(next);
  }
  return { points.begin(), points.end() };
}

/// How far the farthest of the points is from the nearest of the others.
double distanceBetween(const std::vector<Vec3>& points, const std::vector<Vec3>& others)
{
  Execution execution(1);
  const Neighbours places(others, execution);
  std::vector<Neighbour> found;
  double largest = 0.0;
  for (const Vec3& p : points)
  {
    places.nearest(p, 1, found);
    largest = std::max(largest, found[0].squaredDistance);
  }
  return std::sqrt(largest);
}

/// Open and closed ones, with 3 to 40 neighbours a point, with and without creases.
TEST(RefineLoop, IsWhatOpenSubdivMakes)
{
  double worst = 0.0;
  for (const auto& [name, mesh] : manifolds())
  {
    for (const double angle : { 180.0, 60.0, 25.0 })
    {
      const std::vector<int> creases = creaseEnds(mesh, angle);
      for (const int times : { 1, 2, 3 })
      {
        const std::vector<Vec3> theirs = openSubdiv(mesh, times, creases);
        const std::vector<Vec3> ours =
          refined(mesh, { .times = times, .creaseAngle = angle }, allOf(mesh)).edit.mesh.points;
        ASSERT_EQ(ours.size(), theirs.size()) << name;
        const double distance =
          std::max(distanceBetween(ours, theirs), distanceBetween(theirs, ours));
        EXPECT_LT(distance, 1e-12) << name << ", creases " << angle << ", " << times << " times";
        worst = std::max(worst, distance);
      }
    }
  }
  std::cout << "largest distance from OpenSubdiv " << worst << "\n";
}

} // namespace
} // namespace scan::test
