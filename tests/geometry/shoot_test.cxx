// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shoot.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_predicates.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/pushes.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace scan::test
{
namespace
{

/// Exactly: does the closed triangle meet the line? Not asked for triangles in planes along it.
bool meets(const Vec3& from, const Vec3& to, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const int ab = orientation(from, to, a, b);
  const int bc = orientation(from, to, b, c);
  const int ca = orientation(from, to, c, a);
  return (ab | bc | ca) != 0 &&
    ((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0));
}

/// Blocks of the tetrahedra that the line meets, by asking all of them.
std::set<BlockName> blocksOnLine(const WrapModel& model, const Vec3& from, const Vec3& to)
{
  Execution execution(1);
  const Blocks& blocks = model.scan->blocks(execution);
  const DelaunayComplex& complex = model.scan->delaunay();
  std::set<BlockName> names;
  for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
  {
    const Triangle v = complex.facetVertices(facet);
    const auto& p = complex.points;
    if (meets(from, to, p[v[0]], p[v[1]], p[v[2]]))
    {
      names.insert(blockBehind(model, blocks, facet / 4 * 4));
    }
  }
  return names;
}

/// Shots through the whole convex hull.
void expectToMeetWhatTheLineTouches(const PointSet& set, bool alongPoints)
{
  SCOPED_TRACE(set.name + ", SCAN_TEST_SEED=" + std::to_string(set.seed));
  Execution execution(1);
  std::mt19937_64 random(set.seed);
  const WrapModel model = wholeModel(set.points);
  const std::vector<Facet> surface = surfaceFacets(model);
  const auto& p = model.scan->delaunay().points;
  for (int shot = 0; shot < 60; ++shot)
  {
    const Facet facet = surface[random() % surface.size()];
    const Triangle v = model.scan->delaunay().facetVertices(facet);
    const Vec3 from =
      alongPoints ? p[v[random() % 3]] : (p[v[0]] + p[v[1]] + p[v[2]]) * (1.0 / 3.0);
    const Vec3 to = alongPoints
      ? p[random() % p.size()]
      : (p[random() % p.size()] + p[random() % p.size()] + p[random() % p.size()]) * (1.0 / 3.0);
    if (orientation(p[v[0]], p[v[1]], p[v[2]], to) == 0)
    {
      continue;
    }
    const std::vector<BlockName> met = blocksInSight(model, facet, from, to - from, execution);
    const std::set<BlockName> once(met.begin(), met.end());
    ASSERT_EQ(once, blocksOnLine(model, from, to)) << facet;
    ASSERT_EQ(met.size(), once.size());
  }
}

TEST(Shoot, MeetsEveryBlockOnItsWay)
{
  for (const PointSet& set : pointSets(testSeed()))
  {
    if (set.name == "random" || set.name == "sphere with noise")
    {
      expectToMeetWhatTheLineTouches(set, false);
    }
  }
}

TEST(Shoot, MeetsWhatItTouchesAtEdgesAndVertices)
{
  int grids = 0;
  for (const PointSet& set : pointSets(testSeed()))
  {
    if (set.name == "small integers" || set.name == "grid" || set.name == "cospherical")
    {
      expectToMeetWhatTheLineTouches(set, true);
      ++grids;
    }
  }
  EXPECT_EQ(grids, 3);
}

/// A plate of 4 x 4 with a hole around the z axis.
class ShootAtPlate : public testing::Test
{
protected:
  WrapModel plate() const
  {
    return wrappedModel(
      readPoints(std::string(SCAN_DATA_DIR) + "/plate_hole.xyz"), WrapOptions::Mode::automatic);
  }

  /// The triangle of the surface nearest to a point.
  static Facet at(const WrapModel& model, const Vec3& point)
  {
    const auto& p = model.scan->delaunay().points;
    return std::ranges::min(surfaceFacets(model), {},
      [&](Facet facet)
      {
        const Triangle v = model.scan->delaunay().facetVertices(facet);
        return squaredDistance(point, p[v[0]], p[v[1]], p[v[2]]);
      });
  }

  Execution TheExecution{ 1 };
};

TEST_F(ShootAtPlate, StopsWhereItLeavesTheModel)
{
  const WrapModel model = this->plate();
  const auto shoot = [&](double x)
  {
    const Vec3 from{ x, 0.013, 0.47 };
    const std::vector<BlockName> met =
      blocksInSight(model, at(model, from), from, Vec3{ -x, 0.0, 0.0 }, this->TheExecution);
    return std::set(met.begin(), met.end());
  };
  const std::set<BlockName> left = shoot(-2.0);
  const std::set<BlockName> right = shoot(2.0);
  EXPECT_FALSE(left.empty());
  EXPECT_FALSE(right.empty());
  const auto isOnLeft = [&](const BlockName& name)
  {
    const Index sink = model.scan->blocks(this->TheExecution).sink(name.name);
    return model.scan->delaunay().points[model.scan->delaunay().tetrahedra[sink][0]].x < 0.0;
  };
  EXPECT_TRUE(std::ranges::all_of(left, isOnLeft));
  EXPECT_TRUE(std::ranges::none_of(right, isOnLeft));
}

TEST_F(ShootAtPlate, PushingWhatItMeetsOpensAPassage)
{
  WrapModel model = this->plate();
  const Vec3 from{ -1.313, -1.471, 1.0 };
  const Vec3 down{ 0.0, 0.0, -1.0 };
  push(model, {}, blocksInSight(model, at(model, from), from, down, this->TheExecution), {},
    this->TheExecution);
  for (const Facet facet : surfaceFacets(model))
  {
    const Triangle v = model.scan->delaunay().facetVertices(facet);
    const auto& p = model.scan->delaunay().points;
    EXPECT_FALSE(meets(from, from + down, p[v[0]], p[v[1]], p[v[2]])) << facet;
  }
}

TEST_F(ShootAtPlate, RefusesWhatIsNoShot)
{
  const WrapModel model = this->plate();
  const Vec3 top{ -1.3, -1.4, 1.0 };
  const Facet mark = at(model, top);
  EXPECT_THROW(blocksInSight(model, mark, top, { 0, 0, 0 }, this->TheExecution), Error);
  EXPECT_THROW(blocksInSight(model, mark, top, { 1, 0, 0 }, this->TheExecution), Error);
  EXPECT_THROW(blocksInSight(model, mark, top, { 0, 0, std::nan("") }, this->TheExecution), Error);
  for (Facet facet = mark / 4 * 4; facet < mark / 4 * 4 + 4; ++facet)
  {
    if (!isOnSurface(*model.current, facet))
    {
      EXPECT_THROW(blocksInSight(model, facet, top, { 0, 0, -1 }, this->TheExecution), Error);
    }
  }
}

} // namespace
} // namespace scan::test
