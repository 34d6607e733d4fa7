// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bulk_edit.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cstdio>
#include <mutex>
#include <span>

namespace scan
{
namespace
{

using Level = CollapseGraph::Level;

class BulkEdit
{
public:
  BulkEdit(WrapComplex& kept, const CollapseGraph& graph, const CriticalChoice& choice,
    Execution& execution)
    : Kept(kept)
    , Flow(graph.flow())
    , Graph(graph)
    , Choice(choice)
    , Run(execution)
    , State(graph.nodeCount() + 1, 0)
  {
  }

  BulkReport make()
  {
    this->recallSinks();
    for (const Level& level : this->Graph.levels().subspan(1))
    {
      this->decide(level);
    }
    this->countEdges();
    this->write();
    return this->Report;
  }

private:
  // of a node
  static constexpr unsigned kStays = 1;
  static constexpr unsigned kWas = 2;

  static int changeOf(unsigned state)
  {
    return static_cast<int>(state & kStays) - static_cast<int>((state & kWas) / kWas);
  }

  /// Calls act(from, to, part) for [0, count) in pieces, and adds up the parts of the report.
  template <class Act>
  void forEach(std::size_t count, std::size_t grain, Act&& act)
  {
    std::mutex guard;
    this->Run.parallelFor(count, grain,
      [&](std::size_t from, std::size_t to)
      {
        BulkReport part;
        act(from, to, part);
        const std::scoped_lock lock(guard);
        this->Report += part;
      });
  }

  void recallSinks()
  {
    const Basins& basins = this->Graph.basins();
    constexpr std::size_t kGrain = 1 << 12;
    this->forEach(basins.count(), kGrain,
      [&](std::size_t from, std::size_t to, BulkReport&)
      {
        for (auto basin = static_cast<Index>(from); basin < to; ++basin)
        {
          if (!basins.leavesHull(basin))
          {
            const Index sink = basins.sink[basin];
            this->State[this->Graph.nodeOfTet(sink)] =
              static_cast<std::uint8_t>((this->Choice.holdsBasin[basin] != 0 ? kStays : 0) |
                (this->Kept.keepsTet(sink) ? kWas : 0));
          }
        }
      });
  }

  void decide(const Level& level)
  {
    constexpr std::size_t kGrain = 1 << 13;
    this->forEach(level.end - level.begin, kGrain,
      [&](std::size_t from, std::size_t to, BulkReport& part)
      {
        const auto begin = static_cast<Index>(level.begin + from);
        const auto end = static_cast<Index>(level.begin + to);
        const Index critical = std::clamp(level.critical, begin, end);
        for (Index place = begin; place < critical; ++place)
        {
          this->State[this->Graph.nodeAt(place)] = this->ofHolders(this->Graph.holdersAt(place));
        }
        for (Index place = critical; place < end; ++place)
        {
          const Index i = level.firstCritical + place - level.critical;
          unsigned state = this->ofHolders(this->Graph.holdersAt(place));
          state |= this->Kept.isSheetNamed(this->Graph.criticalTriangles()[i]) ? kWas : 0;
          state |= this->Choice.keepsTriangle(i, (state & kWas) != 0) ? kStays : 0;
          this->State[this->Graph.nodeAt(place)] = static_cast<std::uint8_t>(state);
          part.criticalTriangles += changeOf(state) < 0 ? 1 : 0;
          part.change.edges -= changeOf(state); // no edge goes with these alone
        }
      });
  }

  std::uint8_t ofHolders(std::span<const Index> holders) const
  {
    unsigned any = 0;
    for (const Index holder : holders)
    {
      any |= this->State[holder];
    }
    return static_cast<std::uint8_t>(any & (kStays | kWas));
  }

  void countEdges()
  {
    const CollapseGraph::Holders& edges = this->Graph.edges();
    constexpr std::size_t kGrain = 1 << 13;
    this->forEach(edges.count(), kGrain,
      [&](std::size_t from, std::size_t to, BulkReport& part)
      {
        for (auto edge = static_cast<Index>(from); edge < to; ++edge)
        {
          part.change.edges += changeOf(this->ofHolders(edges.of(edge)));
        }
      });
  }

  void write()
  {
    constexpr std::size_t kGrain = 1 << 8;
    this->forEach(this->Graph.triangleNumbers().wordCount(), kGrain,
      [&](std::size_t from, std::size_t to, BulkReport& part)
      {
        for (auto word = static_cast<Index>(from); word < to; ++word)
        {
          this->writeTets(word, this->sheetsIn(word, part.change), part.change);
        }
      });
  }

  /// The triangles of a word that stay without that beyond, and counts all that come or go.
  std::uint64_t sheetsIn(Index word, WrapChange& change) const
  {
    const FacetNumbers& numbers = this->Graph.triangleNumbers();
    Index number = numbers.of(word * FacetNumbers::kBits);
    std::uint64_t sheets = 0;
    int count = 0;
    for (std::uint64_t rest = numbers.word(word); rest != 0; rest &= rest - 1)
    {
      const CollapseGraph::Triangle triangle = this->Graph.triangle(number++);
      const unsigned state = this->State[triangle.node];
      const std::uint64_t isSheet = state & ~this->State[triangle.beyond] & kStays;
      sheets |= isSheet << std::countr_zero(rest);
      count += changeOf(state);
    }
    change.triangles += count;
    change.edges += count;
    return sheets;
  }

  void writeTets(Index word, std::uint64_t sheets, WrapChange& change)
  {
    constexpr Index kCount = FacetNumbers::kBits / 4;
    const Index begin = kCount * word;
    const Index end = std::min(begin + kCount, this->Flow.delaunay().tetCount());
    std::array<unsigned, kCount> stays;
    int tets = 0;
    int triangles = 0;
    int edges = 0;
    for (Index tet = begin; tet < end; ++tet)
    {
      stays[tet - begin] = this->State[this->Graph.nodeOfTet(tet)] & kStays;
      const int ofTet = static_cast<int>(stays[tet - begin]) - (this->Kept.keepsTet(tet) ? 1 : 0);
      const int ofSecond = ofTet * static_cast<int>(this->Flow.hasTwoAttached(tet));
      tets += ofTet;
      triangles += ofTet * static_cast<int>(!this->Flow.isSink(tet)) + ofSecond;
      edges += ofSecond;
    }
    for (Index tet = begin; tet < end; ++tet)
    {
      const unsigned isKept = stays[tet - begin];
      this->Kept.set(tet, isKept != 0, (isKept - 1U) & sheets >> (4 * (tet - begin)) & 15U);
    }
    change += { tets, triangles, edges };
  }

  WrapComplex& Kept;
  const FlowComplex& Flow;
  const CollapseGraph& Graph;
  const CriticalChoice& Choice;
  Execution& Run;
  std::vector<std::uint8_t> State;
  BulkReport Report;
};

} // namespace

CriticalChoice criticalChoiceOf(const WrapComplex& kept, const Basins& basins)
{
  CriticalChoice choice{ std::vector<std::uint8_t>(basins.count(), 0),
    [](Index, bool was) { return was; } };
  for (Index basin = 0; basin < basins.count(); ++basin)
  {
    choice.holdsBasin[basin] =
      !basins.leavesHull(basin) && kept.keepsTet(basins.sink[basin]) ? 1 : 0;
  }
  return choice;
}

BulkReport editInBulk(
  WrapComplex& kept, const CollapseGraph& graph, const CriticalChoice& choice, Execution& execution)
{
  return BulkEdit(kept, graph, choice, execution).make();
}

} // namespace scan
