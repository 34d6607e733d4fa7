// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/spacing.h"
#include "tests/pipeline/document_fixtures.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <span>
#include <vector>

using namespace scan;

namespace
{

std::string shared(const std::string& name)
{
  return std::string(SCAN_SHARED_DIR) + "/data/" + name;
}

/// How far each point is from a surface.
std::vector<double> distances(const std::vector<Vec3>& points, vtkPolyData& surface)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(&surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  std::vector<double> found;
  for (const Vec3& point : points)
  {
    const std::array<double, 3> p{ point.x, point.y, point.z };
    std::array<double, 3> nearest{};
    vtkIdType id = 0;
    int part = 0;
    double squared = 0.0;
    locator->FindClosestPoint(p.data(), nearest.data(), cell, id, part, squared);
    found.push_back(std::sqrt(squared));
  }
  return found;
}

/// Per point of the first step whether remove-outliers takes it away.
std::vector<bool> removedPoints(Document& document)
{
  const auto before = document.result(1, {});
  expectOk(apply(document, "remove-outliers"));
  std::vector<bool> isRemoved(static_cast<std::size_t>(before->GetNumberOfPoints()), true);
  for (const vtkIdType id : bridge::scanPointIdsOf(*document.result(document.current(), {})))
  {
    isRemoved[static_cast<std::size_t>(id)] = false;
  }
  return isRemoved;
}

/// Of the points that are known to be stray or not.
struct Score
{
  std::size_t right = 0;  ///< removed strays
  std::size_t wrong = 0;  ///< removed others
  std::size_t missed = 0; ///< strays that stayed

  double precision() const
  {
    return static_cast<double>(this->right) / static_cast<double>(this->right + this->wrong);
  }
  double recall() const
  {
    return static_cast<double>(this->right) / static_cast<double>(this->right + this->missed);
  }
};

/// @param good, stray points nearer than the one and farther than the other are known
Score scoreOf(const std::vector<bool>& isRemoved, const std::vector<double>& distance, double good,
  double stray)
{
  Score score;
  for (std::size_t i = 0; i < distance.size(); ++i)
  {
    score.right += distance[i] > stray && isRemoved[i] ? 1 : 0;
    score.missed += distance[i] > stray && !isRemoved[i] ? 1 : 0;
    score.wrong += distance[i] < good && isRemoved[i] ? 1 : 0;
  }
  return score;
}

void tell(const std::string& what, const Score& score)
{
  std::cout << what << ": of " << score.right + score.missed << " strays " << score.right
            << " removed, and " << score.wrong << " others: precision " << score.precision()
            << ", recall " << score.recall() << "\n";
}

/// Points anywhere in the box around the points, enlarged by a tenth.
std::vector<Vec3> straysAround(const std::vector<Vec3>& points, double share)
{
  Vec3 low = points.front();
  Vec3 high = points.front();
  for (const Vec3& p : points)
  {
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(-0.05, 1.05);
  std::vector<Vec3> strays(static_cast<std::size_t>(share * static_cast<double>(points.size())));
  for (Vec3& stray : strays)
  {
    stray = { low.x + part(random) * (high.x - low.x), low.y + part(random) * (high.y - low.y),
      low.z + part(random) * (high.z - low.z) };
  }
  return strays;
}

void writePoints(const std::string& path, const std::vector<Vec3>& points)
{
  std::ofstream file(path);
  file.precision(17);
  for (const Vec3& p : points)
  {
    file << p.x << " " << p.y << " " << p.z << "\n";
  }
}

} // namespace

TEST(OutlierStory, TheScansOfTheBunnyAgainstItsSurface)
{
  const std::string folder = shared("02_range_scans/stanford_bunny/");
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is not there: the shared corpus is missing";
  }
  TextList files;
  for (const char* const name : { "bun000", "bun045", "bun090", "bun180", "bun270", "bun315",
         "chin", "ear_back", "top2", "top3" })
  {
    files.push_back(folder + "data/" + name + ".ply");
  }
  Document document(std::int64_t{ 1 } << 30U);
  expectOk(document.import(
    completeValues(openParameters(),
      { { "files", files }, { "as", "points" }, { "transforms", folder + "data/bun.conf" } },
      "open"),
    {}, nullptr));
  const std::vector<bool> isRemoved = removedPoints(document);

  Document truth;
  expectOk(import(truth, { folder + "reconstruction/bun_zipper.ply" }));
  const std::vector<double> distance =
    distances(bridge::pointsOf(*document.result(1, {})), *truth.result(1, {}));
  // metres; the registered points lie within 0.6 mm of the published surface (99 %)
  constexpr double kGood = 0.0006;
  for (const double stray : { 0.002, 0.003, 0.005 })
  {
    const Score score = scoreOf(isRemoved, distance, kGood, stray);
    tell("bunny, farther than " + std::to_string(1000 * stray) + " mm", score);
    EXPECT_EQ(score.wrong, 0U);
    EXPECT_LE(score.missed, stray > 0.0025 ? 0U : 1U);
  }
}

TEST(OutlierStory, StraysAmongRealScans)
{
  for (const char* const name : { "bun000", "bun090", "bun180", "top2" })
  {
    const std::string path =
      shared(std::string("02_range_scans/stanford_bunny/data/") + name + ".ply");
    if (!std::filesystem::exists(path))
    {
      GTEST_SKIP() << path << " is not there: the shared corpus is missing";
    }
    for (const double share : { 0.01, 0.05 })
    {
      SCOPED_TRACE(name);
      Document scan;
      expectOk(import(scan, { path }));
      std::vector<Vec3> points = bridge::pointsOf(*scan.result(1, {}));
      const std::size_t good = points.size();
      const std::vector<Vec3> strays = straysAround(points, share);
      points.insert(points.end(), strays.begin(), strays.end());
      const std::string file = testFolder() + "/strays.xyz";
      writePoints(file, points);

      Document document(std::int64_t{ 1 } << 30U);
      expectOk(import(document, { file }));
      std::vector<double> distance = distances(points, *scan.result(1, {}));
      const double spacing = meanSpacing(std::span(points).first(good));
      const Score score = scoreOf(removedPoints(document), distance, 0.5 * spacing, 6.0 * spacing);
      tell(std::string(name) + " with " + std::to_string(strays.size()) + " strays", score);
      EXPECT_GE(score.precision(), 0.9);
      EXPECT_GE(score.recall(), 0.9);
    }
  }
}
