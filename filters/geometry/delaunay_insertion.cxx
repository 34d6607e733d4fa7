// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_insertion.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_predicates.h"
#include "filters/geometry/delaunay_worker.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

/// The first four points that are not in one plane.
std::array<Index, 4> firstTetrahedron(std::span<const Vec3> points)
{
  const auto refuse = [](const char* shape)
  {
    throw Error(ErrorCode::badInput,
      std::string(shape) +
        "; a surface in space needs at least four points that are not in one plane");
  };
  if (points.size() < 2)
  {
    refuse(points.empty() ? "there is no point" : "all points are equal");
  }
  const auto firstAfter = [&](Index start, auto&& fits, const char* otherwise)
  {
    while (start < points.size() && !fits(points[start]))
    {
      ++start;
    }
    if (start == points.size())
    {
      refuse(otherwise);
    }
    return start;
  };
  const Vec3& a = points[0];
  const Vec3& b = points[1];
  const Index third = firstAfter(
    2, [&](const Vec3& c) { return !collinear(a, b, c); }, "all points lie on one line");
  const Index fourth = firstAfter(
    third + 1, [&](const Vec3& d) { return orientation(a, b, points[third], d) != 0; },
    "all points lie in one plane");
  return { 0, 1, third, fourth };
}

/// Biased randomized insertion order: rounds of growing size, each along the Hilbert curve. The
/// coin tosses are a hash, so that the order depends on the points alone.
std::vector<std::vector<Index>> insertionRounds(
  std::size_t count, const std::array<Index, 4>& inserted)
{
  constexpr int kRounds = 9;
  constexpr int kBitsPerRound = 3; // each round eight times the one before
  std::vector<std::vector<Index>> rounds(kRounds);
  for (Index vertex = 0; vertex < count; ++vertex)
  {
    if (std::find(inserted.begin(), inserted.end(), vertex) != inserted.end())
    {
      continue;
    }
    std::uint64_t hash = (vertex + 1) * 0x9E3779B97F4A7C15ULL;
    hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9ULL;
    hash ^= hash >> 27;
    int round = kRounds - 1;
    for (; round > 0 && (hash & ((1U << kBitsPerRound) - 1)) == 0; --round)
    {
      hash >>= kBitsPerRound;
    }
    rounds[round].push_back(vertex);
  }
  return rounds;
}

/// Workers at rest.
class WorkerPool
{
public:
  explicit WorkerPool(DelaunayCells& cells)
    : Cells(cells)
  {
  }

  std::unique_ptr<DelaunayWorker> take()
  {
    const std::scoped_lock lock(this->Mutex);
    if (this->Resting.empty())
    {
      return std::make_unique<DelaunayWorker>(this->Cells, this->Count++);
    }
    std::unique_ptr<DelaunayWorker> worker = std::move(this->Resting.back());
    this->Resting.pop_back();
    return worker;
  }

  /// Takes a worker back, with the points that it could not insert.
  void giveBack(std::unique_ptr<DelaunayWorker> worker, const std::vector<Index>& postponed)
  {
    const std::scoped_lock lock(this->Mutex);
    this->Resting.push_back(std::move(worker));
    this->Postponed.insert(this->Postponed.end(), postponed.begin(), postponed.end());
  }

  /// All points that could not be inserted since the last call, sorted.
  std::vector<Index> takePostponed()
  {
    std::sort(this->Postponed.begin(), this->Postponed.end());
    return std::exchange(this->Postponed, {});
  }

private:
  DelaunayCells& Cells;
  std::mutex Mutex;
  std::vector<std::unique_ptr<DelaunayWorker>> Resting;
  std::vector<Index> Postponed;
  unsigned Count = 0;
};

/// Inserts some points that follow the curve on all threads.
void insertBatch(
  std::span<const Index> batch, bool together, WorkerPool& workers, Execution& execution)
{
  constexpr std::size_t kGrain = 512;
  execution.parallelFor(batch.size(), together ? kGrain : batch.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Index> postponed;
      std::unique_ptr<DelaunayWorker> worker = workers.take();
      for (const Index vertex : batch.subspan(begin, end - begin))
      {
        if (!together)
        {
          worker->insertAlone(vertex);
        }
        else if (!worker->insertAmongOthers(vertex))
        {
          postponed.push_back(vertex);
        }
      }
      workers.giveBack(std::move(worker), postponed);
    });
}

} // namespace

std::unique_ptr<DelaunayCells> insertPoints(std::span<const Vec3> points, Execution& execution)
{
  const std::array<Index, 4> first = firstTetrahedron(points);
  auto cells = std::make_unique<DelaunayCells>(points, first);
  WorkerPool workers(*cells);
  std::size_t done = 4;
  for (const std::vector<Index>& round : insertionRounds(points.size(), first))
  {
    for (std::size_t begin = 0; begin < round.size();)
    {
      constexpr std::size_t kEnoughForMany = 4096; // so that workers rarely meet
      const bool together = execution.threads() > 1 && done >= kEnoughForMany;
      const std::size_t largest = together ? std::min<std::size_t>(done, 1 << 16) : 1 << 10;
      const std::size_t size = std::min(largest, round.size() - begin);
      const std::span batch = std::span(round).subspan(begin, size);
      if (together)
      {
        cells->makeRoom(8 * size);
      }
      insertBatch(batch, together, workers, execution);
      insertBatch(workers.takePostponed(), false, workers, execution);
      begin += size;
      done += size;
      execution.step("triangulate", done, points.size() + points.size() / 4);
    }
  }
  return cells;
}

} // namespace scan
