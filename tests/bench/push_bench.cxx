// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What a person waits for at a pick, in milliseconds, on a classic wrap that is prepared for edits:
// pushes, pulls, the size slider, the triangle and the block at a point. Two threads and one.
//
//   push_bench [POINTS]      default: 1000000

#include "filters/geometry/block_marks.h"
#include "filters/geometry/facet_search.h"
#include "filters/geometry/pushes.h"
#include "filters/geometry/wrap.h"
#include "tests/bench/knot_scan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace
{

using namespace scan;

double milliseconds(const std::function<void()>& act)
{
  const auto start = std::chrono::steady_clock::now();
  act();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}

void print(const char* what, std::vector<double> times, double tets)
{
  std::ranges::sort(times);
  std::printf("  %-28s %5zu  median %8.1f  p95 %8.1f  max %8.1f ms   most tetrahedra %.0f\n", what,
    times.size(), times[times.size() / 2], times[times.size() * 95 / 100], times.back(), tets);
}

/// Both faces of a plate with a round hole, and the wall of the hole, with a little noise.
std::vector<Vec3> platePoints(std::size_t count)
{
  constexpr double kHole = 0.45;
  constexpr double kHeight = 0.4;
  constexpr double kNoise = 0.0005;
  std::mt19937_64 random(2003);
  std::uniform_real_distribution<double> at(-1.0, 1.0);
  std::vector<Vec3> points;
  while (points.size() < count)
  {
    const double noise = kNoise * at(random);
    const double x = at(random);
    const double y = at(random);
    if (std::hypot(x, y) > kHole)
    {
      points.push_back({ x, y, (random() % 2 == 0 ? 0.0 : kHeight) + noise });
    }
    if (points.size() % 8 == 0)
    {
      const double turn = std::numbers::pi * at(random);
      points.push_back({ (kHole + noise) * std::cos(turn), (kHole + noise) * std::sin(turn),
        0.5 * kHeight * (1.0 + at(random)) });
    }
  }
  return points;
}

struct Bench
{
  WrapModel model;
  std::vector<Facet> facets;
  Execution& execution;

  /// Pushes single marks, and pulls back what went.
  void push(const char* name, const std::vector<Facet>& marks, bool deep) const
  {
    std::vector<double> pushed;
    std::vector<double> pulled;
    std::int64_t most = 0;
    for (const Facet mark : marks)
    {
      WrapModel next = this->model;
      PushReport report;
      pushed.push_back(milliseconds(
        [&]
        {
          report = scan::push(
            next, std::array{ mark }, {}, { .deep = deep, .compare = false }, this->execution);
        }));
      most = std::max(most, -report.change.tetrahedra);
      pulled.push_back(
        milliseconds([&] { pull(next, report.blocks, { .compare = false }, this->execution); }));
    }
    print(name, pushed, static_cast<double>(most));
    print("  and pulled back", pulled, static_cast<double>(most));
  }

  /// The slider from the largest opening to the smallest and back, in even ratios.
  void slide() const
  {
    const Blocks& blocks = this->model.scan->blocks(this->execution);
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (Index block = 0; block < blocks.outside(); ++block)
    {
      if (blocks.isVolume(block))
      {
        largest = std::max(largest, blocks.opening(block));
        smallest = std::min(smallest, blocks.opening(block));
      }
    }
    constexpr int kSteps = 100;
    const SizeScale& sizes = this->model.scan->sizes(this->execution);
    WrapComplex kept = *this->model.start;
    double size = std::numeric_limits<double>::infinity();
    std::vector<double> times;
    std::int64_t most = 0;
    for (int step = 0; step <= 2 * kSteps; ++step)
    {
      const double part = static_cast<double>(std::min(step, 2 * kSteps - step)) / kSteps;
      const double next = 1.001 * largest * std::pow(smallest / largest, part);
      WrapEditor editor(kept, *this->model.lines);
      times.push_back(
        milliseconds([&] { sizes.resize(editor, kept, size, next, this->execution); }));
      most = std::max(most, std::abs(editor.change().tetrahedra));
      size = next;
    }
    print("slider", times, static_cast<double>(most));
  }

  void pick(const std::vector<Vec3>& points) const
  {
    std::vector<double> triangle;
    std::vector<double> block;
    for (std::size_t i = 0; i < 20; ++i)
    {
      triangle.push_back(milliseconds([&]
        { nearestFacet(this->model.scan->delaunay(), this->facets, points[i], this->execution); }));
      block.push_back(
        milliseconds([&] { removedBlockAt(this->model, points[i], this->execution); }));
    }
    print("triangle at a point", triangle, 0.0);
    print("removed block at a point", block, 0.0);
  }
};

/// The triangle whose block is the largest that is kept.
Facet largestHollow(const Bench& bench)
{
  const Blocks& blocks = bench.model.scan->blocks(bench.execution);
  return *std::ranges::max_element(bench.facets, {},
    [&](Facet facet)
    {
      const BlockName block = blockBehind(bench.model, blocks, facet);
      return block.isSheet ? 0.0 : sizeOf(blocks, block);
    });
}

void run(const char* name, const std::vector<Vec3>& points, unsigned threads)
{
  Execution execution(threads);
  std::shared_ptr<const ScanComplex> scan;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::printf("%s, %zu points, %u threads\n", name, points.size(), threads);
  std::printf("  complex %.0f ms\n",
    milliseconds([&] { scan = std::make_shared<const ScanComplex>(points, execution); }));
  WrapResult wrapped;
  std::printf("  wrap %.0f ms\n",
    milliseconds([&] { wrapped = wrap(scan, { .mode = WrapOptions::Mode::classic }, execution); }));
  std::printf("  prepare edits %.0f ms\n", milliseconds([&] { scan->prepareEdits(execution); }));
  const Bench bench{ std::move(wrapped.model), std::move(wrapped.facets), execution };
  std::mt19937_64 random(1);
  std::vector<Facet> marks(200);
  std::ranges::generate(marks, [&] { return bench.facets[random() % bench.facets.size()]; });
  bench.push("push shallow", marks, false);
  bench.push("push deep", marks, true);
  bench.push("push deep, largest hollow", std::vector<Facet>(20, largestHollow(bench)), true);
  bench.slide();
  bench.pick(points);
  print("whole surface, unsplit",
    { milliseconds([&] { surfaceOf(bench.model, false, execution); }) }, 0.0);
  print("whole surface, split", { milliseconds([&] { surfaceOf(bench.model, true, execution); }) },
    0.0);
}

} // namespace

int main(int argc, char** argv)
{
  const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  for (const unsigned threads : { 2U, 1U })
  {
    run("knot", bench::knotScan(std::max<std::size_t>(count, 1000)), threads);
    run("plate", platePoints(std::max<std::size_t>(count, 1000)), threads);
  }
  return 0;
}
