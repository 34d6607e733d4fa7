// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/angle_repair.h"
#include "filters/geometry/flatten.h"
#include "filters/geometry/pushes.h"
#include "filters/geometry/shoot.h"
#include "filters/geometry/single_tets.h"
#include "filters/geometry/webs.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/edit_fixtures.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace scan::test
{
namespace
{

using Mode = WrapOptions::Mode;

/// Does something to a model, chosen at random.
class RandomEdit
{
public:
  explicit RandomEdit(std::uint64_t seed)
    : Random(seed)
  {
  }

  /// Returns what it did, in a word.
  std::string operator()(WrapModel& model, EditReport& report)
  {
    const std::vector<Facet> surface = surfaceFacets(model);
    if (surface.empty())
    {
      return "nothing";
    }
    const Facet mark = surface[this->Random() % surface.size()];
    switch (this->Random() % 8)
    {
      case 0:
      case 1:
        report = pushTets(model, std::array{ mark }, this->Run);
        return "push a tetrahedron";
      case 2:
      case 3:
        report = fillTets(model, std::array{ mark }, this->Run);
        return "fill a tetrahedron";
      case 4:
        report = removeWebs(model, {}, { .factor = 1.5 }, this->Run);
        return "remove webs";
      case 5:
        report = flatten(model, {}, this->Run);
        return "flatten";
      case 6:
        report = repairAngles(model, {}, {}, this->Run);
        return "repair angles";
      default:
        this->push(model, mark, report);
        return "push or shoot";
    }
  }

private:
  void push(WrapModel& model, Facet mark, EditReport& report)
  {
    std::vector<BlockName> blocks;
    const auto& points = model.scan->delaunay().points;
    const Vec3& from = points[model.scan->delaunay().facetVertices(mark)[0]];
    const Vec3& to = points[model.scan->delaunay().tetrahedra[mark / 4][mark % 4]];
    if (this->Random() % 2 == 0)
    {
      blocks = blocksInSight(model, mark, from, to - from, this->Run);
    }
    const bool deep = this->Random() % 2 == 0;
    const PushReport pushed =
      scan::push(model, std::array{ mark }, blocks, { .deep = deep }, this->Run);
    report = { .change = pushed.change, .surface = pushed.surface };
  }

  std::mt19937_64 Random;
  Execution Run{ 1 };
};

TEST(ModelEdits, AnySequenceLeavesAComplexAndReportsWhatItDid)
{
  for (const PointSet& set : pointSets(testSeed()))
  {
    for (const Mode mode : { Mode::automatic, Mode::classic })
    {
      RandomEdit edit(set.seed);
      WrapModel model = wrappedModel(set.points, mode);
      for (int step = 0; step < 25; ++step)
      {
        const WrapModel before = model;
        const WrapComplex copy = *before.current;
        EditReport report;
        const std::string done = edit(model, report);
        SCOPED_TRACE(set.name + ", step " + std::to_string(step) + ": " + done +
          ", SCAN_TEST_SEED=" + std::to_string(set.seed));
        expectReported(before, report, model);
        ASSERT_EQ(copy, *before.current) << "an old state has changed";
        ASSERT_FALSE(HasFailure());
      }
    }
  }
}

} // namespace
} // namespace scan::test
