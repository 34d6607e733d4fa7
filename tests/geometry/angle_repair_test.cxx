// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/angle_repair.h"

#include "filters/geometry/dihedral_angle.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/pushes.h"
#include "filters/geometry/single_tets.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <tuple>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

constexpr double kRadius = 0.6; // of the hole in the plate
constexpr double kStep = 0.1;   // spacing of its points

bool isNear(double a, double b)
{
  return std::abs(a - b) < 1e-6;
}

std::vector<Vec3> platePoints()
{
  return readPoints(std::string(SCAN_DATA_DIR) + "/plate_hole.xyz");
}

/// Which of the plate's feature lines a point is on: the rims of the hole, the twelve outer edges.
std::vector<int> linesOf(const Vec3& p)
{
  const bool isTop = isNear(p.z, 1.0);
  const bool isFlat = isTop || isNear(p.z, 0.0);
  const bool isAtX = isNear(std::abs(p.x), 2.0);
  const bool isAtY = isNear(std::abs(p.y), 2.0);
  std::vector<int> lines;
  if (isFlat && isNear(std::hypot(p.x, p.y), kRadius))
  {
    lines.push_back(isTop ? 1 : 0);
  }
  if (isFlat && isAtX)
  {
    lines.push_back(2 + (isTop ? 1 : 0) + (p.x > 0.0 ? 2 : 0));
  }
  if (isFlat && isAtY)
  {
    lines.push_back(6 + (isTop ? 1 : 0) + (p.y > 0.0 ? 2 : 0));
  }
  if (isAtX && isAtY)
  {
    lines.push_back(10 + (p.x > 0.0 ? 1 : 0) + (p.y > 0.0 ? 2 : 0));
  }
  return lines;
}

double distanceToLines(const Vec3& p)
{
  const double toFlat = std::min(std::abs(p.z), std::abs(p.z - 1.0));
  const double toX = std::abs(std::abs(p.x) - 2.0);
  const double toY = std::abs(std::abs(p.y) - 2.0);
  return std::min({ std::hypot(std::hypot(p.x, p.y) - kRadius, toFlat), std::hypot(toX, toFlat),
    std::hypot(toY, toFlat), std::hypot(toX, toY) });
}

bool isCorner(const Vec3& p)
{
  return linesOf(p).size() > 1;
}

using Edge = std::array<Vec3, 2>;

/// Edges that turn by more than 30 degrees, from the smaller to the larger point.
std::vector<Edge> featureEdges(const TriMesh& mesh)
{
  std::map<Segment, std::vector<Index>> apexes;
  for (const Triangle& v : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto [low, high] = std::minmax(v[k], v[(k + 1) % 3]);
      apexes[{ low, high }].push_back(v[(k + 2) % 3]);
    }
  }
  const auto& p = mesh.points;
  const auto isLess = [](const Vec3& a, const Vec3& b)
  { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::vector<Edge> features;
  for (const auto& [edge, apex] : apexes)
  {
    if (apex.size() == 2 &&
      dihedralAngle(p[edge[0]], p[edge[1]], p[apex[0]], p[apex[1]]) <
        std::numbers::pi * (1.0 - 30.0 / 180.0))
    {
      const auto [low, high] = std::minmax(p[edge[0]], p[edge[1]], isLess);
      features.push_back({ low, high });
    }
  }
  return features;
}

std::vector<Edge> featureEdges(const WrapModel& model)
{
  Execution execution(1);
  return featureEdges(surfaceOf(model, false, execution).surface);
}

/// Feature edges between points that share no feature line.
std::size_t countStray(const std::vector<Edge>& edges)
{
  return static_cast<std::size_t>(std::ranges::count_if(edges,
    [](const Edge& edge)
    {
      const std::vector<int> a = linesOf(edge[0]);
      const std::vector<int> b = linesOf(edge[1]);
      return std::ranges::find_first_of(a, b) == a.end();
    }));
}

/// The lines as chains of all their points: a rim has as many edges as points, another line one
/// less.
std::size_t countIdeal(const std::vector<Vec3>& points)
{
  std::size_t edges = 0;
  for (const Vec3& p : points)
  {
    edges += linesOf(p).size();
  }
  return edges - 12;
}

/// The plate without a part of the points on its feature lines; corners stay.
std::vector<Vec3> damaged(std::vector<Vec3> points, double part, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::erase_if(points,
    [&](const Vec3& p)
    {
      return !linesOf(p).empty() && !isCorner(p) &&
        std::ldexp(static_cast<double>(random() >> 11), -53) < part;
    });
  return points;
}

WrapModel openedPlate(const std::vector<Vec3>& points)
{
  Execution execution(1);
  WrapModel model = wrappedModel(points, Mode::classic);
  const auto& p = model.scan->delaunay().points;
  const Facet overHole = std::ranges::min(surfaceFacets(model), {},
    [&](Facet facet)
    {
      const Triangle v = model.scan->delaunay().facetVertices(facet);
      const Vec3 middle = (p[v[0]] + p[v[1]] + p[v[2]]) * (1.0 / 3.0);
      return std::hypot(middle.x, middle.y, middle.z - 1.0);
    });
  push(model, std::array{ overHole }, {}, { .deep = true }, execution);
  return model;
}

bool losesPoints(WrapResult before, WrapResult after)
{
  std::ranges::sort(before.scanPointIds);
  std::ranges::sort(after.scanPointIds);
  return !std::ranges::includes(after.scanPointIds, before.scanPointIds);
}

void expectSameTopologyAndAllPoints(const WrapModel& before, const WrapModel& after)
{
  Execution execution(1);
  const WrapResult was = surfaceOf(before, false, execution);
  const WrapResult is = surfaceOf(after, false, execution);
  EXPECT_FALSE(losesPoints(was, is));
  const MeshReport mesh = describeMesh(is.surface);
  EXPECT_TRUE(mesh.isClosed);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_EQ(mesh.eulerCharacteristic, describeMesh(was.surface).eulerCharacteristic);
}

TEST(RepairAngles, BitesAlongRimsAndEdgesAreGone)
{
  Execution execution(1);
  const std::vector<Vec3> all = platePoints();
  std::size_t strayBefore = 0;
  std::size_t strayAfter = 0;
  int clean = 0;
  for (std::uint64_t seed = testSeed(); seed < testSeed() + 8; ++seed)
  {
    SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
    const std::vector<Vec3> points = damaged(all, 0.05, seed);
    const WrapModel before = openedPlate(points);
    WrapModel model = before;
    const AngleRepairReport report = repairAngles(model, {}, {}, execution);
    expectReported(before, report, model);
    expectSameTopologyAndAllPoints(before, model);

    strayBefore += countStray(featureEdges(before));
    const std::vector<Edge> features = featureEdges(model);
    strayAfter += countStray(features);
    clean += countStray(features) == 0 && features.size() == countIdeal(points) ? 1 : 0;
    const auto& p = before.scan->delaunay().points;
    for (const auto* changed : { &report.surface.gone, &report.surface.added })
    {
      for (const Facet facet : *changed)
      {
        const Triangle v = model.scan->delaunay().facetVertices(facet);
        EXPECT_TRUE(
          std::ranges::any_of(v, [&](Index i) { return distanceToLines(p[i]) < 2.0 * kStep; }))
          << "a smooth part was changed";
      }
    }
  }
  // all of them, unless so many neighbours are missing that the line is no Delaunay edge
  EXPECT_GE(clean, 7) << "of 8, SCAN_TEST_SEED=" << testSeed();
  EXPECT_LE(strayAfter * 50, strayBefore) << "SCAN_TEST_SEED=" << testSeed();
}

TEST(RepairAngles, SolidModelsStaySolid)
{
  Execution execution(1);
  const WrapModel before = wrappedModel(damaged(platePoints(), 0.15, testSeed()), Mode::automatic);
  WrapModel model = before;
  const AngleRepairReport report = repairAngles(model, {}, {}, execution);
  expectReported(before, report, model);
  expectSameTopologyAndAllPoints(before, model);
  EXPECT_GT(report.flips, 0U);
  EXPECT_TRUE(model.isSolid);
  EXPECT_LT(countStray(featureEdges(model)), countStray(featureEdges(before)));
}

/// Points and triangles of an OFF file.
TriMesh readOff(const std::string& path)
{
  std::ifstream file(path);
  TriMesh mesh;
  std::string off;
  std::size_t points = 0;
  std::size_t triangles = 0;
  std::size_t edges = 0;
  file >> off >> points >> triangles >> edges;
  mesh.points.resize(points);
  mesh.triangles.resize(triangles);
  for (Vec3& p : mesh.points)
  {
    file >> p.x >> p.y >> p.z;
  }
  for (Triangle& v : mesh.triangles)
  {
    Index corners = 0;
    file >> corners >> v[0] >> v[1] >> v[2];
    EXPECT_EQ(corners, 3U);
  }
  return mesh;
}

TEST(RepairAngles, FandiskHasExactlyItsFeatureLines)
{
  const std::string path = std::string(SCAN_SHARED_DIR) + "/data/05_meshes/cgal/fandisk.off";
  if (!std::ifstream(path))
  {
    GTEST_SKIP() << "no " << path << "; set SCAN_SHARED_DIR to the larger corpus";
  }
  Execution execution(1);
  const TriMesh truth = readOff(path);
  WrapModel model = wrappedModel(truth.points, Mode::automatic);
  const auto sortedFeatures = [](const auto& of)
  {
    std::vector<Edge> edges = featureEdges(of);
    const auto coordinates = [](const Edge& e)
    { return std::tuple(e[0].x, e[0].y, e[0].z, e[1].x, e[1].y, e[1].z); };
    std::ranges::sort(edges, {}, coordinates);
    return edges;
  };
  EXPECT_NE(sortedFeatures(model), sortedFeatures(truth)) << "nothing to repair";
  repairAngles(model, {}, {}, execution);
  EXPECT_EQ(sortedFeatures(model), sortedFeatures(truth));
}

/// A sample of the convex hull of random points, and the hull's edges.
struct Polytope
{
  std::vector<Vec3> points;
  std::vector<Edge> edges;

  bool hasOnEdge(const Edge& piece) const
  {
    return std::ranges::any_of(this->edges,
      [&](const Edge& edge)
      {
        const Vec3 along = edge[1] - edge[0];
        return std::ranges::all_of(piece,
          [&](const Vec3& p)
          {
            const Vec3 off = cross(p - edge[0], along);
            return dot(off, off) < 1e-18 * dot(along, along);
          });
      });
  }
};

/// A tenth of the points on edges is missing.
Polytope randomPolytope(std::uint64_t seed)
{
  constexpr int kPieces = 24;
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  std::vector<Vec3> corners;
  while (corners.size() < 12)
  {
    const Vec3 p{ uniform() - 0.5, uniform() - 0.5, uniform() - 0.5 };
    corners.push_back(p * (1.0 / std::sqrt(dot(p, p))));
  }
  Execution execution(1);
  const DelaunayComplex hull = buildDelaunayComplex(corners, execution);
  Polytope polytope{ .points = hull.points, .edges = {} };
  for (Facet facet = 0; facet < 4 * hull.tetCount(); ++facet)
  {
    if (hull.mirror[facet / 4][facet % 4] != kNone)
    {
      continue;
    }
    const Triangle v = hull.facetVertices(facet);
    const Vec3 a = hull.points[v[0]];
    const Vec3 ab = (hull.points[v[1]] - a) * (1.0 / kPieces);
    const Vec3 ac = (hull.points[v[2]] - a) * (1.0 / kPieces);
    for (int i = 1; i < kPieces; ++i)
    {
      for (int j = 1; i + j < kPieces; ++j)
      {
        const double s = i + 0.3 * uniform();
        const double t = j + 0.3 * uniform();
        polytope.points.push_back(a + ab * s + ac * t);
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Edge edge{ hull.points[v[k]], hull.points[v[(k + 1) % 3]] };
      for (int i = 1; i < kPieces && v[k] < v[(k + 1) % 3]; ++i)
      {
        if (uniform() > 0.1)
        {
          polytope.points.push_back(
            edge[0] + (edge[1] - edge[0]) * (static_cast<double>(i) / kPieces));
        }
      }
      polytope.edges.push_back(edge);
    }
  }
  return polytope;
}

TEST(RepairAngles, EdgesOfPolytopesAreStraight)
{
  Execution execution(1);
  std::ptrdiff_t strayBefore = 0;
  std::ptrdiff_t strayAfter = 0;
  for (std::uint64_t seed = testSeed(); seed < testSeed() + 3; ++seed)
  {
    const Polytope polytope = randomPolytope(seed);
    WrapModel model = wrappedModel(polytope.points, Mode::automatic);
    const auto countOff = [&]
    {
      return std::ranges::count_if(
        featureEdges(model), [&](const Edge& edge) { return !polytope.hasOnEdge(edge); });
    };
    strayBefore += countOff();
    repairAngles(model, {}, {}, execution);
    strayAfter += countOff();
  }
  EXPECT_GT(strayBefore, 50) << "SCAN_TEST_SEED=" << testSeed();
  EXPECT_LT(strayAfter, strayBefore / 10) << "SCAN_TEST_SEED=" << testSeed();
}

TEST(RepairAngles, SmoothSurfacesStayAsTheyAre)
{
  Execution execution(1);
  const WrapModel before =
    wrappedModel(readPoints(std::string(SCAN_DATA_DIR) + "/torus.xyz"), Mode::automatic);
  WrapModel model = before;
  EXPECT_EQ(repairAngles(model, {}, {}, execution).flips, 0U);
  EXPECT_EQ(*model.current, *before.current);
}

TEST(RepairAngles, MakesNoContactAndLosesNoPoint)
{
  Execution execution(1);
  Index flips = 0;
  for (std::uint64_t seed = testSeed(); seed < testSeed() + 8; ++seed)
  {
    for (const PointSet& set : pointSets(seed))
    {
      SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(seed));
      std::mt19937_64 random(seed);
      WrapModel model = wholeModel(set.points);
      for (int round = 0; round < 2; ++round) // pits all over
      {
        std::vector<Facet> marks = surfaceFacets(model);
        std::erase_if(marks, [&](Facet) { return random() % 4 != 0; });
        pushTets(model, marks, execution);
      }
      const WrapResult before = surfaceOf(model, false, execution);
      flips += repairAngles(model, {}, {}, execution).flips;
      const WrapResult after = surfaceOf(model, false, execution);
      EXPECT_FALSE(losesPoints(before, after));
      const MeshReport was = describeMesh(before.surface);
      const MeshReport is = describeMesh(after.surface);
      EXPECT_EQ(is.nonManifoldEdges, was.nonManifoldEdges);
      EXPECT_LE(is.nonManifoldVertices, was.nonManifoldVertices);
    }
  }
  EXPECT_GT(flips, 100U);
}

TEST(RepairAngles, WorksOnTheRegionOnly)
{
  Execution execution(1);
  const WrapModel before = openedPlate(damaged(platePoints(), 0.05, testSeed()));
  const auto isAtTop = [&](Facet facet)
  {
    return std::ranges::all_of(before.scan->delaunay().facetVertices(facet),
      [&](Index v) { return before.scan->delaunay().points[v].z > 0.5; });
  };
  std::vector<Facet> top = surfaceFacets(before);
  std::erase_if(top, [&](Facet facet) { return !isAtTop(facet); });
  WrapModel model = before;
  const AngleRepairReport report = repairAngles(model, top, {}, execution);
  EXPECT_GT(report.flips, 0U);
  EXPECT_TRUE(std::ranges::all_of(report.surface.gone, isAtTop));
  WrapModel everywhere = before;
  EXPECT_GT(repairAngles(everywhere, {}, {}, execution).flips, report.flips);
}

TEST(RepairAngles, TheNumberOfThreadsDoesNotMatter)
{
  const WrapModel before = openedPlate(damaged(platePoints(), 0.3, testSeed()));
  WrapModel one = before;
  WrapModel four = before;
  Execution single(1);
  Execution several(4);
  repairAngles(one, {}, {}, single);
  repairAngles(four, {}, {}, several);
  EXPECT_EQ(*one.current, *four.current);
}

} // namespace
} // namespace scan::test
