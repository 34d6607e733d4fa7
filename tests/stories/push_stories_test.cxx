// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Pushing by hand on the scans of the shared corpus.
#include "filters/base/error.h"
#include "filters/geometry/pushes.h"
#include "filters/geometry/wrap.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/stories/corpus.h"

#include <random>

namespace scan::test
{
namespace
{

class PushAndPull : public testing::TestWithParam<const char*>
{
};

TEST_P(PushAndPull, GiveBackTheIdenticalStateForAThousandMarks)
{
  SCAN_NEED(kData / GetParam());
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(testSeed()));
  Execution execution;
  const WrapResult start =
    wrap(load(kData / GetParam()), { .mode = WrapOptions::Mode::classic }, execution);
  std::mt19937_64 random(testSeed());
  std::size_t most = 0;
  for (int mark = 0; mark < 1000; ++mark)
  {
    const std::vector<Facet> picked{ start.facets[random() % start.facets.size()] };
    const PushOptions options{ .deep = mark % 5 == 0 };
    WrapModel model = start.model;
    const PushReport pushed = push(model, picked, {}, options, execution);
    ASSERT_FALSE(*model.current == *start.model.current);
    const BlockName first =
      blockBehind(start.model, start.model.scan->blocks(execution), picked.front());
    const PushReport pulled = pull(model, std::vector{ first }, options, execution);
    ASSERT_EQ(*model.current, *start.model.current) << "triangle " << picked.front();
    ASSERT_EQ(pulled.blocks.size(), pushed.blocks.size());
    most = std::max(most, pushed.blocks.size());
  }
  EXPECT_GT(most, 20U); // some went deep
}

INSTANTIATE_TEST_SUITE_P(Scans, PushAndPull,
  testing::Values(
    "synthetic/plate_hole.xyz", "synthetic/torus5k_noise.xyz", "01_points/hoppe/distcap.pts"),
  [](const auto& test) { return std::filesystem::path(test.param).stem().string(); });

/// Every file of the corpus that has points of one scan, bad files aside.
std::vector<std::filesystem::path> scanFiles()
{
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::exists(kData))
  {
    return files;
  }
  constexpr std::uintmax_t kLargest = 3000000;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kData))
  {
    const std::filesystem::path& path = entry.path();
    const std::string kind = path.extension().string();
    const bool isScan = kind == ".xyz" || kind == ".pts" || kind == ".pwn" || kind == ".ply" ||
      kind == ".stl" || kind == ".obj";
    if (isScan && path.string().find("09_bad") == std::string::npos &&
      entry.file_size() <= kLargest)
    {
      files.push_back(path);
    }
  }
  std::ranges::sort(files);
  return files;
}

TEST(Corpus, SameSurfaceOnOneAndTwoThreads)
{
  SCAN_NEED(kData);
  std::size_t compared = 0;
  for (const std::filesystem::path& path : scanFiles())
  {
    SCOPED_TRACE(path.string());
    std::vector<Vec3> points;
    try
    {
      points = load(path);
    }
    catch (const Error&) // formats that share an extension; the readers' tests say which
    {
      continue;
    }
    for (const WrapOptions::Mode mode :
      { WrapOptions::Mode::automatic, WrapOptions::Mode::classic })
    {
      std::vector<WrapResult> results;
      for (const unsigned threads : { 1U, 2U })
      {
        Execution execution(threads);
        try
        {
          results.push_back(wrap(points, { .mode = mode }, execution));
        }
        catch (const Error&) // flat
        {
          results.emplace_back();
        }
      }
      EXPECT_EQ(results[0].surface.points, results[1].surface.points);
      EXPECT_TRUE(results[0].surface.triangles == results[1].surface.triangles);
      EXPECT_EQ(results[0].scanPointIds, results[1].scanPointIds);
      EXPECT_EQ(results[0].lines, results[1].lines);
      compared += results[0].surface.triangles.empty() ? 0 : 1;
    }
  }
  EXPECT_GE(compared, 80U);
}

} // namespace
} // namespace scan::test
