// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bulk_edit.h"

#include "filters/geometry/large_array.h"
#include "filters/geometry/relaxed.h"

#include <algorithm>
#include <mutex>
#include <span>

namespace scan
{
namespace
{

using Nodes = CollapseGraph::Nodes;

struct Range
{
  Index begin;
  Index end;
};

/// Some basins, as runs of successive ones.
class BasinRuns
{
public:
  void add(Index basin) // in increasing order
  {
    if (this->Runs.empty() || this->Runs.back().end != basin)
    {
      this->Runs.push_back({ basin, basin });
    }
    ++this->Runs.back().end;
  }

  bool isEmpty() const { return this->Runs.empty(); }

  /// What they hold, of items grouped by basin, in pieces of some size.
  std::vector<Range> pieces(std::span<const Index> ofBasin) const
  {
    constexpr Index kPiece = 1 << 13;
    std::vector<Range> pieces;
    for (const Range run : this->Runs)
    {
      const Index last = ofBasin[run.end];
      for (Index begin = ofBasin[run.begin]; begin < last; begin += kPiece)
      {
        pieces.push_back({ begin, std::min(begin + kPiece, last) });
      }
    }
    return pieces;
  }

private:
  std::vector<Range> Runs;
};

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
    , State(graph.nothing() + 1)
  {
  }

  BulkReport make()
  {
    this->sortBasins();
    this->recall();
    this->decideAll(this->Graph.tets());
    this->decideAll(this->Graph.obtuse());
    this->editTriangles(this->Graph.obtuse());
    this->editTriangles(this->Graph.critical());
    this->countEdges();
    this->editTets();
    return this->Report;
  }

private:
  // of a node; whoever asks gets the same, so it does no harm when two threads work it out
  static constexpr std::uint8_t kStays = 1;
  static constexpr std::uint8_t kKnown = 2;
  static constexpr std::uint8_t kWas = 4;

  static int changeOf(std::uint8_t state)
  {
    return ((state & kStays) != 0 ? 1 : 0) - ((state & kWas) != 0 ? 1 : 0);
  }

  std::uint8_t state(Index node) const { return loadRelaxed(this->State[node]); }
  void setState(Index node, bool was, bool stays)
  {
    storeRelaxed(this->State[node],
      static_cast<std::uint8_t>((was ? kWas : 0) | (stays ? kStays : 0) | kKnown));
  }

  /// Calls act(i, part) for the items of the flagged basins, and adds up the parts of the report.
  template <class Act>
  void forEach(std::span<const Index> ofBasin, const BasinRuns& basins, Act&& act)
  {
    const std::vector<Range> pieces = basins.pieces(ofBasin);
    std::mutex guard;
    this->Run.parallelFor(pieces.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        BulkReport part;
        for (std::size_t piece = begin; piece < end; ++piece)
        {
          const Range range = pieces[piece];
          for (Index i = range.begin; i < range.end; ++i)
          {
            act(i, part);
          }
        }
        const std::scoped_lock lock(guard);
        this->Report.change += part.change;
        this->Report.criticalTriangles += part.criticalTriangles;
      });
  }

  void sortBasins()
  {
    const Basins& basins = this->Graph.basins();
    for (Index basin = 0; basin < basins.count(); ++basin)
    {
      const bool is = this->Choice.holdsBasin[basin] != 0;
      const bool was = !basins.leavesHull(basin) && this->Kept.keepsTet(basins.sink[basin]);
      if (!is)
      {
        this->Open.add(basin);
        (was ? this->Opening : this->StillOpen).add(basin);
      }
      else if (!was)
      {
        this->Closing.add(basin);
      }
      if (!is || !was)
      {
        this->Concerned.add(basin);
      }
    }
    this->Grows = !this->Closing.isEmpty();
    this->Shrinks = !this->Opening.isEmpty();
  }

  /// All that is clear without asking the holders. While its sink is kept, all of a basin is.
  void recall()
  {
    std::ranges::fill(this->State, kStays | kKnown | kWas);
    this->State[this->Graph.nothing()] = kKnown;
    const Nodes& tets = this->Graph.tets();
    const auto recallTets = [&](const BasinRuns& basins, std::uint8_t state)
    {
      this->forEach(tets.ofBasin, basins,
        [&, state](Index i, BulkReport&)
        {
          const bool was = this->Kept.keepsTet(tets.name[i]);
          this->State[i] = static_cast<std::uint8_t>(state | (was ? kWas : 0));
        });
    };
    this->fill(tets, this->Opening, kWas);
    recallTets(this->StillOpen, 0);
    recallTets(this->Closing, kStays | kKnown);

    const Nodes& obtuse = this->Graph.obtuse();
    this->fill(obtuse, this->Opening, kWas);
    this->fill(obtuse, this->StillOpen, 0); // found out when asked
    const Nodes& critical = this->Graph.critical();
    for (const Nodes* nodes : { &obtuse, &critical })
    {
      this->forEach(nodes->ofBasin, this->Closing,
        [&](Index i, BulkReport&)
        { this->setState(nodes->first + i, this->wasKept(*nodes, i), true); });
    }
    this->forEach(critical.ofBasin, this->Opening,
      [&](Index i, BulkReport&) { this->recallCritical(i, true); });
    this->forEach(critical.ofBasin, this->StillOpen,
      [&](Index i, BulkReport&) { this->recallCritical(i, this->wasKept(critical, i)); });
  }

  /// Of a triangle, once that is clear of the tetrahedra.
  bool wasKept(const Nodes& nodes, Index i) const
  {
    const auto sides = nodes.holdersOf(i).first(2);
    return ((this->state(sides[0]) | this->state(sides[1])) & kWas) != 0 ||
      this->Kept.isSheetNamed(nodes.name[i]);
  }

  void fill(const Nodes& nodes, const BasinRuns& basins, std::uint8_t state)
  {
    for (const Range piece : basins.pieces(nodes.ofBasin))
    {
      const auto first = this->State.begin() + nodes.first;
      std::fill(first + piece.begin, first + piece.end, state);
    }
  }

  void recallCritical(Index i, bool was)
  {
    const Index node = this->Graph.critical().first + i;
    const bool stays = this->Choice.keepsTriangle(i, was);
    if (stays)
    {
      this->setState(node, was, true);
    }
    else
    {
      this->State[node] = was ? kWas : 0; // what is beside it may keep it
    }
    if (stays != was)
    {
      storeRelaxed(stays ? this->Grows : this->Shrinks, true);
    }
  }

  void decideAll(const Nodes& nodes)
  {
    this->forEach(nodes.ofBasin, this->Open, [&](Index i, BulkReport&) { this->decide(nodes, i); });
  }

  /// Depth first on an explicit stack: the relation is acyclic.
  void decide(const Nodes& nodes, Index i)
  {
    Index unknown = this->evaluate(nodes, i);
    if (unknown == kNone)
    {
      return;
    }
    thread_local std::vector<Index> pending;
    pending.assign({ nodes.first + i, unknown });
    while (!pending.empty())
    {
      const Nodes& kind = this->kindOf(pending.back());
      unknown = this->evaluate(kind, pending.back() - kind.first);
      if (unknown == kNone)
      {
        pending.pop_back();
      }
      else
      {
        pending.push_back(unknown);
      }
    }
  }

  const Nodes& kindOf(Index node) const
  {
    return node < this->Graph.obtuse().first ? this->Graph.tets()
      : node < this->Graph.critical().first  ? this->Graph.obtuse()
                                             : this->Graph.critical();
  }

  /// Remembers whether a node stays. If that hangs on a holder that is not known yet, returns it.
  Index evaluate(const Nodes& nodes, Index i)
  {
    const std::uint8_t state = this->state(nodes.first + i);
    if ((state & kKnown) != 0)
    {
      return kNone;
    }
    const bool isTet = &nodes == &this->Graph.tets(); // of these it is known
    const bool was = (state & kWas) != 0 || (!isTet && this->wasKept(nodes, i));
    bool stays = was;
    if (was ? this->Shrinks : this->Grows)
    {
      stays = false;
      Index unknown = kNone;
      for (const Index holder : nodes.holdersOf(i))
      {
        const std::uint8_t answer = this->state(holder);
        if ((answer & kStays) != 0)
        {
          stays = true;
          break;
        }
        unknown = (answer & kKnown) == 0 ? holder : unknown;
      }
      if (!stays && unknown != kNone)
      {
        return unknown;
      }
    }
    this->setState(nodes.first + i, was, stays);
    return kNone;
  }

  void countEdges()
  {
    constexpr std::uint8_t kBoth = kStays | kWas;
    const Nodes& edges = this->Graph.edges();
    this->forEach(edges.ofBasin, this->Concerned,
      [&](Index edge, BulkReport& part)
      {
        std::uint8_t any = 0;
        for (const Index holder : edges.holdersOf(edge))
        {
          any |= this->State[holder];
          if ((any & kBoth) == kBoth)
          {
            return;
          }
        }
        part.change.edges += changeOf(any);
      });
  }

  void editTriangles(const Nodes& nodes)
  {
    const bool isCritical = &nodes == &this->Graph.critical();
    this->forEach(nodes.ofBasin, this->Concerned,
      [&](Index i, BulkReport& part)
      {
        this->decide(nodes, i); // critical ones that no other node asked for
        const std::uint8_t state = this->State[nodes.first + i];
        const bool stays = (state & kStays) != 0;
        const int change = changeOf(state);
        part.change.triangles += change;
        part.change.edges += isCritical ? 0 : change;
        part.criticalTriangles += isCritical && change < 0 ? 1 : 0;
        const auto sides = nodes.holdersOf(i).first(2);
        const bool isSheet =
          stays && ((this->State[sides[0]] | this->State[sides[1]]) & kStays) == 0;
        if (isSheet != this->Kept.isSheetNamed(nodes.name[i]))
        {
          this->Kept.setSheetNamed(nodes.name[i], isSheet);
        }
      });
  }

  void editTets()
  {
    this->forEach(this->Graph.tets().ofBasin, this->Concerned,
      [&](Index i, BulkReport& part)
      {
        const std::uint8_t state = this->State[i];
        const std::int64_t change = changeOf(state);
        if (change == 0)
        {
          return;
        }
        for (const Index tet : this->Graph.membersOf(i))
        {
          const int hasOne = this->Flow.isSink(tet) ? 0 : 1;
          const int hasTwo = this->Flow.hasTwoAttached(tet) ? 1 : 0;
          part.change.tetrahedra += change;
          part.change.triangles += change * (hasOne + hasTwo);
          part.change.edges += change * hasTwo;
          if (change > 0)
          {
            this->Kept.keepTet(tet);
          }
          else
          {
            this->Kept.dropTet(tet);
          }
        }
      });
  }

  WrapComplex& Kept;
  const FlowComplex& Flow;
  const CollapseGraph& Graph;
  const CriticalChoice& Choice;
  Execution& Run;
  BasinRuns Open;       ///< its sink is not to be kept
  BasinRuns Opening;    ///< and was
  BasinRuns StillOpen;  ///< nor was it
  BasinRuns Closing;    ///< its sink was not kept and is to be
  BasinRuns Concerned;  ///< its sink is not kept before or after
  bool Grows = false;   ///< something comes that was not kept
  bool Shrinks = false; ///< something goes
  LargeArray<std::uint8_t> State;
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
