// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/off.h"

#include "readers/ply.h"
#include "tests/readers/parsing.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

namespace
{

using scan::Model;
using scan::test::modelBytes;

void expectAssimpReads(const Model& model)
{
  const scan::test::TemporaryFolder folder;
  scan::test::writeModel(folder.file("out.off"), model, scan::writeOff);
  scan::test::expectSame(scan::test::readWithAssimp(folder.file("out.off")), model);
}

} // namespace

TEST(WrittenOff, ListsPointsAndTriangles)
{
  EXPECT_EQ(modelBytes(scan::test::oneTriangle(), scan::writeOff),
    "OFF\n3 1 0\n0 0 0\n2.5 0 0\n0 -0.125 1e-07\n3 0 1 2\n");
  EXPECT_EQ(modelBytes(scan::test::threePoints(), scan::writeOff),
    "OFF\n3 0 0\n0 0 0\n2.5 0 0\n0 -0.125 1e-07\n");
}

TEST(WrittenOff, HasColorsFromZeroToOne)
{
  Model model = scan::test::threePoints();
  model.colors = { { 0, 1, 128 }, { 255, 254, 2 }, { 3, 3, 3 } };
  EXPECT_EQ(modelBytes(model, scan::writeOff),
    "COFF\n3 0 0\n0 0 0 0.0000 0.0040 0.5020 1.0\n2.5 0 0 1.0000 0.9961 0.0079 1.0\n"
    "0 -0.125 1e-07 0.0118 0.0118 0.0118 1.0\n");
}

TEST(WrittenOff, StopsWhenCancelled)
{
  scan::test::expectCancels(scan::test::oneTriangle(), scan::writeOff);
}

TEST(WrittenOff, IsReadByAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is not installed";
  }
  expectAssimpReads(scan::test::grid(60, 40, true));
  expectAssimpReads(scan::test::grid(60, 40, false));
  expectAssimpReads(scan::test::nonManifold());
  expectAssimpReads(scan::test::colored(scan::test::grid(60, 40, true)));
}

TEST(WrittenOff, GivesAssimpEveryColor)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is not installed";
  }
  const scan::test::TemporaryFolder folder;
  const Model model = scan::test::colored(scan::test::grid(20, 20, true));
  scan::test::writeModel(folder.file("out.off"), model, scan::writeOff);
  const std::string ply = folder.file("out.ply");
  scan::test::outputOf("assimp export " + folder.file("out.off") + " " + ply);
  const Model read = scan::test::parse(scan::parsePly, scan::test::contentOf(ply));
  ASSERT_EQ(read.colors.size(), read.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i)
  {
    const auto at = std::ranges::find_if(model.points,
      [&](const scan::Vec3& p)
      {
        const scan::Vec3 off = p - read.points[i];
        return dot(off, off) < 1e-8; // assimp writes six digits
      });
    ASSERT_NE(at, model.points.end());
    EXPECT_EQ(read.colors[i], model.colors[static_cast<std::size_t>(at - model.points.begin())]);
  }
}
