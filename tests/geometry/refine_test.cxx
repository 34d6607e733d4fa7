// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/refine.h"

#include "filters/base/error.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/half_marks.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/point_fixtures.h"
#include "tests/geometry/refine_fixtures.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <numbers>
#include <set>

namespace scan::test
{
namespace
{

using Mode = RefineOptions::Mode;
using Edge = std::pair<Index, Index>;

Edge edgeOf(Index a, Index b)
{
  return std::minmax(a, b);
}

/// Where Loop's rules take the points of a mesh, written down plainly: the old points and those of
/// the edges.
class PlainLoop
{
public:
  using Real = long double;
  using Place = std::array<Real, 3>;

  /// @param creases edges that stay sharp besides boundaries
  PlainLoop(const TriMesh& mesh, const std::set<Edge>& creases)
    : Mesh(mesh)
  {
    for (const Triangle& t : mesh.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Across[edgeOf(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
      }
    }
    for (const auto& [edge, across] : this->Across)
    {
      const bool isSharp = across.size() == 1 || creases.count(edge) > 0;
      for (const auto& [from, to] : { edge, Edge{ edge.second, edge.first } })
      {
        this->Around[from].push_back(to);
        if (isSharp)
        {
          this->Sharp[from].push_back(to);
        }
      }
      if (isSharp)
      {
        this->SharpEdges.insert(edge);
      }
    }
  }

  Place pointAt(Index p) const
  {
    const auto sharp = this->Sharp.find(p);
    if (sharp != this->Sharp.end() && sharp->second.size() >= 2)
    {
      return sharp->second.size() > 2
        ? this->sum({ { p, 1 } })
        : this->sum({ { p, 0.75L }, { sharp->second[0], 0.125L }, { sharp->second[1], 0.125L } });
    }
    if (this->Around.count(p) == 0)
    {
      return this->sum({ { p, 1 } });
    }
    const std::vector<Index>& around = this->Around.at(p);
    const Real m = static_cast<Real>(around.size());
    const Real term = 3 + 2 * std::cos(2 * std::numbers::pi_v<Real> / m);
    const Real share = (40 - term * term) / 64;
    std::vector<std::pair<Index, Real>> weights{ { p, 1 - share } };
    for (const Index neighbour : around)
    {
      weights.emplace_back(neighbour, share / m);
    }
    return this->sum(weights);
  }

  Place middleOf(Index p, Index q) const
  {
    const Edge edge = edgeOf(p, q);
    if (this->SharpEdges.count(edge) > 0)
    {
      return this->sum({ { p, 0.5L }, { q, 0.5L } });
    }
    const auto& across = this->Across.at(edge);
    return this->sum(
      { { p, 0.375L }, { q, 0.375L }, { across[0], 0.125L }, { across[1], 0.125L } });
  }

private:
  Place sum(const std::vector<std::pair<Index, Real>>& weights) const
  {
    Place place{};
    for (const auto& [point, weight] : weights)
    {
      const Vec3& at = this->Mesh.points[point];
      place = { place[0] + weight * at.x, place[1] + weight * at.y, place[2] + weight * at.z };
    }
    return place;
  }

  const TriMesh& Mesh;
  std::map<Edge, std::vector<Index>> Across;
  std::map<Index, std::vector<Index>> Around;
  std::map<Index, std::vector<Index>> Sharp;
  std::set<Edge> SharpEdges;
};

double distanceOf(const PlainLoop::Place& a, const Vec3& b)
{
  return static_cast<double>(std::hypot(a[0] - b.x, a[1] - b.y, a[2] - b.z));
}

/// The edges where two triangles face apart by more.
std::set<Edge> creasesOf(const TriMesh& mesh, double degrees)
{
  const EdgePairs pairs = pairEdges(mesh);
  std::set<Edge> creases;
  for (Index half = 0; half < pairs.mate.size(); ++half)
  {
    if (pairs.mate[half] == kNone)
    {
      continue;
    }
    const TriMesh both{ mesh.points,
      { mesh.triangles[half / 3], mesh.triangles[pairs.mate[half] / 3] } };
    if (largestBend(both) > degrees * std::numbers::pi / 180.0)
    {
      creases.insert(edgeOf(originOf(mesh, half), originOf(mesh, nextHalf(half))));
    }
  }
  return creases;
}

TEST(RefineLoop, IsWhatTheRulesSay)
{
  double worst = 0.0;
  for (const auto& [name, mesh] : manifolds())
  {
    for (const double angle : { 180.0, 50.0, 20.0 })
    {
      const PlainLoop plain(mesh, creasesOf(mesh, angle));
      const RefineResult result = refined(mesh, { .creaseAngle = angle }, allOf(mesh));
      const SurfaceEdit& edit = result.edit;
      for (std::size_t i = 0; i < edit.mesh.points.size(); ++i)
      {
        const auto point = static_cast<Index>(i);
        const bool isOld = i < mesh.points.size();
        ASSERT_EQ(edit.pointOrigin[i], isOld ? point : kNone);
        const auto from = isOld ? std::array<Index, 3>{} : edit.blends[i - mesh.points.size()].from;
        const auto place = isOld ? plain.pointAt(point) : plain.middleOf(from[0], from[1]);
        worst = std::max(worst, distanceOf(place, edit.mesh.points[i]));
      }
      ASSERT_LT(worst, 1e-12) << name << " creases " << angle;
    }
  }
  std::cout << "largest distance from the rules in extended precision " << worst << "\n";
}

/// The normal of the limit surface is continuous: the largest bend goes to zero, like the size of
/// the triangles where at most six meet, and like the ratio of the second to the first eigenvalue
/// of the rules where more do.
TEST(RefineLoop, BendsFallWithEveryRefinement)
{
  const auto ratioOf = [](double m)
  {
    const auto eigenvalue = [m](double wave)
    { return 0.375 + 0.25 * std::cos(2.0 * std::numbers::pi * wave / m); };
    return std::max(0.5, eigenvalue(2) / eigenvalue(1));
  };
  struct Case
  {
    std::string name;
    TriMesh mesh;
    double ratio;
  };
  std::vector<Case> cases{ { "tetrahedron", corpus::tetrahedron(), 0.5 },
    { "octahedron", bipyramid(4), 0.5 }, { "bipyramid of 3", bipyramid(3), 0.5 },
    { "bipyramid of 6", bipyramid(6), 0.5 }, { "torus", corpus::torus(8), 0.5 } };
  for (const Index m : { 5, 7, 9, 12 })
  {
    cases.push_back({ "bipyramid of " + std::to_string(m), bipyramid(m), ratioOf(m) });
  }
  for (const auto& [name, start, ratio] : cases)
  {
    TriMesh mesh = start;
    double before = largestBend(mesh);
    std::cout << name << ", bends fall by " << ratio << " or faster:";
    for (int round = 0; round < 6; ++round)
    {
      mesh = refined(mesh, {}, allOf(mesh)).edit.mesh;
      const double after = largestBend(mesh);
      std::cout << " " << after / before;
      if (round > 3)
      {
        EXPECT_LT(after, 1.03 * ratio * before) << name << " round " << round;
      }
      before = after;
    }
    std::cout << "\n";
  }
}

TEST(RefineLoop, CreasesStaySharpWhenRefinedSeveralTimes)
{
  const TriMesh cube = corpus::voxelBorder(3, [](Index, Index, Index) { return true; });
  const RefineResult sharp = refined(cube, { .times = 2, .creaseAngle = 60.0 }, allOf(cube));
  EXPECT_NEAR(largestBend(sharp.edit.mesh), std::numbers::pi / 2.0, 1e-9);
  const MeshReport report = describeMesh(sharp.edit.mesh);
  EXPECT_NEAR(*report.volume, 27.0, 1e-9);
  const RefineResult round = refined(cube, { .times = 2 }, allOf(cube));
  EXPECT_LT(largestBend(round.edit.mesh), 0.6);
}

TEST(Refine, MidpointsCutEveryTriangleIntoFourSimilarOnes)
{
  for (const auto& [name, mesh] : manifolds())
  {
    const RefineResult result = refined(mesh, { .mode = Mode::midpoint, .times = 3 }, allOf(mesh));
    const MeshReport before = describeMesh(mesh);
    const MeshReport after = describeMesh(result.edit.mesh);
    EXPECT_EQ(after.triangles, 64 * before.triangles) << name;
    EXPECT_NEAR(after.area, before.area, 1e-12 * before.area) << name;
    EXPECT_NEAR(smallestAngle(result.edit.mesh), smallestAngle(mesh), 1e-9) << name;
    EXPECT_TRUE(result.halves.empty()) << name;
    EXPECT_EQ(result.largestShift, 0.0);
  }
}

/// What is cut when some triangles are, found by going over the mesh again and again.
std::vector<int> plainCuts(const TriMesh& mesh, const std::vector<std::uint8_t>& isChosen)
{
  std::vector<int> parts(mesh.triangles.size(), 1);
  std::set<Edge> cut;
  const auto edge = [&](std::size_t t, std::size_t k)
  { return edgeOf(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]); };
  for (bool goesOn = true; goesOn;)
  {
    goesOn = false;
    for (std::size_t t = 0; t < parts.size(); ++t)
    {
      if (isCollapsed(mesh.triangles[t]))
      {
        continue;
      }
      int edges = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        edges += cut.count(edge(t, k)) > 0 ? 1 : 0;
      }
      if (parts[t] != 4 && (isChosen[t] != 0 || edges > 1))
      {
        parts[t] = 4;
        goesOn = true;
        cut.insert({ edge(t, 0), edge(t, 1), edge(t, 2) });
      }
      else if (parts[t] == 1 && edges == 1)
      {
        parts[t] = 2;
      }
    }
  }
  return parts;
}

TEST(Refine, CutsTheChosenAndNoMoreThanItTakes)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::vector<NamedMesh> meshes = manifolds();
  std::ranges::move(awkwardMeshes(), std::back_inserter(meshes));
  for (const auto& [name, mesh] : meshes)
  {
    for (int round = 0; round < 10 && !mesh.triangles.empty(); ++round)
    {
      const auto region = randomRegion(mesh, random);
      const RefineResult result = refined(mesh, { .mode = Mode::midpoint }, region);
      std::vector<int> parts(mesh.triangles.size(), 0);
      for (const Index origin : result.edit.triangleOrigin)
      {
        ++parts[origin];
      }
      EXPECT_EQ(parts, plainCuts(mesh, region)) << name << " SCAN_TEST_SEED=" << seed;
    }
  }
}

struct ByCoordinates
{
  bool operator()(const Vec3& a, const Vec3& b) const
  {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

/// Whether a point lies in the middle of an edge.
bool hasHangingPoint(const TriMesh& mesh)
{
  const std::set<Vec3, ByCoordinates> places(mesh.points.begin(), mesh.points.end());
  for (const Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (places.count((mesh.points[t[k]] + mesh.points[t[(k + 1) % 3]]) * 0.5) > 0)
      {
        return true;
      }
    }
  }
  return false;
}

/// Two triangles with the same points; of their parts in the middle all edges fall together.
bool hasTwins(const TriMesh& mesh)
{
  std::set<Triangle> all;
  return !std::ranges::all_of(mesh.triangles,
    [&](Triangle t)
    {
      std::ranges::sort(t);
      return isCollapsed(t) || all.insert(t).second;
    });
}

void expectSameKind(const TriMesh& before, const TriMesh& after, const std::string& what)
{
  const MeshReport a = describeMesh(before);
  const MeshReport b = describeMesh(after);
  EXPECT_EQ(a.isClosed, b.isClosed) << what;
  EXPECT_EQ(a.isManifold, b.isManifold) << what;
  EXPECT_EQ(a.isOriented, b.isOriented) << what;
  EXPECT_TRUE(a.eulerCharacteristic == b.eulerCharacteristic || hasTwins(before)) << what;
  EXPECT_EQ(a.genus, b.genus) << what;
  EXPECT_EQ(a.boundaryLoops, b.boundaryLoops) << what;
  EXPECT_EQ(a.nonManifoldVertices, b.nonManifoldVertices) << what;
  EXPECT_EQ(a.nonManifoldEdges > 0, b.nonManifoldEdges > 0) << what;
  EXPECT_EQ(a.components.size(), b.components.size()) << what;
}

/// Points with a triangle that is not in the region stay, and so do triangles that are not cut.
void expectUntouched(const TriMesh& before, const std::vector<std::uint8_t>& region,
  const RefineResult& result, const std::string& what)
{
  const SurfaceEdit& edit = result.edit;
  std::vector<int> parts(before.triangles.size(), 0);
  for (const Index origin : edit.triangleOrigin)
  {
    ++parts[origin];
  }
  for (std::size_t i = 0; i < edit.triangleOrigin.size(); ++i)
  {
    const Index origin = edit.triangleOrigin[i];
    if (parts[origin] == 1)
    {
      ASSERT_EQ(edit.mesh.triangles[i], before.triangles[origin]) << what;
    }
  }
  for (std::size_t t = 0; t < region.size(); ++t)
  {
    ASSERT_TRUE(region[t] == 0 || parts[t] > 1 || isCollapsed(before.triangles[t])) << what;
    for (const Index point : before.triangles[t])
    {
      ASSERT_TRUE(region[t] != 0 || edit.mesh.points[point] == before.points[point]) << what;
    }
  }
  ASSERT_EQ(edit.mesh.triangles.size(),
    before.triangles.size() + 3 * result.cutInFour + result.cutInTwo - result.joined)
    << what;
}

/// Four rounds of random regions, on what the rounds before have left.
TEST(Refine, RandomRegionsKeepWhatTheSurfaceIs)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::vector<NamedMesh> meshes = manifolds();
  EXPECT_EQ(meshes.size(), 20U);
  std::ranges::move(awkwardMeshes(), std::back_inserter(meshes));
  std::size_t joined = 0;
  for (const auto& [name, start] : meshes)
  {
    for (const Mode mode : { Mode::loop, Mode::midpoint })
    {
      TriMesh mesh = start;
      std::vector<std::uint8_t> halves;
      for (int round = 0; round < 4 && !mesh.triangles.empty(); ++round)
      {
        const std::string what = name + " mode " + std::to_string(static_cast<int>(mode)) +
          " round " + std::to_string(round) + " SCAN_TEST_SEED=" + std::to_string(seed);
        const auto region = randomRegion(mesh, random);
        const RefineResult result =
          refined(mesh, { .mode = mode, .creaseAngle = 40.0 }, region, halves);
        expectSameKind(mesh, result.edit.mesh, what);
        expectUntouched(mesh, region, result, what);
        if (mode == Mode::midpoint && describeMesh(start).flatTriangles == 0)
        {
          const double area = describeMesh(start).area;
          EXPECT_NEAR(describeMesh(result.edit.mesh).area, area, 1e-11 * area) << what;
          EXPECT_EQ(hasHangingPoint(result.edit.mesh), hasHangingPoint(start)) << what;
        }
        joined += result.joined;
        halves = result.halves;
        mesh = result.edit.mesh;
      }
    }
  }
  EXPECT_GT(joined, 1000U);
}

/// A spot that moves: triangles are refined where halves of the rounds before are.
TEST(Refine, AnglesStayHoweverOftenASpotIsRefined)
{
  double worstWithout = 1.0;
  for (const auto& [name, start] : manifolds())
  {
    TriMesh mesh = start;
    std::vector<std::uint8_t> halves;
    const double before = smallestAngle(start);
    double smallest = before;
    double without = before; // marks
    TriMesh unmarked = start;
    const MeshReport report = describeMesh(start);
    Vec3 markedSpot = start.points[0];
    Vec3 unmarkedSpot = markedSpot;
    const auto spotOf = [&](const TriMesh& at, int round, Vec3& spot)
    {
      Random random(static_cast<std::uint64_t>(round));
      const double reach = 0.3 * report.boxDiagonal * std::pow(0.55, round);
      const Vec3 to = spot + noise(random, 0.5 * reach);
      const Vec3 middle =
        *std::ranges::min_element(at.points, {}, [&](const Vec3& p) { return length(p - to); });
      std::vector<std::uint8_t> region(at.triangles.size());
      std::ranges::transform(at.triangles, region.begin(),
        [&](const Triangle& t) { return length(at.points[t[0]] - middle) < reach ? 1 : 0; });
      spot = middle;
      return region;
    };
    for (int round = 0; round < 12; ++round)
    {
      const RefineResult result =
        refined(mesh, { .mode = Mode::midpoint }, spotOf(mesh, round, markedSpot), halves);
      mesh = result.edit.mesh;
      halves = result.halves;
      smallest = std::min(smallest, smallestAngle(mesh));
      unmarked =
        refined(unmarked, { .mode = Mode::midpoint }, spotOf(unmarked, round, unmarkedSpot))
          .edit.mesh;
      without = std::min(without, smallestAngle(unmarked));
    }
    std::cout << name << ": " << mesh.triangles.size() << " triangles, smallest angle "
              << smallest / before << " of that before, without marks " << without / before << "\n";
    EXPECT_GT(std::tan(smallest), std::tan(before) / 3.0 * (1.0 - 1e-9)) << name;
    worstWithout = std::min(worstWithout, without / before);
  }
  EXPECT_LT(worstWithout, 0.1); // it is the marks that do it
}

TEST(Refine, HalvesArePutTogether)
{
  // a square: the first triangle in four cuts the second in two
  const RefineResult once = refined(corpus::square(), { .mode = Mode::midpoint }, { 1, 0 });
  EXPECT_EQ(once.cutInFour, 1U);
  EXPECT_EQ(once.cutInTwo, 1U);
  EXPECT_EQ(std::ranges::count(once.halves, 0), 4);
  // choosing one half is choosing the whole
  std::vector<std::uint8_t> region(6, 0);
  region[5] = 1;
  const RefineResult twice =
    refined(once.edit.mesh, { .mode = Mode::midpoint }, region, once.halves);
  EXPECT_EQ(twice.joined, 1U);
  EXPECT_EQ(twice.edit.mesh.triangles.size(), 8U);
  const RefineResult all = refined(corpus::square(), { .mode = Mode::midpoint }, { 1, 1 });
  EXPECT_NEAR(smallestAngle(twice.edit.mesh), smallestAngle(all.edit.mesh), 1e-12);
  // without the other half, or where the middle has moved, the mark means nothing
  TriMesh alone = once.edit.mesh;
  alone.triangles.pop_back();
  std::vector<std::uint8_t> marks = once.halves;
  marks.pop_back();
  EXPECT_EQ(refined(alone, {}, std::vector<std::uint8_t>(5, 1), marks).joined, 0U);
  TriMesh moved = once.edit.mesh;
  moved.points[4].x += 1e-6;
  moved.points[5].x += 1e-6;
  moved.points[6].x += 1e-6;
  EXPECT_EQ(refined(moved, {}, allOf(moved), once.halves).joined, 0U);
}

TEST(Refine, ArbitraryMarksDoNoHarm)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::vector<NamedMesh> meshes = manifolds();
  std::ranges::move(awkwardMeshes(), std::back_inserter(meshes));
  for (const auto& [name, mesh] : meshes)
  {
    std::vector<std::uint8_t> marks(mesh.triangles.size());
    std::ranges::generate(marks, [&] { return static_cast<std::uint8_t>(random.below(9)); });
    const RefineResult result = refined(mesh, { .times = 2 }, allOf(mesh), marks);
    if (!mesh.triangles.empty())
    {
      expectSameKind(mesh, result.edit.mesh, name + " SCAN_TEST_SEED=" + std::to_string(seed));
    }
  }
}

TEST(Refine, SeveralTimesAreOneAfterTheOther)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  std::vector<NamedMesh> meshes = manifolds();
  std::ranges::move(awkwardMeshes(), std::back_inserter(meshes));
  TriMesh doubled = corpus::square();
  doubled.triangles.push_back(doubled.triangles[1]);
  meshes.push_back({ "doubled", doubled });
  for (const auto& [name, mesh] : meshes)
  {
    const auto region = mesh.triangles.size() == 3 ? std::vector<std::uint8_t>{ 1, 0, 0 }
      : mesh.triangles.empty()                     ? std::vector<std::uint8_t>{}
                                                   : randomRegion(mesh, random);
    const RefineResult once = refined(mesh, {}, region);
    std::vector<std::uint8_t> parts(once.edit.triangleOrigin.size());
    std::ranges::transform(
      once.edit.triangleOrigin, parts.begin(), [&](Index origin) { return region[origin]; });
    const RefineResult again = refined(once.edit.mesh, {}, parts, once.halves);
    const RefineResult twice = refined(mesh, { .times = 2 }, region);
    EXPECT_EQ(twice.edit.mesh.points, again.edit.mesh.points) << name << " seed " << seed;
    EXPECT_EQ(twice.edit.mesh.triangles, again.edit.mesh.triangles) << name;
    EXPECT_EQ(twice.halves, again.halves) << name;
    EXPECT_EQ(twice.cutInTwo, once.cutInTwo + again.cutInTwo) << name;
  }
}

/// As both surfaces are linear on the same triangles, the points tell how far they are apart.
TEST(RefineLoop, StaysWithinTheDistance)
{
  Random random(pointSeed());
  for (const auto& [name, mesh] : manifolds())
  {
    const double size = describeMesh(mesh).boxDiagonal;
    for (const double part : { 0.0, 1e-4, 0.01, 10.0 })
    {
      const auto region = random.below(2) == 0 ? allOf(mesh) : randomRegion(mesh, random);
      const double limit = part * size;
      const RefineResult flat = refined(mesh, { .mode = Mode::midpoint, .times = 3 }, region);
      const RefineResult result = refined(mesh, { .times = 3, .maxDeviation = limit }, region);
      ASSERT_EQ(flat.edit.mesh.triangles, result.edit.mesh.triangles) << name;
      double largest = 0.0;
      for (std::size_t i = 0; i < flat.edit.mesh.points.size(); ++i)
      {
        largest = std::max(largest, length(flat.edit.mesh.points[i] - result.edit.mesh.points[i]));
      }
      EXPECT_LE(largest, limit) << name;
      EXPECT_EQ(largest, result.largestShift) << name;
      EXPECT_TRUE(part < 1.0 || result.heldBack == 0) << name;
      EXPECT_TRUE(part > 1e-4 || result.heldBack > 0 ||
        std::ranges::count(region, 1) < std::ssize(region) || name == "square")
        << name;
    }
  }
}

/// The data of points: a linear function stays one, whatever is put together.
TEST(Refine, NewPointsHaveTheDataOfTheirPlaceInTheInput)
{
  const std::uint64_t seed = pointSeed();
  Random random(seed);
  for (const auto& [name, mesh] : manifolds())
  {
    const RefineResult first =
      refined(mesh, { .mode = Mode::midpoint }, randomRegion(mesh, random));
    const TriMesh& input = first.edit.mesh;
    for (const int times : { 1, 3 })
    {
      const RefineResult result = refined(input, { .mode = Mode::midpoint, .times = times },
        randomRegion(input, random), first.halves);
      const SurfaceEdit& edit = result.edit;
      const std::size_t old = input.points.size();
      ASSERT_EQ(edit.blends.size(), edit.mesh.points.size() - old);
      for (std::size_t i = 0; i < edit.blends.size(); ++i)
      {
        const auto& [from, weights] = edit.blends[i];
        EXPECT_NEAR(weights[0] + weights[1] + weights[2], 1.0, 1e-12);
        const Vec3 place = input.points[from[0]] * weights[0] + input.points[from[1]] * weights[1] +
          input.points[from[2]] * weights[2];
        ASSERT_LT(length(place - edit.mesh.points[old + i]), 1e-12)
          << name << " SCAN_TEST_SEED=" << seed;
      }
    }
  }
}

TEST(Refine, IsTheSameOnAnyNumberOfThreads)
{
  Random random(pointSeed());
  const TriMesh mesh = corpus::torus(100);
  const auto region = randomRegion(mesh, random);
  for (const Mode mode : { Mode::loop, Mode::midpoint })
  {
    const RefineOptions options{ mode, 2, 10.0, 0.001 };
    const RefineResult one = refined(mesh, options, region, {}, 1);
    const RefineResult three = refined(mesh, options, region, {}, 3);
    EXPECT_EQ(one.edit.mesh.points, three.edit.mesh.points);
    EXPECT_EQ(one.edit.mesh.triangles, three.edit.mesh.triangles);
    EXPECT_EQ(one.edit.triangleOrigin, three.edit.triangleOrigin);
    EXPECT_EQ(one.halves, three.halves);
    EXPECT_EQ(one.heldBack, three.heldBack);
    EXPECT_EQ(one.largestShift, three.largestShift);
  }
}

TEST(Refine, LeavesEverythingWithoutARegion)
{
  for (const auto& [name, mesh] : manifolds())
  {
    const RefineResult result =
      refined(mesh, { .times = 3 }, std::vector<std::uint8_t>(mesh.triangles.size(), 0));
    EXPECT_EQ(result.edit.mesh.points, mesh.points) << name;
    EXPECT_EQ(result.edit.mesh.triangles, mesh.triangles) << name;
    EXPECT_EQ(result.edit.triangleOrigin.size(), mesh.triangles.size()) << name;
  }
}

TEST(Refine, RefusesWhatNoMachineHoldsAndStopsWhenCancelled)
{
  const TriMesh mesh = corpus::torus(400);
  try
  {
    refined(mesh, { .times = 8 }, allOf(mesh));
    FAIL() << "made too many triangles";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::limit);
    std::cout << error.what() << "\n";
  }
  const CancelToken token;
  Execution execution(2, token, [&](std::string_view, double) { token.cancel(); });
  execution.plan({ { "refine", 1.0 } });
  EXPECT_THROW(refine(mesh, allOf(mesh), {}, {}, execution), Cancelled);
  EXPECT_THROW(refined({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }, {}, { 1 }), Error);
}

} // namespace
} // namespace scan::test
