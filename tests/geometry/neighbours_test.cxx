// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/neighbours.h"

#include "tests/geometry/point_fixtures.h"

#include <algorithm>
#include <tuple>

namespace scan::test
{
namespace
{

/// A grid with repeated points: many are equally near.
std::vector<Vec3> latticeWithRepeats()
{
  Random random(pointSeed());
  std::vector<Vec3> points;
  for (int i = 0; i < 800; ++i)
  {
    points.push_back({ static_cast<double>(random.below(9)), static_cast<double>(random.below(9)),
      static_cast<double>(random.below(4)) });
  }
  return points;
}

std::vector<Index> nearestByForce(const Neighbours& places, const Vec3& at)
{
  std::vector<Index> all(places.size());
  for (Index place = 0; place < places.size(); ++place)
  {
    all[place] = place;
  }
  std::ranges::sort(all,
    [&](Index a, Index b)
    {
      const Vec3 toA = places[a] - at;
      const Vec3 toB = places[b] - at;
      return std::make_tuple(dot(toA, toA), a) < std::make_tuple(dot(toB, toB), b);
    });
  return all;
}

TEST(Neighbours, AreThoseOfAnExhaustiveSearchInTheSameOrder)
{
  Execution execution(2);
  const std::vector<Vec3> points = latticeWithRepeats();
  const Neighbours places(points, execution);
  std::vector<Neighbour> found;
  for (Index place = 0; place < places.size(); place += 7)
  {
    const std::vector<Index> expected = nearestByForce(places, places[place]);
    places.nearest(places[place], 11, found);
    ASSERT_EQ(found.size(), 11U);
    EXPECT_EQ(found.front().place, place);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      EXPECT_EQ(found[i].place, expected[i]) << "SCAN_TEST_SEED=" << pointSeed();
    }
    places.within(places[place], 2.0, found);
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      const Vec3 d = places[expected[i]] - places[place];
      ASSERT_EQ(i < found.size(), dot(d, d) < 4.0);
      if (i < found.size())
      {
        EXPECT_EQ(found[i].place, expected[i]);
      }
    }
  }
}

TEST(Neighbours, LeaveOutWhatDoesNotCount)
{
  Execution execution(1);
  const Neighbours places(latticeWithRepeats(), execution);
  std::vector<std::uint8_t> isLeftOut(places.size(), 1);
  isLeftOut[5] = 0;
  std::vector<Neighbour> found;
  places.nearest(places[200], 3, found, isLeftOut);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found.front().place, 5U);
}

TEST(Neighbours, PlacesHoldEveryPointOnce)
{
  Execution execution(1);
  for (const auto& [name, points] : degenerateClouds())
  {
    const Neighbours places(points, execution);
    std::vector<int> times(points.size(), 0);
    for (Index place = 0; place < places.size(); ++place)
    {
      EXPECT_TRUE(std::ranges::is_sorted(places.pointsAt(place))) << name;
      for (const Index point : places.pointsAt(place))
      {
        EXPECT_EQ(points[point], places[place]) << name;
        ++times[point];
      }
    }
    EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(points.size())) << name;
  }
  EXPECT_EQ(Neighbours(degenerateClouds()[4].second, execution).size(), 1U);
}

TEST(Neighbours, RefuseAndStop)
{
  expectRefusesAndStops([](const std::vector<Vec3>& points, Execution& execution)
    { const Neighbours places(points, execution); });
}

} // namespace
} // namespace scan::test
