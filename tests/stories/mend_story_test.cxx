// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/mend.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/cgal_checks.h"
#include "tests/geometry/damage.h"
#include "tests/pipeline/document_fixtures.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using namespace scan;
using scan::test::intersectsItself;

namespace
{

const std::filesystem::path kShared = std::filesystem::path(SCAN_SHARED_DIR) / "data";

/// The surface in a file; empty where it is refused or has none.
TriMesh surfaceOf(const std::filesystem::path& file)
{
  Document document;
  if (import(document, { file.string() }).outcome.state != vtkScanOutcome::State::ok)
  {
    return {};
  }
  const auto result = document.result(document.current(), {});
  auto* const data = vtkPolyData::SafeDownCast(result);
  return data != nullptr && bridge::hasTriangles(*data) ? bridge::meshOf(*data) : TriMesh{};
}

std::string textOf(const DefectList& list)
{
  std::string text;
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind)
  {
    if (const auto count = list.count(static_cast<DefectKind>(kind)); count > 0)
    {
      text.append(" ").append(kDefectNames.at(kind)).append(" ").append(std::to_string(count));
    }
  }
  return text.empty() ? " none" : text;
}

/// Mends, and checks that what comes out is good or what is left is told.
/// @return whether nothing is left
bool expectMended(const TriMesh& mesh, const std::string& name)
{
  SCOPED_TRACE(name);
  const MeshReport before = describeMesh(mesh);
  MendOptions options;
  options.defects.leastHeight = 1e-6 * before.boxDiagonal;
  options.defects.smallHole = 10.0 * before.meanEdge;
  Execution execution;
  const MendResult result =
    mend(mesh, std::vector<std::uint8_t>(mesh.triangles.size(), 1), options, execution);
  const MeshReport report = describeMesh(result.edit.mesh);
  EXPECT_TRUE(report.isManifold && report.isOriented);
  EXPECT_EQ(
    intersectsItself(result.edit.mesh), result.left.count(DefectKind::selfIntersections) > 0);
  EXPECT_EQ(mesh.triangles.size() + result.tally.added(),
    result.edit.mesh.triangles.size() + result.tally.removed());
  if (result.found.defects.empty())
  {
    EXPECT_TRUE(result.edit.mesh.points == mesh.points);
    EXPECT_TRUE(result.edit.mesh.triangles == mesh.triangles);
  }
  else
  {
    std::cout << name << ": found" << textOf(result.found) << "; left" << textOf(result.left)
              << "; removed " << result.tally.removed() << ", added " << result.tally.added()
              << ", largest move " << result.tally.largestMove / before.boxDiagonal
              << " diagonals\n";
  }
  return result.left.defects.empty();
}

std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

class MendFolder : public testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(MendFolder, IsGoodAfterwardsOrTellsWhatIsLeft)
{
  const std::filesystem::path folder = kShared / GetParam();
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is not there: the shared corpus is missing";
  }
  std::size_t all = 0;
  std::size_t good = 0;
  for (const std::filesystem::path& file : filesIn(folder))
  {
    const TriMesh mesh = surfaceOf(file);
    if (!mesh.triangles.empty())
    {
      ++all;
      good += expectMended(mesh, file.filename().string()) ? 1 : 0;
    }
  }
  std::cout << good << " of " << all << " without any defect\n";
  EXPECT_GT(all, 0U);
}

INSTANTIATE_TEST_SUITE_P(Corpus, MendFolder, testing::Values("09_bad", "05_meshes"),
  [](const auto& which) { return std::string(which.index == 0 ? "Bad" : "Meshes"); });

TEST(MendStory, DamagedCopiesAreRepaired)
{
  const std::array files{ "am.off", "blobby.off", "eight.off", "elephant.off", "fandisk.off",
    "femur.off", "joint.off", "knot1.off", "pipe.off", "sphere966.off" };
  std::vector<TriMesh> meshes;
  for (const char* const file : files)
  {
    const std::filesystem::path path = kShared / "05_meshes" / "cgal" / file;
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << path << " is not there: the shared corpus is missing";
    }
    meshes.push_back(surfaceOf(path));
  }
  const char* const given = std::getenv("SCAN_TEST_SEED");
  const std::uint64_t first = given != nullptr ? std::strtoull(given, nullptr, 10) : 1;
  std::size_t good = 0;
  for (std::uint64_t seed = first; seed < first + 200; ++seed)
  {
    test::SurfaceDamage damage(meshes[seed % meshes.size()], seed);
    for (std::uint64_t i = 0; i < 5 + seed % 31; ++i)
    {
      damage.doSomething();
    }
    good += expectMended(damage.mesh(),
              std::string(files.at(seed % meshes.size())) + " seed " + std::to_string(seed))
      ? 1
      : 0;
  }
  std::cout << good << " of 200 without any defect\n";
  EXPECT_GE(good, 160U); // with seeds from 1 196, from 1001 184: coarse meshes are hard
}
