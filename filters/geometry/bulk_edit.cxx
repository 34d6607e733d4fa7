// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bulk_edit.h"

#include "filters/geometry/relaxed.h"

#include <algorithm>
#include <array>
#include <bit>
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
    this->write(this->changedPieces());
    return this->Report;
  }

private:
  // of a node
  static constexpr unsigned kStays = 1;
  static constexpr unsigned kWas = 2;

  static constexpr Index kTetsAWord = FacetNumbers::kBits / 4;

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
            this->set(this->Graph.nodeOfTet(sink),
              (this->Choice.holdsBasin[basin] != 0 ? kStays : 0) |
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
          this->set(this->Graph.nodeAt(place), this->ofHolders(this->Graph.holdersAt(place)));
        }
        for (Index place = critical; place < end; ++place)
        {
          const Index i = level.firstCritical + place - level.critical;
          unsigned state = this->ofHolders(this->Graph.holdersAt(place));
          state |= this->Kept.isSheetNamed(this->Graph.criticalTriangles()[i]) ? kWas : 0;
          state |= this->Choice.keepsTriangle(i, (state & kWas) != 0) ? kStays : 0;
          this->set(this->Graph.nodeAt(place), state);
          part.criticalTriangles += changeOf(state) < 0 ? 1 : 0;
          part.change.edges -= changeOf(state); // no edge goes with these alone
        }
      });
  }

  unsigned ofHolders(std::span<const Index> holders) const
  {
    unsigned any = 0;
    for (const Index holder : holders)
    {
      any |= this->State[holder];
    }
    return any;
  }

  void set(Index node, unsigned state) { this->State[node] = static_cast<std::uint8_t>(state); }

  /// The pieces in which something changes.
  std::vector<Index> changedPieces()
  {
    constexpr std::ptrdiff_t kMany = 8; // part of the nodes that are in nearly every piece
    const bool areMany = kMany *
        std::ranges::count_if(this->State, [](unsigned state) { return changeOf(state) != 0; }) >
      std::ssize(this->State);
    std::vector<std::uint8_t> hasChange(this->Graph.pieceCount(), areMany ? 1 : 0);
    constexpr std::size_t kGrain = 1 << 14;
    this->Run.parallelFor(areMany ? 0 : this->Graph.nodeCount(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (auto node = static_cast<Index>(begin); node < end; ++node)
        {
          if (changeOf(this->State[node]) != 0)
          {
            for (const Index piece : this->Graph.piecesOfNodes().of(node))
            {
              storeRelaxed(hasChange[piece], std::uint8_t{ 1 });
            }
          }
        }
      });
    std::vector<Index> changed;
    for (Index piece = 0; piece < hasChange.size(); ++piece)
    {
      if (hasChange[piece] != 0)
      {
        changed.push_back(piece);
      }
    }
    return changed;
  }

  void write(const std::vector<Index>& pieces)
  {
    this->forEach(pieces.size(), 1,
      [&](std::size_t from, std::size_t to, BulkReport& part)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          part.change += this->write(pieces[i]);
          part.change.edges += this->edgesOf(pieces[i]);
        }
      });
  }

  std::int64_t edgesOf(Index piece) const
  {
    const Index end = this->Graph.firstEdge(piece + 1);
    int change = 0;
    for (Index edge = this->Graph.firstEdge(piece); edge < end; ++edge)
    {
      change += changeOf(this->ofHolders(this->Graph.edges().of(edge)));
    }
    return change;
  }

  /// Without branches, which would be guesses.
  WrapChange write(Index piece)
  {
    const Index begin = CollapseGraph::kTetsAPiece * piece;
    const Index end =
      std::min(begin + CollapseGraph::kTetsAPiece, this->Flow.delaunay().tetCount());
    Index triangle = this->Graph.triangleNumbers().of(4 * begin);
    int tets = 0;
    int triangles = 0;
    int edges = 0;
    for (Index first = begin; first < end; first += kTetsAWord)
    {
      int count = 0;
      const std::uint64_t sheets = this->sheetsFrom(first, triangle, count);
      triangles += count;
      edges += count;
      std::array<unsigned, kTetsAWord> stays;
      const Index last = std::min(first + kTetsAWord, end);
      for (Index tet = first; tet < last; ++tet)
      {
        const unsigned isKept = this->State[this->Graph.nodeOfTet(tet)] & kStays;
        const int ofTet = static_cast<int>(isKept) - static_cast<int>(this->Kept.keepsTet(tet));
        const int ofSecond = ofTet * static_cast<int>(this->Flow.hasTwoAttached(tet));
        tets += ofTet;
        triangles += ofTet * static_cast<int>(!this->Flow.isSink(tet)) + ofSecond;
        edges += ofSecond;
        stays[tet - first] = isKept;
      }
      for (Index tet = first; tet < last; ++tet)
      {
        const unsigned isKept = stays[tet - first];
        this->Kept.set(tet, isKept != 0, (isKept - 1U) & sheets >> (4 * (tet - first)) & 15U);
      }
    }
    return { tets, triangles, edges };
  }

  /// The triangles of a word that stay without that beyond, and counts all that come or go.
  std::uint64_t sheetsFrom(Index tet, Index& triangle, int& change) const
  {
    std::uint64_t sheets = 0;
    for (std::uint64_t rest = this->Graph.triangleNumbers().word(tet / kTetsAWord); rest != 0;
         rest &= rest - 1)
    {
      const auto [node, beyond] = this->Graph.triangle(triangle++);
      const unsigned state = this->State[node];
      sheets |= std::uint64_t{ state & ~this->State[beyond] & kStays } << std::countr_zero(rest);
      change += changeOf(state);
    }
    return sheets;
  }

  WrapComplex& Kept;
  const FlowComplex& Flow;
  const CollapseGraph& Graph;
  const CriticalChoice& Choice;
  Execution& Run;
  std::vector<std::uint8_t> State; ///< of nodes
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
