// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region.h"

#include "filters/base/error.h"
#include "filters/geometry/mean_curvature.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/random_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

using namespace scan;

namespace
{

using Flags = std::vector<std::uint8_t>;

Flags chosen(const std::string& rule, const TriMesh& mesh, unsigned threads = 0)
{
  Execution execution(threads);
  const RegionElements elements =
    mesh.triangles.empty() ? RegionElements::points : RegionElements::triangles;
  return chooseElements(parseRegionRule(rule), { mesh, elements, 0.0, {} }, execution);
}

std::ptrdiff_t countOf(const Flags& flags)
{
  return std::ranges::count(flags, 1);
}

/// Random points of the cube [-1, 1]^3.
TriMesh cloud(std::size_t count, std::uint64_t seed = 7)
{
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  TriMesh mesh;
  for (std::size_t i = 0; i < count; ++i)
  {
    mesh.points.push_back({ at(random), at(random), at(random) });
  }
  return mesh;
}

/// Points of a sphere, spread evenly along a spiral.
std::vector<Vec3> spherePoints(std::size_t count, double radius, const Vec3& centre = {})
{
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
    const double angle = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double across = std::sqrt(1.0 - z * z);
    points.push_back(
      centre + Vec3{ across * std::cos(angle), across * std::sin(angle), z } * radius);
  }
  return points;
}

TriMesh moved(TriMesh mesh, const Vec3& way)
{
  for (Vec3& p : mesh.points)
  {
    p = p + way;
  }
  return mesh;
}

TriMesh joined(TriMesh a, const TriMesh& b)
{
  const auto first = static_cast<Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const auto& [i, j, k] : b.triangles)
  {
    a.triangles.push_back({ first + i, first + j, first + k });
  }
  return a;
}

TriMesh twoTori()
{
  return joined(corpus::torus(20), moved(corpus::torus(24), { 20, 0, 0 }));
}

TriMesh pointsOf(TriMesh mesh)
{
  mesh.triangles.clear();
  return mesh;
}

/// Expects that a rule chooses the points of a cloud, and the triangles on them by their centroids,
/// that are inside by definition.
template <class Inside>
void expectShape(const std::string& rule, const Inside& inside)
{
  TriMesh mesh = cloud(3000);
  const Flags ofPoints = chosen(rule, mesh);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    ASSERT_EQ(ofPoints[i] != 0, inside(mesh.points[i])) << rule << " point " << i;
  }
  EXPECT_GT(countOf(ofPoints), 0) << rule;
  EXPECT_LT(countOf(ofPoints), 3000) << rule;
  for (Index i = 0; i + 2 < mesh.points.size(); i += 3)
  {
    mesh.triangles.push_back({ i, i + 1, i + 2 });
  }
  const Flags ofTriangles = chosen(rule, mesh);
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const Vec3 middle =
      (mesh.points[3 * t] + mesh.points[3 * t + 1] + mesh.points[3 * t + 2]) * (1.0 / 3.0);
    ASSERT_EQ(ofTriangles[t] != 0, inside(middle)) << rule << " triangle " << t;
  }
}

TEST(Region, ShapesAreWhatTheyAreDefinedToBe)
{
  expectShape("box(0.5,-1,0, -0.5,0.25,1)",
    [](const Vec3& p)
    { return std::abs(p.x) <= 0.5 && p.y <= 0.25 && p.y >= -1 && p.z >= 0 && p.z <= 1; });
  expectShape(
    "sphere(0.1,0,0, 0.7)", [](const Vec3& p) { return std::hypot(p.x - 0.1, p.y, p.z) <= 0.7; });
  expectShape(
    "plane(0,0,0.2, 0,-3,4)", [](const Vec3& p) { return -3.0 * p.y + 4.0 * (p.z - 0.2) >= 0.0; });
  expectShape("brush(0.4, -0.5,0,0, 0.5,0,0)",
    [](const Vec3& p) { return std::hypot(std::max(std::abs(p.x) - 0.5, 0.0), p.y, p.z) <= 0.4; });
  expectShape("brush(0.4, 0,0,0)", [](const Vec3& p) { return std::hypot(p.x, p.y, p.z) <= 0.4; });
  expectShape("brush(0.3, 0,0,0, 0.5,0,0, 0.5,0.5,0)",
    [](const Vec3& p)
    {
      const double first = std::hypot(p.x - std::clamp(p.x, 0.0, 0.5), p.y, p.z);
      const double second = std::hypot(p.x - 0.5, p.y - std::clamp(p.y, 0.0, 0.5), p.z);
      return std::min(first, second) <= 0.3;
    });
}

TEST(Region, SidesShowTheAxesOfTheModelAsPicturesDo)
{
  const auto seen = [](const std::string& view, auto right, auto up)
  {
    expectShape("rectangle(" + view + ", 0.1,0.9, 0.7,-0.2)",
      [&](const Vec3& p)
      { return right(p) >= 0.1 && right(p) <= 0.7 && up(p) >= -0.2 && up(p) <= 0.9; });
  };
  const auto x = [](const Vec3& p) { return p.x; };
  const auto y = [](const Vec3& p) { return p.y; };
  const auto z = [](const Vec3& p) { return p.z; };
  const auto minus = [](auto axis) { return [axis](const Vec3& p) { return -axis(p); }; };
  seen("front", x, z);
  seen("back", minus(x), z);
  seen("left", minus(y), z);
  seen("right", y, z);
  seen("top", x, y);
  seen("bottom", x, minus(y));
  seen("along(0,2,0, 0,0,9)", x, z);
  seen("along(0,0,-1, 0,1,0)", x, y);
}

TEST(Region, DepthKeepsWhatIsNotBehindThePlane)
{
  expectShape("depth(front, 9,0.1,9)", [](const Vec3& p) { return p.y <= 0.1; });
  expectShape("depth(top, 9,9,0.1)", [](const Vec3& p) { return p.z >= 0.1; });
  expectShape(
    "depth(from(0,-5,0, 0,0,0, 0,0,1), 9,0.1,9)", [](const Vec3& p) { return p.y <= 0.1; });
}

TEST(Region, APerspectiveMeasuresAtItsTargetAndSeesNothingBehindTheEye)
{
  expectShape("rectangle(from(0,-0.5,0, 0,0.5,0, 0,0,1), -0.6,-0.4, 0.6,0.4)",
    [](const Vec3& p)
    {
      const double scale = 1.0 / (p.y + 0.5);
      return p.y > -0.5 && std::abs(p.x * scale) <= 0.6 && std::abs(p.z * scale) <= 0.4;
    });
}

TEST(Region, APolygonFollowsTheEvenOddRule)
{
  const std::uint64_t seed = test::testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  const TriMesh mesh = cloud(400);
  for (int round = 0; round < 50; ++round)
  {
    std::vector<Vec3> corners;
    std::string rule = "polygon(top";
    for (std::uint64_t i = 0; i < 3 + random() % 200; ++i)
    {
      const std::string x = test::randomNumber(random);
      const std::string y = test::randomNumber(random);
      corners.push_back({ std::stod(x), std::stod(y), 0.0 });
      rule += ", " + x + ", " + y;
    }
    const Flags flags = chosen(rule + ")", mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const Vec3& p = mesh.points[i];
      bool isInside = false;
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        const Vec3& a = corners[k];
        const Vec3& b = corners[(k + 1) % corners.size()];
        isInside ^=
          (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
      }
      ASSERT_EQ(flags[i] != 0, isInside) << rule;
    }
  }
}

TEST(Region, PolygonsSideBySideShareThePointsOut)
{
  TriMesh grid;
  for (int i = 0; i <= 20; ++i)
  {
    for (int j = 0; j <= 20; ++j)
    {
      grid.points.push_back({ 0.1 * i, 0.1 * j, 0.0 });
    }
  }
  // the square and its two halves along each diagonal: corners and sides pass through points
  const Flags whole = chosen("polygon(top, 0,0, 2,0, 2,2, 0,2)", grid);
  for (const auto& [a, b] :
    { std::pair("0,0, 2,0, 2,2", "0,0, 2,2, 0,2"), std::pair("0,0, 2,0, 0,2", "0,2, 2,0, 2,2") })
  {
    const Flags first = chosen(std::string("polygon(top, ") + a + ")", grid);
    const Flags second = chosen(std::string("polygon(top, ") + b + ")", grid);
    for (std::size_t i = 0; i < whole.size(); ++i)
    {
      ASSERT_EQ(first[i] + second[i], whole[i]) << i;
    }
  }
  EXPECT_EQ(countOf(whole), 400);
}

TEST(Region, ALassoWithADepthPlaneTakesTheNearWallOfATube)
{
  TriMesh tube;
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = 2.4 * i;
    tube.points.push_back({ std::cos(angle), std::sin(angle), 0.003 * i });
  }
  std::string lasso = "polygon(front";
  for (int i = 0; i < 300; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / 300.0;
    lasso += ", " + std::to_string(0.8 * std::cos(angle)) + ", " +
      std::to_string(3.0 + 2.0 * std::sin(angle));
  }
  const Flags through = chosen(lasso + ")", tube);
  const Flags near = chosen(lasso + ") & depth(front, 0,0,0)", tube);
  for (std::size_t i = 0; i < tube.points.size(); ++i)
  {
    ASSERT_EQ(near[i], through[i] != 0 && tube.points[i].y <= 0.0 ? 1 : 0);
  }
  EXPECT_GT(countOf(near), 250);
  EXPECT_NEAR(
    static_cast<double>(countOf(through)), 2.0 * static_cast<double>(countOf(near)), 20.0);
}

TEST(Region, OperatorsFollowTheLawsOfSets)
{
  const std::uint64_t seed = test::testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  const TriMesh mesh = cloud(300);
  for (int round = 0; round < 60; ++round)
  {
    const std::string a = "(" + test::randomRule(random, 3) + ")";
    const std::string b = "(" + test::randomRule(random, 3) + ")";
    const Flags ofA = chosen(a, mesh);
    const Flags ofB = chosen(b, mesh);
    const Flags both = chosen(a + " & " + b, mesh);
    const Flags either = chosen(a + " + " + b, mesh);
    const Flags without = chosen(a + " - " + b, mesh);
    for (std::size_t i = 0; i < ofA.size(); ++i)
    {
      ASSERT_EQ(both[i], ofA[i] & ofB[i]) << a << b;
      ASSERT_EQ(either[i], ofA[i] | ofB[i]) << a << b;
      ASSERT_EQ(without[i], ofA[i] == 1 && ofB[i] == 0 ? 1 : 0) << a << b;
    }
    EXPECT_EQ(chosen("!!" + a, mesh), ofA);
    EXPECT_EQ(chosen("!(" + a + " & " + b + ")", mesh), chosen("!" + a + " + !" + b, mesh));
    EXPECT_EQ(chosen(a + " - " + b + " - " + a, mesh), chosen("none", mesh));
    EXPECT_EQ(chosen(a + " + !" + a, mesh), chosen("all", mesh));
  }
}

TEST(Region, RegionAndOppositeShareTheTrianglesOut)
{
  const TriMesh torus = corpus::torus(30);
  const std::string rule = "plane(0,0,0, 1,0.3,0.1)";
  EXPECT_EQ(countOf(chosen(rule, torus)) + countOf(chosen("!" + rule, torus)),
    static_cast<std::ptrdiff_t>(torus.triangles.size()));
}

/// The triangles that share a point with one that is chosen, by definition.
Flags oneRing(const TriMesh& mesh, Flags flags)
{
  std::set<Index> corners;
  for (std::size_t t = 0; t < flags.size(); ++t)
  {
    if (flags[t] != 0)
    {
      corners.insert(mesh.triangles[t].begin(), mesh.triangles[t].end());
    }
  }
  for (std::size_t t = 0; t < flags.size(); ++t)
  {
    flags[t] = std::ranges::any_of(
      mesh.triangles[t], [&](Index corner) { return corners.contains(corner); });
  }
  return flags;
}

TEST(Region, GrowAndShrinkAreOpposites)
{
  const std::uint64_t seed = test::testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  const TriMesh torus = corpus::torus(24);
  for (const TriMesh& mesh : { torus, pointsOf(torus) })
  {
    for (int round = 0; round < 10; ++round)
    {
      const std::string a = "brush(1, " + test::randomNumbers(random, 6) + ")";
      EXPECT_EQ(chosen("shrink(" + a + ", 2)", mesh), chosen("!grow(!" + a + ", 2)", mesh));
      EXPECT_EQ(chosen("grow(" + a + ", 0)", mesh), chosen(a, mesh));
      EXPECT_EQ(chosen("grow(grow(" + a + ", 1), 2)", mesh), chosen("grow(" + a + ", 3)", mesh));
      const std::string opened = "grow(shrink(" + a + ", 1), 1)";
      EXPECT_EQ(chosen("grow(shrink(" + opened + ", 1), 1)", mesh), chosen(opened, mesh));
      EXPECT_EQ(countOf(chosen(opened + " - " + a, mesh)), 0);
      EXPECT_EQ(countOf(chosen(a + " - shrink(grow(" + a + ", 1), 1)", mesh)), 0);
      if (!mesh.triangles.empty())
      {
        EXPECT_EQ(chosen("grow(" + a + ", 1)", mesh), oneRing(mesh, chosen(a, mesh)));
      }
    }
  }
}

TEST(Region, ComponentIsOneOfTwoTori)
{
  const TriMesh tori = twoTori();
  const auto ofFirst = static_cast<std::ptrdiff_t>(corpus::torus(20).triangles.size());
  const auto all = static_cast<std::ptrdiff_t>(tori.triangles.size());
  const Flags first = chosen("component(0,0,0)", tori);
  EXPECT_EQ(countOf(first), ofFirst);
  EXPECT_EQ(std::count(first.begin(), first.begin() + ofFirst, 1), ofFirst);
  EXPECT_EQ(chosen("component(99,0,0)", tori), chosen("!component(0,0,0)", tori));
  EXPECT_EQ(chosen("component(triangles(5))", tori), first);
  EXPECT_EQ(countOf(chosen("component(triangles(5, " + std::to_string(all - 1) + "))", tori)), all);
  EXPECT_EQ(countOf(chosen("component(none)", tori)), 0);
}

TEST(Region, ComponentOfPointsIsOneOfTwoSpheres)
{
  TriMesh scan;
  scan.points = spherePoints(1500, 1.0);
  const std::vector<Vec3> other = spherePoints(3000, 1.0, { 2.3, 0, 0 });
  scan.points.insert(scan.points.end(), other.begin(), other.end());
  scan.points.push_back({ 0, 0, 5 });    // stray
  scan.points.push_back(scan.points[3]); // repeated, more often than there are neighbours
  scan.points.insert(scan.points.end(), 40, scan.points[4]);
  const Flags first = chosen("component(0,0,0)", scan);
  EXPECT_EQ(std::count(first.begin(), first.begin() + 1500, 1), 1500);
  EXPECT_EQ(countOf(first), 1541);
  EXPECT_EQ(countOf(chosen("component(2.3,0,0)", scan)), 3000);
  EXPECT_EQ(countOf(chosen("component(points(4500))", scan)), 1);
  EXPECT_EQ(countOf(chosen("grow(points(4500), 3)", scan)), 1);
  EXPECT_EQ(countOf(chosen("grow(points(4), 1) & box(9,9,9,-9,-9,-9)", scan)),
    countOf(chosen("grow(points(4540), 1)", scan)));
}

TEST(Region, PointsOfAMeshAreConnectedByItsEdges)
{
  const TriMesh tori = twoTori();
  Execution execution;
  const RegionDomain domain{ tori, RegionElements::points, 0.0, {} };
  const Flags first = chooseElements(parseRegionRule("component(points(0))"), domain, execution);
  EXPECT_EQ(countOf(first), static_cast<std::ptrdiff_t>(corpus::torus(20).points.size()));
  const Flags grown = chooseElements(parseRegionRule("grow(points(0), 1)"), domain, execution);
  std::set<Index> around;
  for (const Triangle& triangle : tori.triangles)
  {
    if (std::ranges::find(triangle, 0U) != triangle.end())
    {
      around.insert(triangle.begin(), triangle.end());
    }
  }
  EXPECT_EQ(countOf(grown), static_cast<std::ptrdiff_t>(around.size()));
}

TEST(Region, ASphereIsCurvedByOneOverItsRadius)
{
  for (const double radius : { 0.01, 1.0, 5000.0 })
  {
    TriMesh scan;
    scan.points = spherePoints(2000, radius, { 3.0 * radius, 0, 0 });
    const auto between = [&](double low, double high)
    {
      return "curvature(" + std::to_string(low / radius) + ", " + std::to_string(high / radius) +
        ")";
    };
    EXPECT_EQ(countOf(chosen(between(0.97, 1.03), scan)), 2000) << radius;
    EXPECT_EQ(countOf(chosen(between(1.03, 9.0), scan)), 0) << radius;
  }
}

/// An octahedron, its triangles parted in four again and again, on a sphere.
TriMesh sphereMesh(double radius, int rounds)
{
  TriMesh mesh{ { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } } };
  for (int round = 0; round < rounds; ++round)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b)
    {
      const auto [place, isNew] =
        middles.try_emplace(std::minmax(a, b), static_cast<Index>(mesh.points.size()));
      if (isNew)
      {
        mesh.points.push_back((mesh.points[a] + mesh.points[b]) * 0.5);
      }
      return place->second;
    };
    std::vector<Triangle> parts;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      parts.insert(parts.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh.triangles = parts;
  }
  for (Vec3& p : mesh.points)
  {
    p = p * (radius / std::sqrt(dot(p, p)));
  }
  return mesh;
}

TEST(Region, AMeshOfASphereIsCurvedByOneOverItsRadius)
{
  const TriMesh sphere = sphereMesh(4.0, 4);
  EXPECT_EQ(countOf(chosen("curvature(0.24, 0.26)", sphere)), 2048);
  EXPECT_EQ(countOf(chosen("curvature(0, 0.24)", sphere)), 0);
}

TEST(Region, AMeshHasTheCurvatureOfItsOwnSideOfAThinWall)
{
  // two spheres, nearer to each other than their points are to theirs
  TriMesh mesh = joined(sphereMesh(4.0, 4), sphereMesh(3.9, 4));
  EXPECT_EQ(countOf(chosen("curvature(0.24, 0.27)", mesh)), 4096);
}

TEST(Region, MeanCurvatureOfCylinderPlaneAndTooFewPoints)
{
  std::vector<Vec3> cylinder;
  std::vector<Vec3> plane;
  for (int i = -3; i <= 3; ++i)
  {
    for (int j = -3; j <= 3; ++j)
    {
      cylinder.push_back({ 2.0 * std::sin(0.05 * i), 2.0 * std::cos(0.05 * i), 0.1 * j });
      plane.push_back({ 0.1 * i, 0.1 * j, 0.3 * i + 0.1 * j });
    }
  }
  EXPECT_NEAR(meanCurvature({ 0, 2, 0 }, cylinder), 0.25, 0.005);
  EXPECT_NEAR(meanCurvature({ 0, 0, 0 }, plane), 0.0, 1e-9);
  std::vector<Vec3> saddle; // z = x y / 2, from its corner
  for (const Vec3& p : plane)
  {
    saddle.push_back({ p.x, p.y, 0.5 * p.x * p.y });
  }
  EXPECT_NEAR(meanCurvature({ 0.3, 0.3, 0.045 }, saddle),
    0.5 * 0.15 * 0.15 / std::pow(1.0 + 2.0 * 0.15 * 0.15, 1.5), 0.001);
  EXPECT_TRUE(std::isnan(meanCurvature({ 0, 0, 0 }, std::span(plane).first(5))));
  EXPECT_TRUE(std::isnan(meanCurvature({ 1, 1, 1 }, std::vector<Vec3>(9, { 1, 1, 1 }))));
  EXPECT_NEAR(meanCurvature({ 0, 0, 0 },
                std::vector<Vec3>{
                  { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 }, { 5, 0, 0 }, { 6, 0, 0 } }),
    0.0, 1e-9);
}

TEST(Region, ArraysAreTakenByTheirValues)
{
  const TriMesh mesh = cloud(5);
  Execution execution;
  const RegionDomain domain{ mesh, RegionElements::points, 0.0,
    [](const std::string& name)
    {
      return name == "Deviation" ? std::vector{ -2.0, -1.0, 0.0, 1.0, std::nan("") }
                                 : std::vector(5, 7.0);
    } };
  const auto in = [&](const char* rule)
  { return chooseElements(parseRegionRule(rule), domain, execution); };
  EXPECT_EQ(in("deviation(-1, 0)"), (Flags{ 0, 1, 1, 0, 0 }));
  EXPECT_EQ(in("deviation(-inf, inf)"), (Flags{ 1, 1, 1, 1, 0 }));
  EXPECT_EQ(in("array(Size, 7, 7)"), Flags(5, 1));
  EXPECT_THROW(chosen("deviation(0, 1)", mesh), Error);
}

TEST(Region, NumbersAreForTheModelTheyCount)
{
  const TriMesh points = cloud(5);
  EXPECT_EQ(chosen("points(1, 3, 1)", points), (Flags{ 0, 1, 0, 1, 0 }));
  EXPECT_THROW(chosen("points(5)", points), Error);
  EXPECT_THROW(chosen("triangles(0)", points), Error);
  EXPECT_THROW(chosen("points(0)", corpus::tetrahedron()), Error);
  EXPECT_EQ(chosen("triangles(2)", corpus::tetrahedron()), (Flags{ 0, 0, 1, 0 }));
}

TEST(Region, LengthsMayHaveUnits)
{
  TriMesh mesh{ { { 0, 0, 0 }, { 30, 0, 0 }, { 0, 40, 0 } }, {} };
  EXPECT_EQ(chosen("sphere(0,0,0, 61%)", mesh), (Flags{ 1, 1, 0 }));
  Execution execution;
  EXPECT_EQ(chooseElements(parseRegionRule("sphere(0,0,0, 31cm)"),
              { mesh, RegionElements::points, 10.0, {} }, execution),
    (Flags{ 1, 1, 0 }));
}

TEST(Region, AnyModelMayBeEmptyOrDegenerate)
{
  for (const std::string rule : { "all", "!all", "grow(all,2)", "component(0,0,0)",
         "component(all)", "curvature(0,1)", "polygon(top,0,0,0,0,0,0)", "sphere(0,0,0,1)" })
  {
    EXPECT_EQ(chosen(rule, {}).size(), 0U) << rule;
    EXPECT_EQ(chosen(rule, { { { 1, 2, 3 } }, {} }).size(), 1U) << rule;
    EXPECT_EQ(chosen(rule, { std::vector<Vec3>(30, { 1, 2, 3 }), {} }).size(), 30U) << rule;
    EXPECT_EQ(
      chosen(rule, { std::vector<Vec3>(3, { 1, 2, 3 }), { { 0, 1, 2 }, { 0, 0, 0 } } }).size(), 2U)
      << rule;
    EXPECT_THROW(chosen(rule, { { { 1, 2, 3 } }, { { 0, 1, 2 } } }), Error) << rule;
  }
}

TEST(Region, AFanOfManyTrianglesTakesNoLongerThanOthers)
{
  TriMesh fan{ { { 0, 0, 0 } }, {} };
  constexpr Index kCount = 100000;
  for (Index i = 0; i < kCount; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * i / kCount;
    fan.points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    fan.triangles.push_back({ 0, i + 1, i + 2 > kCount ? 1 : i + 2 });
  }
  EXPECT_EQ(countOf(chosen("grow(plane(0,0,0, 1,0,0), 1)", fan)), kCount);
  EXPECT_EQ(countOf(chosen("curvature(0, 1)", fan)), kCount);
}

TEST(Region, TheSameOnAnyNumberOfThreads)
{
  TriMesh scan;
  scan.points = spherePoints(20000, 1.0);
  const TriMesh mesh = sphereMesh(1.0, 5);
  for (const std::string rule : { "curvature(0, 1)", "grow(sphere(1,0,0,0.3), 2)",
         "component(1,0,0) & polygon(front,0,0,1,0,0,1)", "shrink(!brush(10x,0,0,1,1,0,0), 1)" })
  {
    EXPECT_EQ(chosen(rule, scan, 1), chosen(rule, scan, 5)) << rule;
    EXPECT_EQ(chosen(rule, mesh, 1), chosen(rule, mesh, 5)) << rule;
  }
}

TEST(Region, StopsWhenCancelled)
{
  TriMesh scan;
  scan.points = spherePoints(1000, 1.0);
  for (const std::string rule : { "all", "curvature(0, 1)", "grow(all, 2)", "component(0,0,0)" })
  {
    const CancelToken token;
    token.cancel();
    Execution execution(1, token);
    EXPECT_THROW(
      chooseElements(parseRegionRule(rule), { scan, RegionElements::points, 0.0, {} }, execution),
      Cancelled);
  }
}

} // namespace
