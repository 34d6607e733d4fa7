// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/decimate.h"

#include "filters/base/error.h"
#include "filters/geometry/dihedral_angle.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/openmesh_decimate.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"
#include "tests/bench/knot_scan.h"
#include "tests/geometry/point_fixtures.h"
#include "tests/geometry/refine_fixtures.h"
#include "tests/geometry/surface_corpus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace
{

using namespace scan;
using scan::test::awkwardMeshes;
using scan::test::manifolds;
using scan::test::NamedMesh;
using scan::test::pointSeed;
using scan::test::randomRegion;

DecimateResult decimated(const TriMesh& mesh, const DecimateOptions& options, unsigned threads = 2)
{
  Execution execution(threads);
  return decimate(mesh, options, execution);
}

DecimateOptions toShare(const TriMesh& mesh, double share)
{
  DecimateOptions options;
  options.triangles =
    std::max<std::size_t>(1, static_cast<std::size_t>(share * double(mesh.triangles.size())));
  return options;
}

std::size_t selfIntersectionsOf(const TriMesh& mesh)
{
  Execution execution;
  return selfIntersections(mesh, execution).size();
}

/// How far two surfaces are apart, at most and both ways.
double distanceBound(const TriMesh& a, const TriMesh& b)
{
  Execution execution;
  const TriangleTree aTree(a, execution);
  const TriangleTree bTree(b, execution);
  return std::max(
    deviationFrom(a, bTree, execution).atMost, deviationFrom(b, aTree, execution).atMost);
}

void expectSameKind(const TriMesh& before, const TriMesh& after)
{
  const MeshReport was = describeMesh(before);
  const MeshReport is = describeMesh(after);
  EXPECT_EQ(is.eulerCharacteristic, was.eulerCharacteristic);
  EXPECT_EQ(is.components.size(), was.components.size());
  EXPECT_EQ(is.boundaryLoops, was.boundaryLoops);
  EXPECT_EQ(is.isClosed, was.isClosed);
  EXPECT_EQ(is.isManifold, was.isManifold);
  EXPECT_EQ(is.isOriented, was.isOriented);
  EXPECT_LE(is.flatTriangles, was.flatTriangles);
}

TEST(Decimate, KeepsWhatASurfaceIs)
{
  for (const NamedMesh& named : manifolds())
  {
    for (const double share : { 0.7, 0.3, 0.05 })
    {
      SCOPED_TRACE(named.name + " to " + std::to_string(share));
      const DecimateOptions options = toShare(named.mesh, share);
      const DecimateResult result = decimated(named.mesh, options);
      expectSameKind(named.mesh, result.edit.mesh);
      EXPECT_GE(result.edit.mesh.triangles.size() + 1, options.triangles);
      if (selfIntersectionsOf(named.mesh) == 0)
      {
        EXPECT_EQ(selfIntersectionsOf(result.edit.mesh), 0U);
      }
    }
  }
}

TEST(Decimate, ReachesTheNumberOfTriangles)
{
  const TriMesh torus = corpus::torus(60);
  for (const std::size_t triangles : { 5000, 720, 100 })
  {
    DecimateOptions options;
    options.triangles = triangles;
    EXPECT_EQ(decimated(torus, options).edit.mesh.triangles.size(), triangles);
  }
}

TEST(Decimate, LeavesWhatIsOutsideTheRegion)
{
  Random random(pointSeed());
  for (const NamedMesh& named : manifolds())
  {
    SCOPED_TRACE(named.name + ", SCAN_TEST_SEED=" + std::to_string(pointSeed()));
    const std::vector<std::uint8_t> isInRegion = randomRegion(named.mesh, random);
    DecimateOptions options = toShare(named.mesh, 0.2);
    options.isInRegion = isInRegion;
    const SurfaceEdit edit = decimated(named.mesh, options).edit;
    std::set<Index> left;
    for (std::size_t t = 0; t < edit.mesh.triangles.size(); ++t)
    {
      const Index origin = edit.triangleOrigin[t];
      left.insert(origin);
      for (std::size_t k = 0; k < 3 && isInRegion[origin] == 0; ++k)
      {
        const Index corner = edit.mesh.triangles[t][k];
        ASSERT_EQ(edit.pointOrigin[corner], named.mesh.triangles[origin][k]);
        ASSERT_EQ(edit.mesh.points[corner], named.mesh.points[edit.pointOrigin[corner]]);
      }
    }
    for (Index t = 0; t < isInRegion.size(); ++t)
    {
      ASSERT_TRUE(isInRegion[t] != 0 || left.contains(t));
    }
    expectSameKind(named.mesh, edit.mesh);
  }
}

TEST(Decimate, NeverExceedsTheLargestDeviation)
{
  for (const NamedMesh& named : manifolds())
  {
    const double diagonal = describeMesh(named.mesh).boxDiagonal;
    for (const double share : { 1e-4, 3e-3, 0.03 })
    {
      SCOPED_TRACE(named.name + " within " + std::to_string(share));
      DecimateOptions options;
      options.maxDeviation = share * diagonal;
      const DecimateResult result = decimated(named.mesh, options);
      // the bound of the measurement is a hundredth above what it found, or a millionth of the box
      EXPECT_LE(distanceBound(named.mesh, result.edit.mesh),
        1.0101 * options.maxDeviation + 2e-6 * diagonal);
      expectSameKind(named.mesh, result.edit.mesh);
    }
  }
}

TEST(Decimate, GoesFarWithinALargestDeviation)
{
  const TriMesh torus = corpus::torus(100);
  DecimateOptions options;
  options.maxDeviation = 0.01;
  const DecimateResult result = decimated(torus, options);
  EXPECT_LT(result.edit.mesh.triangles.size(), torus.triangles.size() / 8);
  EXPECT_GT(distanceBound(torus, result.edit.mesh), 0.5 * options.maxDeviation);
}

TEST(Decimate, LeavesNoPlaceFartherThanItsOthersWhenHalfGoes)
{
  const TriMesh mesh = bench::knotSurface(800, 100);
  Execution execution(2);
  DecimateOptions options;
  options.triangles = mesh.triangles.size() / 2;
  const TriMesh half = decimate(mesh, options, execution).edit.mesh;
  const auto there = deviationFrom(mesh, TriangleTree(half, execution), execution);
  const auto back = deviationFrom(half, TriangleTree(mesh, execution), execution);
  const double mean = (there.mean + back.mean) / 2.0;
  EXPECT_LT(std::max(there.largest, back.largest), 8.0 * mean);
  EXPECT_LT(mean, 2.05e-3); // the knot is 80 long
}

TEST(Decimate, LeavesFewTrianglesInAPlane)
{
  const TriMesh plane = corpus::sheet(40, [](double, double) { return 0.0; });
  DecimateOptions options;
  options.maxDeviation = 1e-6;
  const TriMesh result = decimated(plane, options).edit.mesh;
  EXPECT_LE(result.triangles.size(), 8U);
  const MeshReport report = describeMesh(result);
  EXPECT_NEAR(report.area, 4.0, 1e-6); // the corners of the boundary are where they were
  EXPECT_NEAR(report.boxDiagonal, std::sqrt(8.0), 1e-9);
}

TEST(Decimate, KeepsEdgesAndCornersOfACube)
{
  TriMesh cube = corpus::voxelBorder(8, [](Index, Index, Index) { return true; });
  DecimateOptions options = toShare(cube, 0.05);
  const DecimateResult result = decimated(cube, options);
  EXPECT_NEAR(*describeMesh(result.edit.mesh).volume, 512.0, 1e-6);
}

TEST(Decimate, KeepsThinFins)
{
  // a fin whose sides lie upon each other: no plane stands across its rim
  const TriMesh fin =
    corpus::sheet(60, [](double x, double) { return std::max(0.0, 1.0 - 30.0 * std::abs(x)); });
  const TriMesh result = decimated(fin, toShare(fin, 0.02)).edit.mesh;
  EXPECT_NEAR(describeMesh(result).boxMax.z, 1.0, 0.02);
}

TEST(Decimate, TurnsNoTriangleOver)
{
  const TriMesh field = corpus::sheet(
    50, [](double x, double y) { return 0.05 * std::sin(9.0 * x) * std::cos(7.0 * y + 2.0 * x); });
  const TriMesh result = decimated(field, toShare(field, 0.05)).edit.mesh;
  for (const auto& [a, b, c] : result.triangles)
  {
    const Vec3 normal =
      cross(result.points[b] - result.points[a], result.points[c] - result.points[a]);
    ASSERT_GT(normal.z, 0.0);
  }
}

TEST(Decimate, PointsStandForThePointsThatTheyWere)
{
  const TriMesh torus = corpus::torus(50);
  const SurfaceEdit edit = decimated(torus, toShare(torus, 0.2)).edit;
  ASSERT_EQ(edit.pointOrigin.size(), edit.mesh.points.size());
  EXPECT_TRUE(edit.blends.empty());
  EXPECT_TRUE(std::ranges::is_sorted(edit.pointOrigin));
  for (std::size_t i = 0; i < edit.pointOrigin.size(); ++i)
  {
    ASSERT_LT(length(edit.mesh.points[i] - torus.points[edit.pointOrigin[i]]), 0.5);
  }
}

TEST(Decimate, SameOnAnyNumberOfThreadsAndInAnyOrderOfMemory)
{
  const TriMesh torus = corpus::torus(70);
  DecimateOptions options;
  options.maxDeviation = 0.02;
  const SurfaceEdit one = decimated(torus, options, 1).edit;
  const SurfaceEdit three = decimated(torus, options, 3).edit;
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
}

TEST(Decimate, ScatteredPointsGiveAnEquallyGoodSurface)
{
  const TriMesh torus = corpus::torus(60);
  TriMesh scattered = torus;
  std::vector<Index> place(torus.points.size());
  Random random(pointSeed());
  for (Index i = 0; i < place.size(); ++i)
  {
    const auto other = static_cast<Index>(random.below(i + 1));
    place[i] = place[other];
    place[other] = i;
  }
  for (Index i = 0; i < place.size(); ++i)
  {
    scattered.points[place[i]] = torus.points[i];
  }
  for (Triangle& triangle : scattered.triangles)
  {
    std::ranges::transform(triangle, triangle.begin(), [&](Index corner) { return place[corner]; });
  }
  const DecimateOptions options = toShare(torus, 0.1);
  const SurfaceEdit edit = decimated(scattered, options).edit;
  expectSameKind(torus, edit.mesh);
  EXPECT_LT(distanceBound(torus, edit.mesh),
    1.5 * distanceBound(torus, decimated(torus, options).edit.mesh));
  for (std::size_t t = 0; t < edit.mesh.triangles.size(); ++t)
  {
    ASSERT_LT(edit.triangleOrigin[t], scattered.triangles.size());
  }
}

TEST(Decimate, FarFromTheOriginAsNearIt)
{
  const TriMesh torus = corpus::torus(50);
  TriMesh far = torus;
  for (Vec3& p : far.points)
  {
    p = p + Vec3{ 5e6, -3e6, 1e6 };
  }
  const TriMesh result = decimated(far, toShare(far, 0.2)).edit.mesh;
  const double near = distanceBound(torus, decimated(torus, toShare(torus, 0.2)).edit.mesh);
  EXPECT_LT(distanceBound(far, result), 1.2 * near);
}

TEST(Decimate, SurvivesWhatIsNoSurface)
{
  for (const NamedMesh& named : awkwardMeshes())
  {
    SCOPED_TRACE(named.name);
    const DecimateResult result = decimated(named.mesh, toShare(named.mesh, 0.1));
    const MeshReport was = describeMesh(named.mesh);
    const MeshReport is = describeMesh(result.edit.mesh);
    EXPECT_EQ(is.nonManifoldEdges, was.nonManifoldEdges);
    EXPECT_EQ(is.eulerCharacteristic, was.eulerCharacteristic);
  }
}

TEST(Decimate, RefusesWhatItCannotDo)
{
  const TriMesh torus = corpus::torus(5);
  EXPECT_THROW(decimated(torus, {}), Error);
  TriMesh broken = torus;
  broken.triangles[0][1] = 1000;
  EXPECT_THROW(decimated(broken, toShare(broken, 0.5)), Error);
  broken = torus;
  broken.points[3].y = std::nan("");
  EXPECT_THROW(decimated(broken, toShare(broken, 0.5)), Error);
}

TEST(Decimate, StopsWhenCancelled)
{
  const TriMesh torus = corpus::torus(40);
  CancelToken token;
  Execution execution(2, token,
    [&](std::string_view, double fraction)
    {
      if (fraction > 0.2)
      {
        token.cancel();
      }
    });
  execution.plan({ { "decimate", 1.0 } });
  EXPECT_THROW(decimate(torus, toShare(torus, 0.1), execution), Cancelled);
}

TEST(OpenMeshDecimate, PointsStayInTheirPlacesAndTheSurfaceIsNear)
{
  const TriMesh torus = corpus::torus(40);
  Execution execution;
  const SurfaceEdit edit = decimateByOpenMesh(torus, toShare(torus, 0.25), {}, execution).edit;
  EXPECT_EQ(edit.mesh.triangles.size(), 800U);
  expectSameKind(torus, edit.mesh);
  for (std::size_t i = 0; i < edit.mesh.points.size(); ++i)
  {
    ASSERT_EQ(edit.mesh.points[i], torus.points[edit.pointOrigin[i]]);
  }
  EXPECT_LT(distanceBound(torus, edit.mesh), 0.1);
}

TEST(OpenMeshDecimate, KeepsItsConditions)
{
  const TriMesh torus = corpus::torus(40);
  Execution execution;
  DecimateOptions options = toShare(torus, 0.01);
  OpenMeshConditions conditions;
  conditions.longestEdge = 0.5;
  const TriMesh result = decimateByOpenMesh(torus, options, conditions, execution).edit.mesh;
  EXPECT_LT(result.triangles.size(), torus.triangles.size());
  EXPECT_LE(describeMesh(result).longestEdge, 0.5 + 1e-12);
  const TriMesh fine = corpus::torus(100);
  options.triangles = 0;
  options.maxDeviation = 0.01;
  const TriMesh near = decimateByOpenMesh(fine, options, {}, execution).edit.mesh;
  EXPECT_LT(near.triangles.size(), fine.triangles.size() / 2);
  EXPECT_LE(distanceBound(fine, near), 0.0102);
}

TEST(OpenMeshDecimate, LeavesWhatIsOutsideTheRegion)
{
  const TriMesh torus = corpus::torus(20);
  std::vector<std::uint8_t> isInRegion(torus.triangles.size(), 0);
  std::fill_n(isInRegion.begin(), isInRegion.size() / 2, 1);
  DecimateOptions options = toShare(torus, 0.6);
  options.isInRegion = isInRegion;
  Execution execution;
  const SurfaceEdit edit = decimateByOpenMesh(torus, options, {}, execution).edit;
  std::size_t outside = 0;
  for (const Index origin : edit.triangleOrigin)
  {
    outside += isInRegion[origin] == 0 ? 1 : 0;
  }
  EXPECT_EQ(outside, isInRegion.size() / 2);
  EXPECT_LT(edit.mesh.triangles.size(), torus.triangles.size());
}

} // namespace
