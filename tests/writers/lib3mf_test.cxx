// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/threemf.h"
#include "tests/readers/parsing.h"
#include "tests/writers/lib3mf_reading.h"
#include "tests/writers/models.h"
#include "writers/threemf.h"

namespace
{

const auto kWrite = scan::test::aroundItsMiddle(scan::writeThreemf);

void expectSameInLib3mf(const scan::Model& model, bool isClosed)
{
  const scan::test::TemporaryFolder folder;
  scan::test::writeModel(folder.file("ours.3mf"), model, kWrite);
  const scan::test::Lib3mfResult theirs =
    scan::test::readWithLib3mf(folder.file("ours.3mf"), folder.file("theirs.3mf"));
  EXPECT_TRUE(theirs.isRead);
  EXPECT_EQ(theirs.warnings, 0U);
  EXPECT_EQ(theirs.vertices, model.points.size());
  EXPECT_EQ(theirs.triangles, model.triangles.size());
  EXPECT_EQ(theirs.isClosed, isClosed);
  const scan::Model back = // with the numbers of zip64
    scan::test::parse(scan::parseThreemf, scan::test::contentOf(folder.file("theirs.3mf")));
  EXPECT_EQ(back.triangles, model.triangles);
  EXPECT_EQ(back.millimetresPerUnit, model.millimetresPerUnit);
  scan::test::expectSame(back, model);
}

} // namespace

TEST(Threemf, AgreesWithLib3mf)
{
  if (!scan::test::hasLib3mf())
  {
    GTEST_SKIP() << "lib3mf is missing";
  }
  scan::Model model = scan::test::grid(60, 60, true);
  model.millimetresPerUnit = 25.4;
  expectSameInLib3mf(model, true);
  model.triangles.pop_back();
  expectSameInLib3mf(model, false);
  const scan::Vec3 far{ 6.5e8, -5.6e9, 3e8 }; // more than lib3mf takes, without the transform
  model = scan::test::moved(scan::test::grid(60, 60, true), far);
  model.millimetresPerUnit = 1.0;
  expectSameInLib3mf(model, true);
}
