// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/fill_holes.h"

#include "filters/geometry/holes.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/hole_fixtures.h"
#include "tests/geometry/mesh_corpus.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

namespace scan::test
{
namespace
{

FillHolesResult fill(
  const TriMesh& mesh, const FillHolesOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return fillHoles(mesh, everywhere(mesh.points), options, execution);
}

std::size_t countOf(const FillHolesResult& result, HoleFate fate)
{
  return static_cast<std::size_t>(std::ranges::count(result.holes, fate, &Hole::fate));
}

/// The input stays and comes first; no new self-intersection, no new defect.
void expectOnlyAdded(const TriMesh& before, const FillHolesResult& result)
{
  const TriMesh& after = result.edit.mesh;
  expectConsistent(result.edit);
  ASSERT_GE(after.points.size(), before.points.size());
  ASSERT_GE(after.triangles.size(), before.triangles.size());
  EXPECT_TRUE(std::equal(before.points.begin(), before.points.end(), after.points.begin()));
  EXPECT_TRUE(
    std::equal(before.triangles.begin(), before.triangles.end(), after.triangles.begin()));
  for (std::size_t i = 0; i < before.points.size(); ++i)
  {
    ASSERT_EQ(result.edit.pointOrigin[i], i);
  }
  EXPECT_EQ(intersectionsOf(after), intersectionsOf(before));
  const MeshReport was = describeMesh(before);
  const MeshReport is = describeMesh(after);
  EXPECT_EQ(is.nonManifoldEdges, was.nonManifoldEdges);
  EXPECT_EQ(is.misorientedEdges, was.misorientedEdges);
  EXPECT_EQ(is.flatTriangles, was.flatTriangles);
  EXPECT_LE(is.nonManifoldVertices, was.nonManifoldVertices);
}

void expectClosed(const TriMesh& mesh, std::int64_t genus = 0)
{
  const MeshReport report = describeMesh(mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_TRUE(report.isManifold);
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(report.genus, genus);
}

constexpr std::array<FillShape, 3> kShapes{ FillShape::flat, FillShape::tangent,
  FillShape::curved };

/// Without a cap about the z axis.
TriMesh cappedSphere(int levels, double height)
{
  return torn(sphereMesh(levels), [&](const Vec3& at) { return at.z > height; });
}

TEST(FillHoles, FollowsASphereTheBetterTheRounderTheShape)
{
  const TriMesh mesh = cappedSphere(4, 0.75);
  std::array<double, 3> distance{};
  for (const FillShape shape : kShapes)
  {
    const FillHolesResult result = fill(mesh, { .shape = shape });
    ASSERT_EQ(countOf(result, HoleFate::filled), 1U);
    EXPECT_EQ(result.holes.front().shape, shape);
    expectOnlyAdded(mesh, result);
    expectClosed(result.edit.mesh);
    double& farthest = distance.at(static_cast<std::size_t>(shape));
    for (std::size_t t = mesh.triangles.size(); t < result.edit.mesh.triangles.size(); ++t)
    {
      const Triangle& corners = result.edit.mesh.triangles[t];
      const Vec3 at = shape == FillShape::flat ? centroidOf(result.edit.mesh, corners)
                                               : result.edit.mesh.points[corners[2]];
      farthest = std::max(farthest, std::abs(1.0 - length(at)));
    }
    std::cout << "shape " << static_cast<int>(shape) << ": " << result.pointsAdded
              << " points, farthest from the sphere " << farthest << "\n";
  }
  EXPECT_GT(distance[0], 0.15);
  EXPECT_LT(distance[1], 0.25 * distance[0]);
  EXPECT_LT(distance[2], 0.3 * distance[1]);
  EXPECT_LT(distance[2], 0.01);
}

TEST(FillHoles, BearsNoise)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  TriMesh mesh = cappedSphere(5, 0.8);
  const double edge = describeMesh(mesh).meanEdge;
  for (Vec3& p : mesh.points)
  {
    p = p + noise(random, 0.1 * edge);
  }
  for (const FillShape shape : { FillShape::tangent, FillShape::curved })
  {
    const FillHolesResult result = fill(mesh, { .shape = shape });
    double farthest = 0.0;
    for (std::size_t i = mesh.points.size(); i < result.edit.mesh.points.size(); ++i)
    {
      farthest = std::max(farthest, std::abs(1.0 - length(result.edit.mesh.points[i])));
    }
    std::cout << "noise of a tenth of an edge, shape " << static_cast<int>(shape) << ": farthest "
              << farthest / edge << " edges\n";
    EXPECT_EQ(result.holes.front().shape, shape);
    EXPECT_LT(farthest, (shape == FillShape::curved ? 4.0 : 1.0) * edge)
      << "SCAN_TEST_SEED=" << seed;
  }
}

TEST(FillHoles, NewTrianglesAreAsFineAsThoseOfTheRim)
{
  const TriMesh mesh = cappedSphere(5, 0.8);
  const double mean = describeMesh(mesh).meanEdge;
  const FillHolesResult result = fill(mesh, { .shape = FillShape::curved });
  const MeshReport report = describeMesh({ result.edit.mesh.points,
    { result.edit.mesh.triangles.begin() + static_cast<std::ptrdiff_t>(mesh.triangles.size()),
      result.edit.mesh.triangles.end() } });
  EXPECT_NEAR(report.meanEdge, mean, 0.25 * mean);
  EXPECT_LT(report.longestEdge, 2.5 * mean);
}

TEST(FillHoles, LeavesTheRimOfASheet)
{
  const TriMesh ground =
    torn(terrain(30), [](const Vec3& p) { return std::hypot(p.x - 0.5, p.y - 0.5) < 0.15; });
  const FillHolesResult result = fill(ground);
  EXPECT_EQ(countOf(result, HoleFate::outerRim), 1U);
  EXPECT_EQ(countOf(result, HoleFate::filled), 1U);
  expectOnlyAdded(ground, result);
  EXPECT_EQ(describeMesh(result.edit.mesh).boundaryLoops, 1U);

  const FillHolesResult closed =
    fill(ground, { .shape = FillShape::flat, .outerRims = OuterRims::fill });
  EXPECT_EQ(countOf(closed, HoleFate::outerRim), 0U);
}

TEST(FillHoles, TakesTheRimOfWhatIsNearlyClosedForAHole)
{
  for (const double height : { 0.2, 0.5, 0.9 })
  {
    EXPECT_EQ(countOf(fill(cappedSphere(3, height)), HoleFate::filled), 1U) << height;
    EXPECT_EQ(
      countOf(fill(cappedSphere(3, height), { .outerRims = OuterRims::keep }), HoleFate::outerRim),
      1U);
  }
  EXPECT_EQ(countOf(fill(cappedSphere(3, -0.4)), HoleFate::outerRim), 1U);
  expectClosed(fill(tube(24, 12, 1.0, 5.0)).edit.mesh);
}

TEST(FillHoles, PartsHolesThatTouchAtAPoint)
{
  // two quads with a common corner
  TriMesh mesh = corpus::torus(12);
  std::erase_if(mesh.triangles,
    [&](const Triangle& t)
    {
      const auto inQuad = [&](Index i, Index j)
      {
        return std::ranges::all_of(t,
          [&](Index p)
          { return (p / 12 == i || p / 12 == i + 1) && (p % 12 == j || p % 12 == j + 1); });
      };
      return inQuad(3, 3) || inQuad(4, 4);
    });
  Execution execution(1);
  const auto loops = boundaryLoops(mesh, execution);
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(loops[0].points.size(), 4U);
  EXPECT_EQ(loops[1].points.size(), 4U);
  EXPECT_EQ(describeMesh(mesh).nonManifoldVertices, 1U);
  for (const FillShape shape : kShapes)
  {
    const FillHolesResult result = fill(mesh, { .shape = shape });
    expectOnlyAdded(mesh, result);
    expectClosed(result.edit.mesh, 1);
  }
}

TEST(FillHoles, FillsOnlyWhatIsAskedFor)
{
  const TriMesh mesh =
    torn(sphereMesh(4), [](const Vec3& p) { return p.z > 0.9 || p.z < -0.95 || p.x > 0.98; });
  ASSERT_EQ(fill(mesh).holes.size(), 3U);

  const FillHolesResult near = fill(mesh, { .at = { { 0, 0, 2 } } });
  EXPECT_EQ(countOf(near, HoleFate::notAsked), 2U);
  EXPECT_EQ(countOf(near, HoleFate::filled), 1U);
  for (std::size_t i = mesh.points.size(); i < near.edit.mesh.points.size(); ++i)
  {
    EXPECT_GT(near.edit.mesh.points[i].z, 0.8);
  }

  double longest = 0.0;
  Index most = 0;
  for (const Hole& hole : near.holes)
  {
    longest = std::max(longest, hole.length);
    most = std::max(most, hole.edges);
  }
  EXPECT_EQ(countOf(fill(mesh, { .maxPerimeter = longest * 0.99 }), HoleFate::tooLong), 1U);
  EXPECT_EQ(countOf(fill(mesh, { .maxEdges = most - 1 }), HoleFate::tooManyEdges), 1U);

  std::vector<std::uint8_t> inRegion(mesh.points.size());
  std::ranges::transform(
    mesh.points, inRegion.begin(), [](const Vec3& p) { return p.z < 0.0 ? 1 : 0; });
  Execution execution(1);
  const FillHolesResult below = fillHoles(mesh, inRegion, {}, execution);
  EXPECT_EQ(countOf(below, HoleFate::outsideRegion), 2U);
  EXPECT_EQ(countOf(below, HoleFate::filled), 1U);
}

TEST(FillHoles, FillsAPartOfAHole)
{
  const TriMesh mesh = cappedSphere(4, 0.6);
  for (const FillShape shape : kShapes)
  {
    const FillHolesResult result =
      fill(mesh, { .shape = shape, .part = RimPart{ { 1, 0, 0.6 }, { 0, 1, 0.6 } } });
    ASSERT_EQ(countOf(result, HoleFate::filled), 1U);
    expectOnlyAdded(mesh, result);
    const MeshReport report = describeMesh(result.edit.mesh);
    EXPECT_EQ(report.boundaryLoops, 1U);
    EXPECT_TRUE(report.isManifold);
    EXPECT_LT(report.boundaryEdges, describeMesh(mesh).boundaryEdges);
    for (std::size_t i = mesh.points.size(); i < result.edit.mesh.points.size(); ++i)
    {
      const Vec3& p = result.edit.mesh.points[i];
      EXPECT_GT(p.x + p.y, 0.7) << "on the shorter side";
    }
    expectClosed(fill(result.edit.mesh, { .shape = shape }).edit.mesh);
  }
  EXPECT_THROW(fill(mesh, { .part = RimPart{ { 1, 0, 0.6 }, { 1, 0, 0.6 } } }), Error);
  EXPECT_THROW(fill(corpus::torus(8), { .part = RimPart{ {}, {} } }), Error);
}

TEST(FillHoles, NeverCutsTheSurface)
{
  // thorns through the lid: one that the flat one meets, one that the round ones meet
  const auto withThorn = [](double height)
  {
    TriMesh mesh = cappedSphere(3, 0.7);
    corpus::addTetrahedron(mesh, 0.2, { 0.1, 0, height });
    return mesh;
  };
  const TriMesh low = withThorn(0.75);
  const FillHolesResult flat = fill(low, { .shape = FillShape::flat });
  EXPECT_EQ(countOf(flat, HoleFate::noRoom), 1U);
  EXPECT_EQ(flat.trianglesAdded, 0U);
  const FillHolesResult curved = fill(low);
  EXPECT_EQ(countOf(curved, HoleFate::filled), 1U);
  expectOnlyAdded(low, curved);

  const TriMesh high = withThorn(0.95);
  const FillHolesResult flatter = fill(high);
  expectOnlyAdded(high, flatter);
  EXPECT_EQ(countOf(flatter, HoleFate::filled), 1U);
  EXPECT_EQ(flatter.holes.front().shape, FillShape::flat);
}

TEST(FillHoles, BecomesFlatterAtTheLimit)
{
  const TriMesh mesh = cappedSphere(4, 0.7);
  EXPECT_EQ(fill(mesh, { .maxDeviation = 0.5 }).holes.front().shape, FillShape::tangent);
  EXPECT_EQ(fill(mesh, { .maxDeviation = 0.1 }).holes.front().shape, FillShape::flat);
}

TEST(FillHoles, ClosesTornMeshes)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::size_t left = 0;
  std::size_t filled = 0;
  for (int round = 0; round < 24; ++round)
  {
    const TriMesh whole = round % 2 == 0 ? sphereMesh(4) : corpus::torus(40);
    std::vector<std::pair<Vec3, double>> balls;
    for (int i = 0; i < 12; ++i)
    {
      const Vec3 at = whole.points[random.below(whole.points.size())];
      balls.emplace_back(at, 0.05 + 0.2 * random.unit());
    }
    const TriMesh mesh = torn(whole,
      [&](const Vec3& p)
      {
        return random.below(60) == 0 ||
          std::ranges::any_of(
            balls, [&](const auto& ball) { return length(p - ball.first) < ball.second; });
      });
    const FillShape shape = kShapes.at(static_cast<std::size_t>(round % 3));
    const FillHolesResult result = fill(mesh, { .shape = shape });
    expectOnlyAdded(mesh, result);
    left += countOf(result, HoleFate::noRoom);
    filled += countOf(result, HoleFate::filled);
    EXPECT_EQ(countOf(result, HoleFate::notManifold), 0U);
    if (countOf(result, HoleFate::filled) == result.holes.size())
    {
      const MeshReport report = describeMesh(result.edit.mesh);
      EXPECT_TRUE(report.isClosed && report.isOriented) << "SCAN_TEST_SEED=" << seed;
    }
  }
  std::cout << filled << " filled, " << left << " left\n";
  EXPECT_LE(left * 100, filled) << "SCAN_TEST_SEED=" << seed;
}

TEST(FillHoles, ClosesScans)
{
  for (const std::string name : { "02_range_scans/stanford_bunny/reconstruction/bun_zipper.ply",
         "02_range_scans/stanford_bunny/reconstruction/bun_zipper_res3.ply",
         "05_meshes/cgal/mech-holes-shark.off", "05_meshes/cgal/elephant-with-holes.off" })
  {
    const TriMesh mesh = welded(sharedMesh(name));
    if (mesh.triangles.empty())
    {
      GTEST_SKIP() << "no " << name;
    }
    for (const FillShape shape : kShapes)
    {
      const auto start = std::chrono::steady_clock::now();
      const FillHolesResult result = fill(mesh, { .shape = shape });
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      expectOnlyAdded(mesh, result);
      const MeshReport report = describeMesh(result.edit.mesh);
      EXPECT_EQ(report.boundaryLoops, result.holes.size() - countOf(result, HoleFate::filled));
      EXPECT_EQ(countOf(result, HoleFate::noRoom) + countOf(result, HoleFate::outerRim), 0U);
      std::cout << name << ": " << result.holes.size() << " holes, "
                << countOf(result, HoleFate::filled) << " filled, "
                << countOf(result, HoleFate::noRoom) << " without room, "
                << countOf(result, HoleFate::outerRim) << " rims; " << result.pointsAdded
                << " points, closed " << report.isClosed << ", " << took.count() << " s\n";
    }
  }
}

TEST(FillHoles, TakesRimsOfThousandsOfEdges)
{
  Random random(1);
  TriMesh mesh = tube(6000, 4, 1.0, 0.004, { 0, 0, 0.5 });
  for (Vec3& p : mesh.points) // a belt of a sphere
  {
    const double z = p.z + 0.0002 * random.unit();
    const double r = std::sqrt(1.0 - z * z);
    p = { p.x * r, p.y * r, z };
  }
  for (const FillShape shape : { FillShape::flat, FillShape::curved })
  {
    const auto start = std::chrono::steady_clock::now();
    const FillHolesResult result =
      fill(mesh, { .shape = shape, .outerRims = OuterRims::fill, .at = { { 0, 0, 1 } } });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    std::cout << "6000 edges, shape " << static_cast<int>(shape) << ": " << took.count() << " s, "
              << result.pointsAdded << " points, shape "
              << static_cast<int>(result.holes.front().shape) << "\n";
    EXPECT_EQ(countOf(result, HoleFate::filled), 1U);
  }
}

TEST(FillHoles, IsTheSameOnAnyNumberOfThreads)
{
  const TriMesh mesh =
    torn(sphereMesh(4), [](const Vec3& p) { return std::abs(p.z) > 0.8 || p.x > 0.95; });
  const SurfaceEdit one = fill(mesh, {}, 1).edit;
  const SurfaceEdit three = fill(mesh, {}, 3).edit;
  EXPECT_EQ(one.mesh.points, three.mesh.points);
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
}

TEST(FillHoles, TakesWhatIsNoManifold)
{
  const TriMesh strip = corpus::moebius();
  const TriMesh solids = corpus::voxelBorder(
    4, [](Index i, Index j, Index k) { return (i * 7 + j * 5 + k * 3) % 4 == 0; });
  Random random(pointSeed());
  for (const TriMesh& mesh : { TriMesh{}, corpus::square(), strip, solids,
         corpus::tetrahedraOnOneEdge(), TriMesh{ { {}, {}, {} }, { { 0, 1, 2 }, { 0, 0, 1 } } },
         torn(solids, [&](const Vec3&) { return random.below(10) == 0; }) })
  {
    for (const FillShape shape : kShapes)
    {
      expectOnlyAdded(mesh, fill(mesh, { .shape = shape, .outerRims = OuterRims::fill }));
    }
  }
}

TEST(FillHoles, RefusesAndStops)
{
  TriMesh mesh = cappedSphere(4, 0.7);
  const CancelToken token;
  Execution stopping(2, token,
    [&](std::string_view, double fraction)
    {
      if (fraction > 0.0)
      {
        token.cancel();
      }
    });
  stopping.plan({ { "fill", 1.0 }, { "check", 1.0 } });
  EXPECT_THROW(fillHoles(mesh, everywhere(mesh.points), {}, stopping), Cancelled);
  mesh.points[mesh.triangles.front().front()].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(fill(mesh), Error);
  mesh.triangles.front().front() = static_cast<Index>(mesh.points.size());
  EXPECT_THROW(fill(mesh), Error);
}

} // namespace
} // namespace scan::test
