// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/remesh.h"

#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/surface_deviation.h"
#include "tests/geometry/hole_fixtures.h"
#include "tests/geometry/mesh_corpus.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <set>

namespace scan::test
{
namespace
{

using Region = std::vector<std::uint8_t>;

Region allOf(const TriMesh& mesh)
{
  return Region(mesh.triangles.size(), 1);
}

template <class IsIn>
Region regionOf(const TriMesh& mesh, IsIn&& isIn)
{
  Region region;
  for (const Triangle& t : mesh.triangles)
  {
    region.push_back(isIn(centroidOf(mesh, t)) ? 1 : 0);
  }
  return region;
}

RemeshResult run(const TriMesh& mesh, const RemeshOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return remesh(mesh, allOf(mesh), options, execution);
}

double deviationBetween(const TriMesh& a, const TriMesh& b)
{
  Execution execution(1);
  const TriangleTree treeA(a, execution);
  const TriangleTree treeB(b, execution);
  return std::max(
    deviationFrom(a, treeB, execution).largest, deviationFrom(b, treeA, execution).largest);
}

/// As many pieces, rims and handles as before, no new defect.
void expectSameKind(const TriMesh& before, const RemeshResult& result)
{
  expectConsistent(result.edit);
  const MeshReport was = describeMesh(before);
  const MeshReport is = describeMesh(result.edit.mesh);
  EXPECT_EQ(is.isManifold, was.isManifold);
  EXPECT_EQ(is.isOriented, was.isOriented);
  EXPECT_EQ(is.genus, was.genus);
  EXPECT_EQ(is.boundaryLoops, was.boundaryLoops);
  EXPECT_EQ(is.components.size(), was.components.size());
  EXPECT_EQ(is.nonManifoldEdges, was.nonManifoldEdges);
  EXPECT_EQ(intersectionsOf(result.edit.mesh), intersectionsOf(before));
}

void tell(const std::string& name, const TriMesh& before, const RemeshResult& result)
{
  std::cout << name << ": " << before.triangles.size() << " -> "
            << result.edit.mesh.triangles.size()
            << ", edges within 4/5 to 4/3: " << result.goodEdges << ", least angle "
            << result.leastAngle << ", held back " << result.heldBack << ", deviation "
            << deviationBetween(before, result.edit.mesh) / result.edgeLength << " edges\n";
}

TEST(Remesh, MakesEdgesOfOneLength)
{
  for (const double factor : { 0.5, 1.0, 2.0 })
  {
    const TriMesh mesh = corpus::torus(40);
    const double edge = describeMesh(mesh).meanEdge * factor;
    const RemeshResult result = run(mesh, { .edgeLength = edge });
    tell("torus", mesh, result);
    expectSameKind(mesh, result);
    EXPECT_GT(result.goodEdges, 0.8);
    EXPECT_GT(result.leastAngle, 20.0);
    EXPECT_EQ(result.heldBack, 0U);
    EXPECT_EQ(result.edgeLength, edge);
  }
}

TEST(Remesh, TakesTheMeanEdgeByDefault)
{
  const TriMesh mesh = corpus::torus(40);
  EXPECT_NEAR(run(mesh).edgeLength, describeMesh(mesh).meanEdge, 1e-12);
}

TEST(Remesh, LeavesTheRestBitForBit)
{
  const TriMesh mesh = corpus::torus(40);
  for (const double edge : { 0.05, 0.2, 0.6 })
  {
    const Region region = regionOf(mesh, [](const Vec3& p) { return p.x > 0.3; });
    Execution execution(2);
    const RemeshResult result = remesh(mesh, region, { .edgeLength = edge }, execution);
    expectSameKind(mesh, result);
    const SurfaceEdit& edit = result.edit;
    std::size_t next = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      if (region[t] != 0)
      {
        continue;
      }
      ASSERT_EQ(edit.triangleOrigin[next], t);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index point = edit.mesh.triangles[next][k];
        ASSERT_EQ(edit.pointOrigin[point], mesh.triangles[t][k]);
        ASSERT_EQ(edit.mesh.points[point], mesh.points[mesh.triangles[t][k]]);
      }
      ++next;
    }
    EXPECT_GT(result.made, 0U);
    EXPECT_EQ(edit.mesh.triangles.size(), next + result.made);
    std::vector<Index> origins = edit.pointOrigin;
    std::erase(origins, kNone);
    EXPECT_TRUE(std::ranges::is_sorted(origins, std::less_equal<>{})) << "in order";
  }
}

/// n × n quads a side of the cube from -1 to 1.
TriMesh cube(Index n)
{
  TriMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      const auto first = static_cast<Index>(mesh.points.size());
      for (Index i = 0; i <= n; ++i)
      {
        for (Index j = 0; j <= n; ++j)
        {
          const double u = 2.0 * i / n - 1.0;
          const double v = (2.0 * j / n - 1.0) * side;
          mesh.points.push_back(axis == 0 ? Vec3{ side, u, v }
              : axis == 1                 ? Vec3{ v, side, u }
                                          : Vec3{ u, v, side });
        }
      }
      for (Index i = 0; i < n; ++i)
      {
        for (Index j = 0; j < n; ++j)
        {
          const Index a = first + i * (n + 1) + j;
          mesh.triangles.push_back({ a, a + n + 1, a + n + 2 });
          mesh.triangles.push_back({ a, a + n + 2, a + 1 });
        }
      }
    }
  }
  return welded(mesh);
}

TEST(Remesh, KeepsFeaturesWhenAsked)
{
  const TriMesh mesh = cube(8);
  ASSERT_EQ(describeMesh(mesh).genus, 0);
  for (const double edge : { 0.1, 0.25, 0.5 })
  {
    const RemeshResult kept = run(mesh, { .edgeLength = edge, .keepFeatures = 40.0 });
    expectSameKind(mesh, kept);
    EXPECT_LT(deviationBetween(mesh, kept.edit.mesh), 1e-9);
    EXPECT_NEAR(*describeMesh(kept.edit.mesh).volume, 8.0, 1e-9);
    tell("cube", mesh, kept);
  }
  EXPECT_GT(deviationBetween(mesh, run(mesh, { .edgeLength = 0.25 }).edit.mesh), 1e-3);
}

TEST(Remesh, KeepsTheBoundary)
{
  const TriMesh mesh = terrain(30, 0.0);
  for (const double edge : { 0.02, 0.05, 0.1 })
  {
    const RemeshResult result = run(mesh, { .edgeLength = edge });
    tell("square", mesh, result);
    expectSameKind(mesh, result);
    EXPECT_NEAR(describeMesh(result.edit.mesh).area, 1.0, 1e-9);
    std::cout << "boundary edges " << describeMesh(result.edit.mesh).boundaryEdges << "\n";
    EXPECT_GT(result.goodEdges, 0.4);
  }
}

TEST(Remesh, NeverExceedsTheLimit)
{
  const TriMesh mesh = corpus::torus(40);
  for (const double limit : { 0.02, 0.005, 1e-4 })
  {
    const RemeshResult result = run(mesh, { .edgeLength = 0.4, .maxDeviation = limit });
    expectSameKind(mesh, result);
    EXPECT_LE(deviationBetween(mesh, result.edit.mesh), limit);
    std::cout << "limit " << limit << ": " << result.heldBack << " held back, " << result.made
              << " made\n";
  }
}

TEST(Remesh, LeavesWhatIsNoManifold)
{
  const TriMesh solids = corpus::voxelBorder(
    4, [](Index i, Index j, Index k) { return (i * 7 + j * 5 + k * 3) % 4 == 0; });
  TriMesh crossing = sphereMesh(4);
  TriMesh other = sphereMesh(4);
  std::ranges::for_each(other.points, [](Vec3& p) { p.x += 1.2; });
  crossing = together(crossing, other);
  for (const TriMesh& mesh :
    { corpus::square(), corpus::moebius(), solids, crossing, corpus::tetrahedraOnOneEdge(),
      corpus::tetrahedraOnOnePoint(), TriMesh{ { {}, {}, {} }, { { 0, 1, 2 }, { 0, 0, 1 } } } })
  {
    expectSameKind(mesh, run(mesh));
  }
  EXPECT_GT(run(crossing).made, 1000U);
  EXPECT_GT(run(crossing).heldBack, 100U);
  EXPECT_TRUE(run({}).edit.mesh.triangles.empty());
}

TEST(Remesh, BlendsDataOfTheNearestPlaces)
{
  const TriMesh mesh = corpus::torus(40);
  const RemeshResult result = run(mesh, { .edgeLength = 0.1 });
  auto blend = result.edit.blends.begin();
  for (std::size_t i = 0; i < result.edit.mesh.points.size(); ++i)
  {
    if (result.edit.pointOrigin[i] == kNone)
    {
      Vec3 mean;
      for (std::size_t k = 0; k < 3; ++k)
      {
        mean = mean + mesh.points[blend->from.at(k)] * blend->weights.at(k);
      }
      EXPECT_LT(length(mean - result.edit.mesh.points[i]), 1e-9);
      ++blend;
    }
  }
}

TEST(Remesh, TakesScans)
{
  for (const std::string name : { "02_range_scans/stanford_bunny/reconstruction/bun_zipper.ply",
         "05_meshes/cgal/elephant.off", "05_meshes/cgal/fandisk.off", "05_meshes/cgal/pipe.off" })
  {
    const TriMesh mesh = sharedMesh(name);
    if (mesh.triangles.empty())
    {
      GTEST_SKIP() << "no " << name;
    }
    const auto start = std::chrono::steady_clock::now();
    const RemeshResult result = run(mesh, { .keepFeatures = 50.0 });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::cout << took.count() << " s ";
    tell(name, mesh, result);
    expectSameKind(mesh, result);
  }
}

TEST(Remesh, IsTheSameOnAnyNumberOfThreadsAndAgain)
{
  const TriMesh mesh = corpus::torus(30);
  const SurfaceEdit first = run(mesh, { .edgeLength = 0.2 }, 1).edit;
  for (const unsigned threads : { 1U, 3U })
  {
    const SurfaceEdit again = run(mesh, { .edgeLength = 0.2 }, threads).edit;
    EXPECT_EQ(first.mesh.points, again.mesh.points);
    EXPECT_EQ(first.mesh.triangles, again.mesh.triangles);
  }
}

TEST(Remesh, RefusesAndStops)
{
  TriMesh mesh = corpus::torus(40);
  EXPECT_THROW(run(mesh, { .edgeLength = 1e-5 }), Error);
  const CancelToken token;
  Execution stopping(2, token,
    [&](std::string_view, double fraction)
    {
      if (fraction > 0.1)
      {
        token.cancel();
      }
    });
  stopping.plan({ { "remesh", 1.0 }, { "check", 1.0 } });
  EXPECT_THROW(remesh(mesh, allOf(mesh), {}, stopping), Cancelled);
  mesh.points[5].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run(mesh), Error);
}

} // namespace
} // namespace scan::test
