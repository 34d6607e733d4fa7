// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/xyz.h"

#include "readers/points_text.h"
#include "tests/readers/parsing.h"
#include "tests/writers/models.h"

namespace
{

using scan::Model;
using scan::test::modelBytes;

} // namespace

TEST(WrittenXyz, HasOnePointALine)
{
  EXPECT_EQ(
    modelBytes(scan::test::threePoints(), scan::writeXyz), "0 0 0\n2.5 0 0\n0 -0.125 1e-07\n");
  EXPECT_EQ(modelBytes(scan::test::oneTriangle(), scan::writeXyz),
    modelBytes(scan::test::threePoints(), scan::writeXyz));
}

TEST(WrittenXyz, PutsColorsAheadOfNormals)
{
  Model model = scan::test::threePoints();
  model.normals = { { 0, 0, 1 }, { 0.6, -0.8, 0 }, { 0, 0, 0 } };
  EXPECT_EQ(
    modelBytes(model, scan::writeXyz), "0 0 0 0 0 1\n2.5 0 0 0.6 -0.8 0\n0 -0.125 1e-07 0 0 0\n");
  model.colors = { { 0, 1, 128 }, { 255, 254, 2 }, { 3, 3, 3 } };
  EXPECT_EQ(modelBytes(model, scan::writeXyz),
    "0 0 0 0 1 128 0 0 1\n2.5 0 0 255 254 2 0.6 -0.8 0\n0 -0.125 1e-07 3 3 3 0 0 0\n");
}

TEST(WrittenXyz, HoldsTheLongestNumbers)
{
  Model model;
  const double longest = -1.2345678901234567e-105;
  model.points = { { longest, longest, longest } };
  model.normals = model.points;
  model.colors = { { 100, 200, 255 } };
  const std::string three = "-1.2345678901234567e-105 -1.2345678901234567e-105 "
                            "-1.2345678901234567e-105";
  EXPECT_EQ(modelBytes(model, scan::writeXyz), three + " 100 200 255 " + three + "\n");
}

TEST(WrittenXyz, StopsWhenCancelled)
{
  scan::test::expectCancels(scan::test::threePoints(), scan::writeXyz);
}

TEST(WrittenXyz, ReadsBackWithoutLoss)
{
  const Model model = scan::test::grid(60, 40, true);
  const auto read = scan::test::parse(scan::parsePointsText, modelBytes(model, scan::writeXyz));
  EXPECT_EQ(read.points, model.points);
}

TEST(WrittenXyz, RefusesAnEmptyModel)
{
  EXPECT_EQ(scan::test::writeError({}, scan::writeXyz), scan::ErrorCode::badInput);
}
