// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Scans with openings, and scans without that must stay closed, from the file to the surface.
#include "filters/geometry/automatic_wrap.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/outside_rooms.h"
#include "tests/stories/corpus.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace scan::test
{
namespace
{

namespace fs = std::filesystem;

/// The lines that hold three coordinates behind `prefix`.
std::vector<Vec3> loadLines(const fs::path& path, const std::string& prefix)
{
  std::vector<Vec3> points;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string first;
    Vec3 p;
    std::string more;
    if ((prefix.empty() || (words >> first && first == prefix)) && words >> p.x >> p.y >> p.z &&
      !(words >> more))
    {
      points.push_back(p);
    }
  }
  return points;
}

struct Wrapped
{
  bool isOpen;
  double points; ///< distinct
  MeshReport mesh;
};

Wrapped wrapped(const std::vector<Vec3>& points, Opening opening = Opening::automatic)
{
  Execution execution;
  const DelaunayComplex complex = buildDelaunayComplex(points, execution);
  const FlowComplex flow(complex, execution);
  const AutomaticWrap wrap = wrapAutomatically(
    flow, findBasins(flow, execution), { .fineTune = true, .opening = opening }, execution);
  TriMesh mesh{ complex.points, {} };
  for (const Facet facet : wrap.surface)
  {
    mesh.triangles.push_back(outwardVertices(complex, wrap.inside, facet));
  }
  return { wrap.isOpen, static_cast<double>(complex.points.size()), describeMesh(mesh) };
}

TEST(OpenScans, DistributorCapIsOpenBelowAndWholeElsewhere)
{
  const fs::path file = kData / "01_points/hoppe/distcap.pts";
  SCAN_NEED(file);
  const Wrapped result = wrapped(loadLines(file, "p"));
  ASSERT_EQ(result.points, 12745);
  EXPECT_TRUE(result.isOpen);
  EXPECT_GE(result.mesh.pointsUsed, 0.999 * result.points);
  EXPECT_EQ(result.mesh.nonManifoldEdges, 0U);
  EXPECT_LT(result.mesh.boundaryEdges, 250U);
  EXPECT_GT(result.mesh.boundaryEdges, 50U);
  EXPECT_TRUE(result.mesh.isOriented);
}

TEST(OpenScans, MonkeySaddleIsADiskThroughEveryPoint)
{
  const fs::path file = kData / "synthetic/monkey_saddle.xyz";
  SCAN_NEED(file);
  const Wrapped result = wrapped(load(file));
  EXPECT_TRUE(result.isOpen);
  EXPECT_EQ(result.mesh.pointsUsed, 2340U);
  EXPECT_EQ(result.mesh.components.size(), 1U);
  EXPECT_EQ(result.mesh.boundaryLoops, 1U);
  EXPECT_EQ(result.mesh.eulerCharacteristic, 1);
  EXPECT_TRUE(result.mesh.isManifold);
  EXPECT_TRUE(result.mesh.isOriented);
}

TEST(OpenScans, RangeImageIsOneSheetForTheMostPart)
{
  const fs::path file = kData / "02_range_scans/stanford_bunny/data/bun000.ply";
  SCAN_NEED(file);
  const Wrapped result = wrapped(load(file));
  EXPECT_TRUE(result.isOpen);
  EXPECT_GE(result.mesh.pointsUsed, 0.998 * result.points);
  EXPECT_LT(result.mesh.boundaryEdges, 700U);
  EXPECT_LT(result.mesh.components.size(), 20U);
  ASSERT_FALSE(result.mesh.components.empty());
  EXPECT_GE(result.mesh.components.front().triangles, 0.9 * result.mesh.triangles);
}

TEST(OpenScans, CapClosesWhatIsOpen)
{
  const fs::path file = kData / "synthetic/monkey_saddle.xyz";
  SCAN_NEED(file);
  const Wrapped result = wrapped(load(file), Opening::cap);
  EXPECT_FALSE(result.isOpen);
  EXPECT_EQ(result.mesh.boundaryEdges, 0U);
}

TEST(ClosedScans, ContoursOfACraniumStayClosed)
{
  const fs::path file = kData / "07_contours/skull.pts";
  SCAN_NEED(file);
  const Wrapped result = wrapped(loadLines(file, ""));
  ASSERT_EQ(result.points, 21333);
  EXPECT_FALSE(result.isOpen);
  EXPECT_GE(result.mesh.pointsUsed, 0.998 * result.points);
  EXPECT_LE(result.mesh.nonManifoldEdges, 12U);
}

TEST(ClosedScans, MannequinStaysClosedAndKeepsItsPoints)
{
  const fs::path file = kData / "05_meshes/cgal/mannequin-devil.off";
  SCAN_NEED(file);
  std::vector<Vec3> points = loadLines(file, "");
  ASSERT_GE(points.size(), 12977U);
  points.erase(points.begin(), points.end() - 12977); // the first line of three words is a count
  const Wrapped result = wrapped(points);
  EXPECT_FALSE(result.isOpen);
  EXPECT_GE(result.mesh.pointsUsed, 12972U);
  EXPECT_EQ(result.mesh.nonManifoldEdges, 0U);
}

} // namespace
} // namespace scan::test
