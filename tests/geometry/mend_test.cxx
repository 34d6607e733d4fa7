// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mend.h"

#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/orient_outward.h"
#include "filters/geometry/surface_edit.h"
#include "tests/geometry/cgal_checks.h"
#include "tests/geometry/damage.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <limits>

using namespace scan;
using scan::test::intersectsItself;

namespace
{

MendResult mendAll(const TriMesh& mesh, MendOptions options = {}, unsigned threads = 2)
{
  const std::vector<std::uint8_t> everywhere(mesh.triangles.size(), 1);
  Execution execution(threads);
  return mend(mesh, everywhere, options, execution);
}

/// Options as the program has them, for meshes with edges of about this length.
MendOptions usual(double edge)
{
  MendOptions options;
  options.defects.leastHeight = 1e-6;
  options.defects.smallHole = 10.0 * edge;
  return options;
}

/// What the header promises whatever is left.
void expectAccounts(const TriMesh& mesh, const MendResult& result)
{
  EXPECT_EQ(mesh.triangles.size() + result.tally.added(),
    result.edit.mesh.triangles.size() + result.tally.removed());
  EXPECT_EQ(result.edit.pointOrigin.size(), result.edit.mesh.points.size());
  EXPECT_EQ(result.edit.triangleOrigin.size(), result.edit.mesh.triangles.size());
  std::size_t fresh = 0;
  for (const Index origin : result.edit.pointOrigin)
  {
    fresh += origin == kNone ? 1 : 0;
  }
  EXPECT_EQ(result.edit.blends.size(), fresh);
}

void expectGood(const TriMesh& mesh, const MendResult& result)
{
  expectAccounts(mesh, result);
  EXPECT_TRUE(result.left.defects.empty());
  const MeshReport report = describeMesh(result.edit.mesh);
  EXPECT_TRUE(report.isManifold && report.isOriented);
  EXPECT_EQ(report.flatTriangles + report.collapsedTriangles, 0U);
  EXPECT_FALSE(intersectsItself(result.edit.mesh));
}

std::uint64_t firstSeed()
{
  const char* const given = std::getenv("SCAN_TEST_SEED");
  return given != nullptr ? std::strtoull(given, nullptr, 10) : 1;
}

} // namespace

TEST(Mend, LeavesGoodMeshesAlone)
{
  for (const TriMesh& mesh : { corpus::torus(20), corpus::square(), corpus::tetrahedron() })
  {
    const MendResult result = mendAll(mesh, usual(0.2));
    EXPECT_EQ(result.edit.mesh.points, mesh.points);
    EXPECT_EQ(result.edit.mesh.triangles, mesh.triangles);
    EXPECT_TRUE(result.found.defects.empty());
    EXPECT_EQ(result.tally.rounds, 0);
  }
}

TEST(Mend, PartsWhatTouches)
{
  for (const TriMesh& mesh :
    { corpus::tetrahedraOnOneEdge(), corpus::tetrahedraOnOnePoint(), corpus::moebius(),
      corpus::voxelBorder(4, [](Index i, Index j, Index k) { return (i + j + k) % 2 == 0; }) })
  {
    MendOptions options = usual(1.0);
    options.defects.kinds.reset(static_cast<std::size_t>(DefectKind::smallHoles));
    const MendResult result = mendAll(mesh, options);
    expectGood(mesh, result);
    EXPECT_EQ(result.tally.removed() + result.tally.added(), 0U);
    EXPECT_LT(result.tally.largestMove, 0.2);
  }
}

TEST(Mend, UnitesPiecesThatReachIntoEachOther)
{
  TriMesh mesh = corpus::torus(24);
  for (const Vec3& p : corpus::torus(24).points)
  {
    mesh.points.push_back({ p.x + 1.5, p.z + 0.3, p.y + 0.1 });
  }
  const auto first = static_cast<Index>(mesh.points.size() / 2);
  for (const auto& [a, b, c] : corpus::torus(24).triangles)
  {
    mesh.triangles.push_back({ first + a, first + c, first + b });
  }
  const MendResult result = mendAll(mesh, usual(0.2));
  expectGood(mesh, result);
  EXPECT_EQ(result.tally.intersections.unions, 1U);
  EXPECT_EQ(describeMesh(result.edit.mesh).components.size(), 1U);
  EXPECT_TRUE(describeMesh(result.edit.mesh).isClosed);
}

TEST(Mend, ClosesTornPlacesAndHoles)
{
  const TriMesh good = corpus::torus(20);
  TriMesh mesh = good;
  for (const std::size_t t : { 10U, 11U, 200U })
  {
    for (Index& corner : mesh.triangles[t])
    {
      mesh.points.push_back(Vec3(mesh.points[corner]));
      corner = static_cast<Index>(mesh.points.size() - 1);
    }
  }
  mesh.triangles.erase(mesh.triangles.begin() + 300);
  const MendResult result = mendAll(mesh, usual(0.5));
  expectGood(mesh, result);
  EXPECT_TRUE(describeMesh(result.edit.mesh).isClosed);
  EXPECT_EQ(result.tally.holeTriangles, 1U);
  EXPECT_EQ(describeMesh(result.edit.mesh).pointsUsed, good.points.size());
}

TEST(Mend, KeepsTheRimsOfSheets)
{
  TriMesh mesh = corpus::torus(20);
  mesh.triangles.erase(mesh.triangles.begin() + 300);
  const auto first = static_cast<Index>(mesh.points.size());
  for (const Vec3& p :
    { Vec3{ 5, 5, 0 }, Vec3{ 6, 5, 0 }, Vec3{ 6, 6, 0 }, Vec3{ 5, 6, 0 }, Vec3{ 5.5, 5.5, 0.3 } })
  {
    mesh.points.push_back(p);
  }
  for (Index i = 0; i < 4; ++i)
  {
    mesh.triangles.push_back({ first + i, first + (i + 1) % 4, first + 4 });
  }
  MendOptions options = usual(0.5);
  options.defects.smallComponent = 0.0;
  const MendResult result = mendAll(mesh, options);
  expectGood(mesh, result);
  EXPECT_EQ(result.tally.holesFilled, 1U);
  EXPECT_EQ(describeMesh(result.edit.mesh).boundaryEdges, 4U);
}

TEST(Mend, MovesSpikesBack)
{
  const TriMesh good = corpus::torus(30);
  TriMesh mesh = good;
  for (const Index p : { 40U, 300U, 333U })
  {
    const Vec3 at = mesh.points[p];
    const Vec3 core = Vec3{ at.x, at.y, 0 } * (2.0 / std::hypot(at.x, at.y));
    mesh.points[p] = core + (at - core) * 2.5;
  }
  const MendResult result = mendAll(mesh, usual(0.2));
  expectGood(mesh, result);
  EXPECT_EQ(result.tally.spikesMoved, 3U);
  for (const Index p : { 40U, 300U, 333U })
  {
    const Vec3 off = result.edit.mesh.points[p] - good.points[p];
    EXPECT_LT(std::sqrt(dot(off, off)), 0.08); // a third of an edge
  }
}

TEST(Mend, RepairsOneDefectOnly)
{
  TriMesh mesh = corpus::torus(20);
  std::swap(mesh.triangles[100][0], mesh.triangles[100][1]);
  std::swap(mesh.triangles[500][0], mesh.triangles[500][1]);
  mesh.triangles.push_back(Triangle(mesh.triangles[700]));
  MendOptions options = usual(0.2);
  options.at = mesh.points[mesh.triangles[500][0]];
  const MendResult result = mendAll(mesh, options);
  expectAccounts(mesh, result);
  EXPECT_TRUE(result.left.defects.empty());
  EXPECT_EQ(result.found.defects.size(), 1U);
  EXPECT_EQ(result.tally.turned, 1U);
  TriMesh expected = mesh;
  std::swap(expected.triangles[500][1], expected.triangles[500][2]);
  EXPECT_EQ(result.edit.mesh.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    EXPECT_EQ(result.edit.mesh.triangles[t] == mesh.triangles[t], t != 500) << t;
  }
}

TEST(Mend, RepairsInTheRegionOnly)
{
  TriMesh mesh = corpus::torus(20);
  mesh.triangles.push_back(Triangle(mesh.triangles[100]));
  mesh.triangles.push_back(Triangle(mesh.triangles[500]));
  std::vector<std::uint8_t> inRegion(mesh.triangles.size(), 0);
  inRegion[500] = inRegion.back() = 1;
  Execution execution(1);
  const MendResult result = mend(mesh, inRegion, usual(0.2), execution);
  expectAccounts(mesh, result);
  EXPECT_EQ(result.tally.duplicatesRemoved, 1U);
  EXPECT_EQ(result.edit.mesh.triangles.size(), mesh.triangles.size() - 1);
}

TEST(Mend, RepairsTheKindsThatAreAskedFor)
{
  TriMesh mesh = corpus::torus(20);
  std::swap(mesh.triangles[100][0], mesh.triangles[100][1]);
  mesh.triangles.push_back(Triangle(mesh.triangles[700]));
  MendOptions options = usual(0.2);
  options.defects.kinds = parseDefectKinds("duplicates");
  const MendResult result = mendAll(mesh, options);
  expectAccounts(mesh, result);
  EXPECT_EQ(result.tally.turned, 0U);
  EXPECT_EQ(result.tally.duplicatesRemoved, 1U);
}

TEST(Mend, KeepsTheLimit)
{
  const std::uint64_t first = firstSeed();
  for (std::uint64_t seed = first; seed < first + 20; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SurfaceDamage damage(corpus::torus(20), seed);
    for (int i = 0; i < 10; ++i)
    {
      damage.doSomething();
    }
    MendOptions options = usual(0.3);
    options.maxDeviation = 0.1;
    const MendResult result = mendAll(damage.mesh(), options);
    expectAccounts(damage.mesh(), result);
    EXPECT_LE(result.tally.largestMove, options.maxDeviation);
    EXPECT_EQ(result.tally.componentTriangles, 0U);
    for (std::size_t p = 0; p < result.edit.pointOrigin.size(); ++p)
    {
      if (result.edit.pointOrigin[p] != kNone)
      {
        const Vec3 d =
          result.edit.mesh.points[p] - damage.mesh().points[result.edit.pointOrigin[p]];
        ASSERT_LE(std::sqrt(dot(d, d)), options.maxDeviation);
      }
    }
  }
}

TEST(Mend, RepairsDamagedCopies)
{
  const std::uint64_t first = firstSeed();
  std::size_t good = 0;
  std::size_t all = 0;
  for (std::uint64_t seed = first; seed < first + 100; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    test::SurfaceDamage damage(corpus::torus(16 + static_cast<Index>(seed % 3) * 8), seed);
    for (std::uint64_t i = 0; i < 3 + seed % 20; ++i)
    {
      damage.doSomething();
    }
    const MendResult result = mendAll(damage.mesh(), usual(0.3));
    expectAccounts(damage.mesh(), result);
    const MeshReport report = describeMesh(result.edit.mesh);
    const bool isLeft = result.left.count(DefectKind::selfIntersections) > 0;
    EXPECT_TRUE(report.isManifold && report.isOriented);
    EXPECT_EQ(intersectsItself(result.edit.mesh), isLeft);
    ++all;
    good += result.left.defects.empty() ? 1 : 0;
    if (!result.left.defects.empty())
    {
      std::cout << "seed " << seed << " leaves";
      for (const Defect& defect : result.left.defects)
      {
        std::cout << ' ' << kDefectNames.at(static_cast<std::size_t>(defect.kind)) << '/'
                  << defect.triangles.size();
      }
      std::cout << '\n';
    }
  }
  std::cout << good << " of " << all << " without any defect\n";
  EXPECT_GE(10 * good, 9 * all);
}

TEST(Mend, IsTheSameOnAnyNumberOfThreads)
{
  test::SurfaceDamage damage(corpus::torus(40), 7);
  for (int i = 0; i < 30; ++i)
  {
    damage.doSomething();
  }
  const MendResult one = mendAll(damage.mesh(), usual(0.2), 1);
  const MendResult three = mendAll(damage.mesh(), usual(0.2), 3);
  EXPECT_EQ(one.edit.mesh.points, three.edit.mesh.points);
  EXPECT_EQ(one.edit.mesh.triangles, three.edit.mesh.triangles);
}

TEST(Mend, CanBeCancelled)
{
  const CancelToken token;
  Execution execution(1, token);
  token.cancel();
  const TriMesh mesh = corpus::torus(10);
  EXPECT_ANY_THROW(mend(mesh, std::vector<std::uint8_t>(200, 1), {}, execution));
}

TEST(Orient, TurnsDissentersAndFacesOutwards)
{
  TriMesh mesh = corpus::torus(12);
  const std::vector<Triangle> good = mesh.triangles;
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  std::swap(mesh.triangles[5][1], mesh.triangles[5][2]);
  const std::vector<std::uint8_t> everywhere(good.size(), 1);
  Execution execution(2);
  const OrientResult outward = orientSurface(mesh, everywhere, {}, execution);
  EXPECT_EQ(outward.triangles, good);
  EXPECT_EQ(outward.turned, good.size() - 1);
  EXPECT_EQ(outward.disagreeingPieces, 0U);
  const OrientResult agreed = orientSurface(mesh, everywhere, { .outward = false }, execution);
  EXPECT_EQ(agreed.turned, 1U);
}

TEST(Orient, FlipsTheRegion)
{
  const TriMesh mesh = corpus::torus(12);
  std::vector<std::uint8_t> region(mesh.triangles.size(), 0);
  region[3] = region[9] = 1;
  Execution execution(1);
  const OrientResult some = orientSurface(mesh, region, { .flip = true }, execution);
  EXPECT_EQ(some.turned, 2U);
  EXPECT_EQ(some.disagreeingPieces, 1U);
}

TEST(Orient, TellsOneSidedPieces)
{
  const TriMesh mesh = corpus::moebius();
  Execution execution(1);
  const OrientResult result =
    orientSurface(mesh, std::vector<std::uint8_t>(mesh.triangles.size(), 1), {}, execution);
  EXPECT_EQ(result.disagreeingPieces, 1U);
  EXPECT_EQ(result.pieces, 1U);
}
