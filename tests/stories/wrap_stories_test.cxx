// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Real and synthetic scans of the shared corpus, from the file to the finished surface.
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/wrap.h"
#include "tests/stories/corpus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace scan::test
{
namespace
{

namespace fs = std::filesystem;
using Mode = WrapOptions::Mode;

const fs::path kBunny = kData / "02_range_scans/stanford_bunny";

WrapResult run(const std::vector<Vec3>& points, const WrapOptions& options = {})
{
  Execution execution;
  return wrap(points, options, execution);
}

struct Expected
{
  const char* file;
  double leastShare; ///< of the distinct points on the surface
  long genus;
};

void PrintTo(const Expected& expected, std::ostream* out)
{
  *out << expected.file;
}

class ClosedSurfaces : public testing::TestWithParam<Expected>
{
};

TEST_P(ClosedSurfaces, AreOneClosedManifoldOfTheRightGenus)
{
  const Expected& expected = GetParam();
  SCAN_NEED(kData / expected.file);
  const WrapResult result = run(load(kData / expected.file));
  const MeshReport mesh = describeMesh(result.surface);
  EXPECT_TRUE(mesh.isClosed);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_TRUE(mesh.isOriented);
  EXPECT_EQ(mesh.components.size(), 1U);
  EXPECT_EQ(mesh.genus, expected.genus);
  EXPECT_GT(mesh.volume.value_or(0.0), 0.0);
  const WrapReport& report = result.report;
  EXPECT_GE(report.pointsOnSurface,
    expected.leastShare * static_cast<double>(report.pointsRead - report.duplicatesMerged));
}

INSTANTIATE_TEST_SUITE_P(Scans, ClosedSurfaces,
  testing::Values(
    Expected{ "02_range_scans/stanford_bunny/reconstruction/bun_zipper.ply", 0.9995, 0 },
    Expected{ "01_points/cgal/kitten.xyz", 1.0, 1 }, Expected{ "synthetic/plate_hole.xyz", 1.0, 1 },
    Expected{ "synthetic/torus5k.xyz", 1.0, 1 },
    Expected{ "synthetic/torus5k_noise.xyz", 0.999, 1 }),
  [](const auto& test) { return fs::path(test.param.file).stem().string(); });

struct Counts
{
  const char* file;
  Index tetrahedraKept; ///< 0: not stated
  Index boundaryTriangles;
  Index sheetTriangles;
  Index pointsOnSurface; ///< 0: not stated
};

void PrintTo(const Counts& expected, std::ostream* out)
{
  *out << expected.file;
}

class ClassicCounts : public testing::TestWithParam<Counts>
{
};

TEST_P(ClassicCounts, AreThoseOfTheDefinition)
{
  const Counts& expected = GetParam();
  SCAN_NEED(kData / expected.file);
  const WrapReport report =
    run(load(kData / expected.file), { .mode = Mode::classic, .manifold = false }).report;
  if (expected.tetrahedraKept > 0)
  {
    EXPECT_EQ(report.tetrahedraKept, expected.tetrahedraKept);
  }
  EXPECT_EQ(report.boundaryTriangles, expected.boundaryTriangles);
  EXPECT_EQ(report.sheetTriangles, expected.sheetTriangles);
  if (expected.pointsOnSurface > 0)
  {
    EXPECT_EQ(report.pointsOnSurface, expected.pointsOnSurface);
  }
}

INSTANTIATE_TEST_SUITE_P(Scans, ClassicCounts,
  testing::Values(Counts{ "synthetic/plate_hole.xyz", 18327, 9238, 0, 0 },
    Counts{ "synthetic/torus5k.xyz", 0, 10002, 3, 0 },
    Counts{ "synthetic/helix.xyz", 0, 724, 0, 324 }),
  [](const auto& test) { return fs::path(test.param.file).stem().string(); });

TEST(ClassicWrap, MonkeySaddleIsAlmostAllSheet)
{
  const fs::path file = kData / "synthetic/monkey_saddle.xyz";
  SCAN_NEED(file);
  const WrapReport report = run(load(file), { .mode = Mode::classic }).report;
  EXPECT_EQ(report.pointsOnSurface, 2340U);
  EXPECT_GT(report.sheetTriangles, 20 * report.boundaryTriangles);
}

/// The range scans in one frame: bun.conf holds `bmesh file tx ty tz qx qy qz qw`, the quaternion
/// to be used transposed.
std::vector<Vec3> alignedBunnyScans()
{
  std::vector<Vec3> all;
  std::ifstream conf(kBunny / "data/bun.conf");
  for (std::string line; std::getline(conf, line);)
  {
    std::istringstream words(line);
    std::string keyword;
    std::string name;
    Vec3 t;
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;
    double w = 1.0;
    words >> keyword >> name >> t.x >> t.y >> t.z >> x >> y >> z >> w;
    if (keyword != "bmesh")
    {
      continue;
    }
    const double s = 2.0 / (x * x + y * y + z * z + w * w);
    // columns of the rotation matrix: the transposed matrix has them as rows
    const Vec3 c0{ 1.0 - s * (y * y + z * z), s * (x * y + z * w), s * (x * z - y * w) };
    const Vec3 c1{ s * (x * y - z * w), 1.0 - s * (x * x + z * z), s * (y * z + x * w) };
    const Vec3 c2{ s * (x * z + y * w), s * (y * z - x * w), 1.0 - s * (x * x + y * y) };
    for (const Vec3& p : load(kBunny / "data" / name))
    {
      all.push_back(Vec3{ dot(c0, p), dot(c1, p), dot(c2, p) } + t);
    }
  }
  return all;
}

TEST(RawBunny, AutomaticWrapIsOneDominantClosedSurface)
{
  SCAN_NEED(kBunny / "data/bun.conf");
  const std::vector<Vec3> points = alignedBunnyScans();
  ASSERT_EQ(points.size(), 362272U);
  const WrapResult result = run(points);
  const MeshReport mesh = describeMesh(result.surface);
  ASSERT_FALSE(mesh.components.empty());
  const ComponentReport& dominant = mesh.components.front();
  EXPECT_GE(dominant.points, 0.995 * static_cast<double>(points.size()));
  EXPECT_GE(dominant.triangles, 0.99 * static_cast<double>(mesh.triangles));
  EXPECT_EQ(dominant.boundaryLoops, 0U);
  EXPECT_TRUE(mesh.isManifold);
  EXPECT_LT(result.report.nonManifoldEdges, 60U);
  // no web or spike: the scans are half a millimetre dense, one stray point is 86 mm away
  EXPECT_LT(mesh.longestEdge, 0.025);
}

TEST(RawBunny, ClassicWrapFinishes)
{
  SCAN_NEED(kBunny / "data/bun.conf");
  const WrapResult result = run(alignedBunnyScans(), { .mode = Mode::classic });
  EXPECT_TRUE(describeMesh(result.surface).isManifold);
  EXPECT_GT(result.report.pointsOnSurface, 300000U);
}

} // namespace
} // namespace scan::test
