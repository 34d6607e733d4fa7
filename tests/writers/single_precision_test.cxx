// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/single_precision.h"

#include "tests/writers/models.h"
#include "writers/used_points.h"

#include <gtest/gtest.h>

using namespace scan;

TEST(SinglePrecision, RoundsAnyNumberOfPoints)
{
  for (std::size_t count = 1; count <= 9; ++count)
  {
    const std::vector<Vec3> points(count, { 10000000.1, -10000000.3, 0.1 });
    for (const Vec3& p : roundedToFloat(points))
    {
      EXPECT_EQ(p, (Vec3{ 10000000.0, -10000000.0, 13421773.0 / 134217728.0 }));
    }
    for (const Vec3& p : roundedToFloat(points, { 10000000.0, -10000000.0, 0.0 }))
    {
      EXPECT_NEAR(p.x, 0.1, 1e-8);
      EXPECT_NE(p.x, 10000000.1 - 10000000.0);
      EXPECT_NEAR(p.y, -0.3, 1e-7);
    }
    EXPECT_NE(originForFloats(points), Vec3{}) << count;
  }
}

TEST(SinglePrecision, ShapesAreWhatHasAreaOrIsACurve)
{
  Model model{ { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 0, 0 }, { 6, 6, 6 }, { 7, 7, 7 } },
    { { 0, 1, 2 }, { 0, 1, 3 } } } };
  EXPECT_EQ(shapePoints(model), (std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  model.curves = { { 4, 2 }, { 2 } };
  EXPECT_EQ(
    shapePoints(model), (std::vector<Vec3>{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 6, 6, 6 } }));
  EXPECT_EQ(shapePoints({ { model.points, {} } }), model.points);
}
