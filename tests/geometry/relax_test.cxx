// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/relax.h"

#include "data/limb_scan_truth.h"
#include "data/multiview_scan_truth.h"
#include "data/samples.h"
#include "filters/geometry/chebyshev_series.h"
#include "filters/geometry/dihedral_angle.h"
#include "filters/geometry/float4.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/smooth_normals.h"
#include "filters/geometry/vertex_normals.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <numeric>

namespace scan::test
{
namespace
{

using std::numbers::pi;
using Boundary = RelaxOptions::Boundary;

RelaxResult run(const TriMesh& mesh, const RelaxOptions& options = {}, unsigned threads = 2)
{
  Execution execution(threads);
  return relax(mesh, everywhere(mesh.points), options, execution);
}

TriMesh withPoints(const TriMesh& mesh, std::vector<Vec3> points)
{
  return { std::move(points), mesh.triangles };
}

TriMesh noisy(TriMesh mesh, double deviation, std::uint64_t seed = pointSeed())
{
  Random random(seed);
  std::ranges::for_each(mesh.points, [&](Vec3& p) { p = p + noise(random, deviation); });
  return mesh;
}

/// The surface of the cube from -1 to 1, n × n squares a side, in two triangles each.
TriMesh cube(Index n)
{
  TriMesh mesh;
  std::map<std::array<Index, 3>, Index> numbers;
  const auto pointAt = [&](const std::array<Index, 3>& at)
  {
    const auto [place, isNew] = numbers.try_emplace(at, static_cast<Index>(mesh.points.size()));
    if (isNew)
    {
      const auto side = [&](Index k) { return 2.0 * k / n - 1.0; };
      mesh.points.push_back({ side(at[0]), side(at[1]), side(at[2]) });
    }
    return place->second;
  };
  for (Index square = 0; square < 6 * n * n; ++square)
  {
    const std::size_t axis = square % 3;
    const Index side = square / 3 % 2;
    const Index u = square / 6 % n;
    const Index v = square / 6 / n;
    const auto corner = [&](Index i, Index j)
    {
      std::array<Index, 3> at{};
      at.at(axis) = side * n;
      at.at((axis + 1) % 3) = u + (side == 1 ? i : j);
      at.at((axis + 2) % 3) = v + (side == 1 ? j : i);
      return pointAt(at);
    };
    mesh.triangles.push_back({ corner(0, 0), corner(1, 0), corner(1, 1) });
    mesh.triangles.push_back({ corner(0, 0), corner(1, 1), corner(0, 1) });
  }
  return mesh;
}

TriMesh ball(Index n)
{
  TriMesh mesh = cube(n);
  std::ranges::transform(mesh.points, mesh.points.begin(), unitVector);
  return mesh;
}

/// A wave over a square of side 2 around the origin.
TriMesh sheet(Index n, double height = 0.3)
{
  TriMesh mesh;
  for (Index i = 0; i <= n; ++i)
  {
    for (Index j = 0; j <= n; ++j)
    {
      const double x = 2.0 * i / n - 1.0;
      const double y = 2.0 * j / n - 1.0;
      mesh.points.push_back({ x, y, height * std::sin(2.0 * x) * std::cos(2.0 * y) });
      if (i < n && j < n)
      {
        const Index a = i * (n + 1) + j;
        mesh.triangles.push_back({ a, a + n + 1, a + n + 2 });
        mesh.triangles.push_back({ a, a + n + 2, a + 1 });
      }
    }
  }
  return mesh;
}

/// The root of the mean square of the distances of points.
double rmsOf(const std::vector<Vec3>& points, const std::function<double(const Vec3&)>& distance)
{
  double sum = 0.0;
  for (const Vec3& p : points)
  {
    const double d = distance(p);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

double largestShift(const std::vector<Vec3>& from, const std::vector<Vec3>& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, length(to[i] - from[i]));
  }
  return largest;
}

double distanceFromCube(const Vec3& p)
{
  const Vec3 d{ std::abs(p.x) - 1.0, std::abs(p.y) - 1.0, std::abs(p.z) - 1.0 };
  const Vec3 outside{ std::max(d.x, 0.0), std::max(d.y, 0.0), std::max(d.z, 0.0) };
  return length(outside) + std::min(0.0, std::max({ d.x, d.y, d.z }));
}

double distanceFromCubeEdges(const Vec3& p)
{
  std::array<double, 3> d{ std::abs(std::abs(p.x) - 1.0), std::abs(std::abs(p.y) - 1.0),
    std::abs(std::abs(p.z) - 1.0) };
  std::ranges::sort(d);
  return std::hypot(d[0], d[1]);
}

/// Edges that bend by more than an angle in degrees: how far their ends are from those of the cube.
struct Sharpness
{
  std::size_t edges = 0;
  double bend = 0.0;     // mean, degrees
  double distance = 0.0; // root of the mean square
};

Sharpness sharpnessOf(const TriMesh& mesh, double angle)
{
  Sharpness sharpness;
  const EdgePairs pairs = pairEdges(mesh);
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    const Index mate = pairs.mate[half];
    if (mate == kNone || mate < half)
    {
      continue;
    }
    const auto at = [&](Index h) { return mesh.points[originOf(mesh, h)]; };
    const Vec3 u = at(half);
    const Vec3 v = at(nextHalf(half));
    const double bend =
      180.0 - dihedralAngle(u, v, at(previousHalf(half)), at(previousHalf(mate))) * 180.0 / pi;
    if (bend > angle)
    {
      ++sharpness.edges;
      sharpness.bend += bend;
      sharpness.distance +=
        (std::pow(distanceFromCubeEdges(u), 2) + std::pow(distanceFromCubeEdges(v), 2)) / 2.0;
    }
  }
  const double edges = std::max<double>(1.0, static_cast<double>(sharpness.edges));
  sharpness.bend /= edges;
  sharpness.distance = std::sqrt(sharpness.distance / edges);
  return sharpness;
}

/// Relaxes the wrap of a noisy scan; what the noise was divided by.
double noiseRatio(const char* name, const std::vector<Vec3>& scan,
  const std::function<double(const Vec3&)>& distance, const RelaxOptions& options = {})
{
  Execution execution;
  const TriMesh mesh = wrap(scan, {}, execution).surface;
  const RelaxResult result = run(mesh, options);
  const double before = rmsOf(mesh.points, distance);
  const double after = rmsOf(result.points, distance);
  const double volume = 100.0 * (*result.volumeAfter / *result.volumeBefore - 1.0);
  std::cout << name << ", " << options.iterations << " iterations: rms " << before << " -> "
            << after << ", ratio " << before / after << ", volume " << volume << " %, mean shift "
            << result.meanShift << "\n";
  EXPECT_LT(std::abs(volume), 1.0) << name;
  return before / after;
}

TEST(Relax, TakesTheNoiseOutOfTheScannedSphere)
{
  const std::vector<Vec3> scan = pointsOfFile(sharedFile("synthetic/sphere20k_noise.xyz"));
  if (scan.empty())
  {
    GTEST_SKIP() << "no synthetic/sphere20k_noise.xyz";
  }
  const auto distance = [](const Vec3& p) { return length(p) - 1.0; };
  EXPECT_GT(noiseRatio("sphere", scan, distance), 4.0);
  EXPECT_GT(noiseRatio("sphere", scan, distance, { .iterations = 100 }), 4.5);
}

TEST(Relax, TakesTheNoiseOutOfTheScannedTorus)
{
  const std::vector<Vec3> scan = pointsOfFile(sharedFile("synthetic/torus5k_noise.xyz"));
  if (scan.empty())
  {
    GTEST_SKIP() << "no synthetic/torus5k_noise.xyz";
  }
  const auto distance = [](const Vec3& p)
  { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - 0.35; };
  EXPECT_GT(noiseRatio("torus", scan, distance), 4.2);
}

TEST(Relax, TakesTheNoiseOutOfTheSimulatedScanOfALimb)
{
  EXPECT_GT(noiseRatio("limb", samples::simulateLimbScan(), truth::limb::distance), 4.2);
}

/// Its fillets are hardly wider than the neighbourhood that tells the noise from the shape.
TEST(Relax, TakesMostOfTheNoiseOutOfTheSimulatedScanOfAPart)
{
  const std::vector<Vec3> scan = samples::simulateScan();
  EXPECT_GT(noiseRatio("link", scan, truth::distance), 3.0);
  EXPECT_GT(noiseRatio("link", scan, truth::distance, { .iterations = 25 }), 3.15);
}

TEST(Relax, KeepsTheVolumeOver50Iterations)
{
  for (const double deviation : { 0.0, 0.2 })
  {
    for (const auto& [name, mesh, edge] :
      { std::tuple{ "ball", ball(12), 1.2 / 12 }, std::tuple{ "fine ball", ball(40), 1.2 / 40 },
        std::tuple{ "torus", corpus::torus(40), 0.3 } })
    {
      const TriMesh before = noisy(mesh, deviation * edge);
      const RelaxResult result = run(before);
      const double volume = *describeMesh(before).volume;
      EXPECT_NEAR(*result.volumeBefore, volume, 1e-9 * volume) << name;
      EXPECT_NEAR(
        *result.volumeAfter, *describeMesh(withPoints(mesh, result.points)).volume, 1e-9 * volume)
        << name;
      EXPECT_NEAR(*result.volumeAfter / volume, 1.0, 0.01) << name << " noise " << deviation;
    }
  }
}

TEST(Relax, KeepsTheEdgesOfANoisyCubeWhenAsked)
{
  constexpr Index kSquares = 30;
  for (const double deviation : { 0.1, 0.25 })
  {
    const TriMesh mesh = noisy(cube(kSquares), deviation * 2.0 / kSquares);
    const RelaxResult without = run(mesh);
    const RelaxResult with = run(mesh, { .featureAngle = 40.0 });
    const Sharpness sharp = sharpnessOf(withPoints(mesh, with.points), 60.0);
    const double before = rmsOf(mesh.points, distanceFromCube);
    const double after = rmsOf(with.points, distanceFromCube);
    std::cout << "noise of " << deviation << " edges: rms " << before << " -> " << after
              << ", without the option " << rmsOf(without.points, distanceFromCube) << "; "
              << with.featureEdges << " feature edges, " << with.featureCorners << " corners; "
              << sharp.edges << " sharp edges of " << sharp.bend << " degrees, "
              << sharp.distance * kSquares / 2.0 << " edges from the true ones\n";
    EXPECT_EQ(with.featureCorners, 8U);
    EXPECT_NEAR(static_cast<double>(with.featureEdges), 12.0 * kSquares, 10.0);
    EXPECT_NEAR(static_cast<double>(sharp.edges), 12.0 * kSquares, 18.0);
    EXPECT_NEAR(sharp.bend, 90.0, 3.0);
    EXPECT_LT(sharp.distance, 0.15 * 2.0 / kSquares);
    EXPECT_GT(before, 4.0 * after);
    EXPECT_EQ(without.featureEdges, 0U);
    EXPECT_LT(sharpnessOf(withPoints(mesh, without.points), 60.0).edges, 20U);
  }
}

TEST(Relax, FindsNoEdgesInTheNoiseOfAPlane)
{
  const TriMesh mesh = noisy(sheet(60, 0.0), 0.25 * 2.0 / 60);
  const RelaxResult result = run(mesh, { .featureAngle = 30.0 });
  EXPECT_EQ(result.featureEdges, 0U);
}

TEST(Relax, KeepsTheBoundaryByDefaultAndRelaxesItAlongItselfWhenAsked)
{
  const TriMesh mesh = noisy(sheet(40, 0.0), 0.2 * 2.0 / 40);
  const RelaxResult kept = run(mesh);
  const RelaxResult along = run(mesh, { .boundary = Boundary::relax });
  const auto fromRim = [](const Vec3& p)
  { return std::hypot(std::max(std::abs(p.x), std::abs(p.y)) - 1.0, p.z); };
  std::vector<Vec3> before;
  std::vector<Vec3> after;
  for (Index i = 0; i <= 40; ++i)
  {
    for (Index j = 0; j <= 40; ++j)
    {
      const Index point = i * 41 + j;
      if (i % 40 == 0 || j % 40 == 0)
      {
        EXPECT_EQ(kept.points[point], mesh.points[point]);
        if ((i + 5) % 40 > 10 || (j + 5) % 40 > 10) // away from the corners, which get round
        {
          before.push_back(mesh.points[point]);
          after.push_back(along.points[point]);
        }
      }
    }
  }
  EXPECT_GT(rmsOf(before, fromRim), 1.8 * rmsOf(after, fromRim));
}

TEST(Relax, LeavesWhatIsOutsideTheRegionBitForBitAndMakesNoStep)
{
  const TriMesh mesh = noisy(ball(30), 0.01);
  std::vector<std::uint8_t> inRegion(mesh.points.size());
  std::ranges::transform(
    mesh.points, inRegion.begin(), [](const Vec3& p) { return p.x > 0.2 ? 1 : 0; });
  for (const double angle : { 0.0, 30.0 })
  {
    Execution execution(2);
    const RelaxResult result = relax(mesh, inRegion, { .featureAngle = angle }, execution);
    double atBorder = 0.0;
    double inside = 0.0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      EXPECT_TRUE(inRegion[i] != 0 || result.points[i] == mesh.points[i]);
    }
    for (const Triangle& triangle : mesh.triangles)
    {
      const auto shift = [&](Index p) { return result.points[p] - mesh.points[p]; };
      const double change = length(shift(triangle[0]) - shift(triangle[1]));
      double& largest = inRegion[triangle[0]] != inRegion[triangle[1]] ? atBorder : inside;
      largest = std::max(largest, change);
    }
    EXPECT_LT(atBorder, inside);
    EXPECT_LT(result.moved, mesh.points.size() / 2);
  }
}

TEST(Relax, NeverMovesAPointFartherThanAllowed)
{
  const TriMesh torus = noisy(corpus::torus(40), 0.05);
  for (const double angle : { 0.0, 30.0 })
  {
    for (const double offset : { 0.0, 1e6 })
    {
      TriMesh mesh = torus;
      std::ranges::for_each(mesh.points, [&](Vec3& p) { p.x += offset; });
      for (const double limit : { 1e-7, 0.01, 0.05 })
      {
        const RelaxResult result = run(mesh, { .featureAngle = angle, .maxDeviation = limit });
        EXPECT_LE(largestShift(mesh.points, result.points), limit);
        EXPECT_EQ(result.largestShift, largestShift(mesh.points, result.points));
        EXPECT_GT(result.limited, limit < 0.05 ? mesh.points.size() / 4 : 0);
      }
      EXPECT_EQ(run(mesh, { .featureAngle = angle }).limited, 0U);
    }
  }
  EXPECT_EQ(run(torus, { .maxDeviation = 0.0 }).points, torus.points);
}

TEST(Relax, FollowsTheSurfaceWhereverItIs)
{
  const TriMesh mesh = noisy(ball(20), 0.02);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const auto moved = [&](const Vec3& p)
  {
    return Vec3{ c * p.x - s * p.y, 0.6 * (s * p.x + c * p.y) - 0.8 * p.z,
      0.8 * (s * p.x + c * p.y) + 0.6 * p.z } *
      3.0 +
      Vec3{ 50, -70, 20 };
  };
  TriMesh elsewhere = mesh;
  std::ranges::transform(mesh.points, elsewhere.points.begin(), moved);
  for (const double angle : { 0.0, 45.0 })
  {
    const RelaxOptions options{ .featureAngle = angle };
    std::vector<Vec3> expected = run(mesh, options).points;
    std::ranges::transform(expected, expected.begin(), moved);
    EXPECT_LT(largestShift(run(elsewhere, options).points, expected), 1e-5);
  }
}

TEST(Relax, DoesNotDependOnTheOrderOfThePoints)
{
  const TriMesh mesh = noisy(ball(60), 0.005);
  ASSERT_GT(mesh.points.size(), 20000U);
  std::vector<Index> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  for (std::size_t i = order.size() - 1; i > 0; --i)
  {
    std::swap(order[i], order[random.below(i + 1)]);
  }
  TriMesh mixed = mesh;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    mixed.points[order[i]] = mesh.points[i];
  }
  for (Triangle& triangle : mixed.triangles)
  {
    std::ranges::transform(triangle, triangle.begin(), [&](Index p) { return order[p]; });
  }
  const std::vector<Vec3> expected = run(mesh).points;
  const std::vector<Vec3> found = run(mixed).points;
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    largest = std::max(largest, length(found[order[i]] - expected[i]));
  }
  EXPECT_LT(largest, 1e-6);
  EXPECT_EQ(found, run(mixed, {}, 1).points);
}

/// Meshes that are not what one would like.
std::vector<std::pair<std::string, TriMesh>> awkwardMeshes()
{
  TriMesh collapsed = ball(4);
  collapsed.triangles.push_back({ 3, 3, 5 });
  TriMesh flat = ball(4);
  flat.points[7] = flat.points[8];
  TriMesh lonely = ball(4);
  lonely.points.push_back({ 9, 9, 9 });
  TriMesh turned = ball(6);
  for (std::size_t t = 0; t < turned.triangles.size(); t += 3)
  {
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
  }
  TriMesh twice = ball(3);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  TriMesh equal = ball(5);
  std::ranges::fill(equal.points, Vec3{ 1, 2, 3 });
  return { { "nothing", {} }, { "points", { { { 1, 2, 3 } }, {} } },
    { "triangle", { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } } },
    { "square", corpus::square() }, { "tetrahedron", corpus::tetrahedron() },
    { "two on an edge", corpus::tetrahedraOnOneEdge() },
    { "two on a point", corpus::tetrahedraOnOnePoint() }, { "moebius", corpus::moebius() },
    { "collapsed", collapsed }, { "flat", flat }, { "lonely", lonely }, { "turned", turned },
    { "twice", twice }, { "equal", equal },
    { "voxels",
      corpus::voxelBorder(
        4, [](Index i, Index j, Index k) { return (i * 7 + j * 5 + k * 3) % 4 != 0; }) } };
}

TEST(Relax, TakesAwkwardMeshesAndLeavesWhatIsNoSurface)
{
  for (const auto& [name, mesh] : awkwardMeshes())
  {
    for (const Boundary boundary : { Boundary::keep, Boundary::relax })
    {
      for (const double angle : { 0.0, 30.0 })
      {
        const RelaxResult result = run(mesh, { .boundary = boundary, .featureAngle = angle });
        ASSERT_EQ(result.points.size(), mesh.points.size()) << name;
        for (const Vec3& p : result.points)
        {
          EXPECT_TRUE(std::isfinite(p.x + p.y + p.z)) << name;
        }
        if (mesh.triangles.size() <= 8 || name == "twice" || name == "equal")
        {
          EXPECT_EQ(result.points, mesh.points) << name;
        }
        if (name == "collapsed")
        {
          EXPECT_EQ(result.points[3], mesh.points[3]);
          EXPECT_EQ(result.points[5], mesh.points[5]);
          EXPECT_NE(result.points[20], mesh.points[20]);
        }
        if (name == "lonely")
        {
          EXPECT_EQ(result.points.back(), mesh.points.back());
        }
      }
    }
  }
}

TEST(Relax, IsTheSameOnAnyNumberOfThreadsAndKeepsItsPromisesWhateverTheOptions)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  for (int i = 0; i < 20; ++i)
  {
    const std::array<TriMesh, 4> meshes{ ball(40), corpus::torus(90), sheet(80), cube(30) };
    const TriMesh mesh = noisy(meshes.at(random.below(4)), 0.01 * random.unit(), random.next());
    RelaxOptions options;
    options.iterations = 1 + static_cast<int>(random.below(60));
    options.lambda = 0.1 + 0.58 * random.unit();
    options.mu = -options.lambda - 0.03 * random.unit() - 1e-6;
    options.boundary = random.below(2) == 0 ? Boundary::keep : Boundary::relax;
    options.featureAngle = random.below(3) == 0 ? 20.0 + 60.0 * random.unit() : 0.0;
    options.maxDeviation = random.below(2) == 0 ? 0.03 * random.unit() : 1e9;
    std::vector<std::uint8_t> inRegion(mesh.points.size());
    const double border = 4.0 * random.unit() - 2.0;
    std::ranges::transform(
      mesh.points, inRegion.begin(), [&](const Vec3& p) { return p.x + p.y > border ? 1 : 0; });
    Execution one(1);
    Execution three(3);
    const RelaxResult result = relax(mesh, inRegion, options, one);
    EXPECT_EQ(result.points, relax(mesh, inRegion, options, three).points)
      << "SCAN_TEST_SEED=" << seed << " round " << i;
    EXPECT_LE(largestShift(mesh.points, result.points), options.maxDeviation);
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      ASSERT_TRUE(inRegion[p] != 0 || result.points[p] == mesh.points[p])
        << "SCAN_TEST_SEED=" << seed << " round " << i;
    }
  }
}

/// Without a largest deviation many steps are taken at once, as the sum of a series.
TEST(Relax, ManyStepsAtOnceAreThoseSteps)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  for (int i = 0; i < 30; ++i)
  {
    const std::array<TriMesh, 4> meshes{ ball(30), corpus::torus(60), sheet(50), cube(20) };
    const TriMesh mesh = noisy(meshes.at(random.below(4)), 0.02 * random.unit(), random.next());
    RelaxOptions options;
    options.iterations = 1 + static_cast<int>(random.below(i < 3 ? 1000 : i < 10 ? 10 : 150));
    options.lambda = 0.1 + 0.58 * random.unit();
    options.mu = -options.lambda - 0.03 * random.unit() - 1e-6;
    options.boundary = random.below(2) == 0 ? Boundary::keep : Boundary::relax;
    const bool areNormalsAnew = options.iterations > 10; // near edges the least change turns them
    options.featureAngle = areNormalsAnew ? 0.0 : 20.0 + 60.0 * random.unit();
    const RelaxResult atOnce = run(mesh, options);
    options.maxDeviation = 1e9;
    const RelaxResult oneByOne = run(mesh, options);
    EXPECT_LT(largestShift(atOnce.points, oneByOne.points), 2e-5 * oneByOne.largestShift)
      << "SCAN_TEST_SEED=" << seed << " round " << i << " iterations " << options.iterations
      << " lambda " << options.lambda << " mu " << options.mu << " features "
      << options.featureAngle << " points " << mesh.points.size();
  }
}

TEST(ChebyshevSeries, IsThePolynomialAndLosesNoMoreThanItMay)
{
  const auto f = [](double x) { return ((3.0 * x - 1.0) * x + 0.5) * x - 2.0; };
  const std::vector<double> exact = chebyshevSeries(4, f);
  // x^2 = (T_0 + T_2) / 2, x^3 = (3 T_1 + T_3) / 4
  const std::array<double, 4> expected{ -2.0 - 0.5, 0.5 + 9.0 / 4.0, -0.5, 3.0 / 4.0 };
  ASSERT_EQ(exact.size(), expected.size());
  for (std::size_t m = 0; m < expected.size(); ++m)
  {
    EXPECT_NEAR(exact[m], expected.at(m), 1e-14);
  }
  const auto bell = [](double x) { return std::exp(-30.0 * (x - 1.0) * (x - 1.0)); };
  for (const double tolerance : { 1e-12, 1e-6, 1e-2 })
  {
    std::vector<double> series = chebyshevSeries(200, bell);
    truncate(series, tolerance);
    EXPECT_LT(series.size(), tolerance < 1e-9 ? 60U : 40U);
    double worst = 0.0;
    for (double angle = 0.0; angle <= pi; angle += 0.01)
    {
      double sum = 0.0;
      for (std::size_t m = 0; m < series.size(); ++m)
      {
        sum += series[m] * std::cos(static_cast<double>(m) * angle);
      }
      worst = std::max(worst, std::abs(sum - bell(std::cos(angle))));
    }
    EXPECT_LT(worst, tolerance + 1e-14);
    EXPECT_GT(worst, 1e-3 * tolerance);
  }
  std::vector<double> nothing{ 1e-9, 1e-9 };
  truncate(nothing, 1e-6);
  EXPECT_TRUE(nothing.empty());
}

/// From a noisy sphere, of triangles of many sizes.
TEST(SmoothNormals, AreNearerToTheTruthThanThoseOfTheTrianglesAround)
{
  Random random(pointSeed());
  TriMesh mesh = cube(40);
  for (Vec3& p : mesh.points)
  {
    p = unitVector(p + noise(random, 0.008));
  }
  const std::vector<Vec3> truth = mesh.points;
  std::ranges::for_each(mesh.points, [&](Vec3& p) { p = p + noise(random, 0.002); });
  Execution execution(2);
  const PointLinks links = linkPoints(mesh, execution);
  std::vector<std::uint8_t> isSharp(mesh.points.size(), 0);
  isSharp[7] = 1;
  SmoothNormals normals({ mesh.triangles, links.triangles, links.neighbours, isSharp });
  LargeArray<Float4> places(mesh.points.size());
  std::ranges::transform(
    mesh.points, places.begin(), [](const Vec3& p) { return narrowed(p, 1.0); });
  normals.compute(places, execution);
  const std::vector<Vec3> around = vertexNormals(mesh);
  double ofMeans = 0.0;
  double ofTriangles = 0.0;
  for (Index i = 0; i < truth.size(); ++i)
  {
    const Vec3 normal = widened(normals.of(i), 1.0);
    if (i == 7)
    {
      EXPECT_EQ(normal, Vec3{});
      continue;
    }
    EXPECT_NEAR(length(normal), 1.0, 1e-6);
    ofMeans += std::pow(length(normal - truth[i]), 2);
    ofTriangles += std::pow(length(around[i] - truth[i]), 2);
  }
  EXPECT_LT(ofMeans, ofTriangles / (15.0 * 15.0)); // 25 times nearer
}

TEST(Relax, RefusesWeightsThatWouldShrinkOrExplode)
{
  const TriMesh mesh = ball(4);
  for (const auto& [lambda, mu] : { std::pair{ 0.0, -0.1 }, std::pair{ 1.1, -1.1 },
         std::pair{ 0.5, -0.5 }, std::pair{ 0.5, -0.3 }, std::pair{ 0.5, -1.2 },
         std::pair{ 0.5, 0.6 }, std::pair{ 0.72, -0.725 }, std::pair{ 1.0, -1.05 },
         std::pair{ std::nan(""), -0.6 }, std::pair{ 0.5, std::nan("") } })
  {
    try
    {
      run(mesh, { .lambda = lambda, .mu = mu });
      ADD_FAILURE() << lambda << " " << mu;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::badParameter);
    }
  }
}

TEST(Relax, RefusesWhatIsNoMesh)
{
  TriMesh missing = ball(4);
  missing.triangles.push_back({ 0, 1, 4000000 });
  TriMesh nowhere = ball(4);
  nowhere.points[7].y = std::nan("");
  TriMesh huge = ball(4);
  std::ranges::for_each(huge.points, [](Vec3& p) { p = p * 1e200; });
  for (const TriMesh& mesh : { missing, nowhere, huge })
  {
    try
    {
      run(mesh);
      ADD_FAILURE() << "accepted";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::badInput);
    }
  }
}

TEST(Relax, StopsWhereverItIsCancelled)
{
  const TriMesh mesh = ball(30);
  for (const double at : { 0.0, 0.2, 0.5, 0.9 })
  {
    const CancelToken token;
    double last = -1.0;
    Execution stopping(2, token,
      [&](std::string_view, double fraction)
      {
        EXPECT_GE(fraction, last);
        last = fraction;
        if (fraction >= at)
        {
          token.cancel();
        }
      });
    stopping.plan({ { "features", 1.0 }, { "relax", 1.0 } });
    EXPECT_THROW(
      relax(mesh, everywhere(mesh.points), { .featureAngle = 30.0 }, stopping), Cancelled);
    EXPECT_LT(last, at + 0.2);
  }
}

} // namespace
} // namespace scan::test
