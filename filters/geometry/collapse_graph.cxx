// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/collapse_graph.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/dominators.h"
#include "filters/geometry/holders.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 1 << 14;
constexpr std::size_t kSteps = 4;

/// Items by group. @param groupOf (item) -> group, or kNone to leave the item out
template <class GroupOf>
Incidence groupBy(std::size_t count, Index groups, GroupOf&& groupOf)
{
  return Incidence(groups, count,
    [&](std::size_t item, auto&& visit)
    {
      const Index group = groupOf(static_cast<Index>(item));
      if (group != kNone)
      {
        visit(group);
      }
    });
}

} // namespace

class CollapseGraph::Builder
{
public:
  Builder(CollapseGraph& graph, Execution& execution)
    : Graph(graph)
    , Flow(graph.flow())
    , Complex(Flow.delaunay())
    , BasinOf(graph.basins().ofTet)
    , BasinCount(graph.basins().count())
    , Run(execution)
    , Found(Flow, execution)
  {
  }

  void build()
  {
    this->Run.step("holders", 1, kSteps);
    this->numberTets();
    this->numberTriangles();
    this->listMembers();
    this->Run.step("holders", 2, kSteps);
    this->connectTets();
    this->connectTriangles(this->Graph.Obtuse);
    this->connectTriangles(this->Graph.Critical);
    this->measureCritical();
    this->findDoors();
    this->Run.step("holders", 3, kSteps);
    this->connectEdges();
    this->Run.step("holders", kSteps, kSteps);
  }

private:
  void numberTets()
  {
    Nodes& nodes = this->Graph.Tets;
    const Incidence own = groupBy(this->BasinOf.size(), this->BasinCount,
      [&](Index tet)
      {
        const Upper upper{ true, tet };
        return this->Found.of(upper) == this->Found.codeOf(upper) ? this->BasinOf[tet] : kNone;
      });
    nodes.name = own.items();
    nodes.ofBasin = own.begins();
    this->sortByRadius(nodes);
    this->NumberOfTet.resize(this->BasinOf.size());
    for (Index i = 0; i < nodes.name.size(); ++i)
    {
      this->NumberOfTet[nodes.name[i]] = i;
    }
  }

  /// From large to small within a basin: as good as always what holds others comes first.
  void sortByRadius(Nodes& nodes)
  {
    std::vector<std::pair<double, Index>> keys(nodes.name.size());
    this->Run.parallelFor(this->BasinCount, 16,
      [&](std::size_t begin, std::size_t end)
      {
        const auto first = nodes.ofBasin[begin];
        const auto last = nodes.ofBasin[end];
        for (Index i = first; i < last; ++i)
        {
          keys[i] = { circumradiusSquared(this->Complex, nodes.name[i]), nodes.name[i] };
        }
        for (std::size_t basin = begin; basin < end; ++basin)
        {
          std::sort(keys.begin() + nodes.ofBasin[basin], keys.begin() + nodes.ofBasin[basin + 1],
            std::greater<>());
        }
        for (Index i = first; i < last; ++i)
        {
          nodes.name[i] = keys[i].second;
        }
      });
  }

  void numberTriangles()
  {
    const std::vector<Facet> triangles = collect<Facet>(4 * this->Complex.tetCount(), this->Run,
      [&](Facet facet, auto& found)
      {
        if (this->Complex.canonical(facet) == facet && this->Flow.isFree(facet) &&
          this->Found.of({ false, facet }) != kNone)
        {
          found.push_back(facet);
        }
      });
    this->Named.assign(this->BasinOf.size(), 0);
    this->RankOf.resize(this->BasinOf.size());
    for (Index rank = 0; rank < triangles.size(); ++rank)
    {
      const Facet facet = triangles[rank];
      if (this->Named[facet / 4] == 0)
      {
        this->RankOf[facet / 4] = rank;
      }
      this->Named[facet / 4] |= static_cast<std::uint8_t>(1U << (facet % 4));
    }
    LargeArray<Index> home(triangles.size());
    this->Run.parallelFor(home.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t rank = begin; rank < end; ++rank)
        {
          home[rank] = this->homeOf(triangles[rank]);
        }
      });
    this->NumberOfRank.resize(triangles.size());
    Index number = static_cast<Index>(this->Graph.Tets.name.size());
    for (const bool isObtuse : { true, false })
    {
      Nodes& nodes = isObtuse ? this->Graph.Obtuse : this->Graph.Critical;
      const Incidence grouped = groupBy(triangles.size(), this->BasinCount,
        [&](Index rank)
        { return this->Flow.isObtuse(triangles[rank]) == isObtuse ? home[rank] : kNone; });
      nodes.first = number;
      nodes.ofBasin = grouped.begins();
      nodes.name.reserve(grouped.items().size());
      for (const Index rank : grouped.items())
      {
        nodes.name.push_back(triangles[rank]);
        this->NumberOfRank[rank] = number++;
      }
    }
    this->Nothing = number;
  }

  /// The basin a triangle is grouped with: on a side that may be held, if there is one.
  Index homeOf(Facet triangle) const
  {
    const Index own = this->BasinOf[triangle / 4];
    const Index beyond = this->Complex.neighbour(triangle / 4, static_cast<int>(triangle % 4));
    return this->Graph.basins().leavesHull(own) && beyond != kNone ? this->BasinOf[beyond] : own;
  }

  /// The number of the node that an upper simplex hangs on, or is.
  Index numberOf(Upper upper) const
  {
    const Dominators::Code code = this->Found.of(upper);
    if (code == kNone)
    {
      return this->Nothing;
    }
    const Upper on = this->Found.at(code);
    if (on.isTet)
    {
      return this->NumberOfTet[on.name];
    }
    const unsigned before = this->Named[on.name / 4] & ((1U << (on.name % 4)) - 1U);
    return this
      ->NumberOfRank[this->RankOf[on.name / 4] + static_cast<Index>(std::popcount(before))];
  }

  void listMembers()
  {
    LargeArray<Index> nodeOf(this->BasinOf.size());
    this->Run.parallelFor(nodeOf.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (auto tet = static_cast<Index>(begin); tet < end; ++tet)
        {
          const Index number = this->numberOf({ true, tet });
          nodeOf[tet] = number == this->Nothing ? kNone : number;
        }
      });
    this->Graph.Members = groupBy(nodeOf.size(), static_cast<Index>(this->Graph.Tets.name.size()),
      [&](Index tet) { return nodeOf[tet]; });
  }

  /// Fills in the holders of nodes: addHolders(i, found, begin) appends those of node i.
  template <class AddHolders>
  void connect(Nodes& nodes, AddHolders&& addHolders)
  {
    nodes.firstHolder.resize(nodes.name.size() + 1);
    nodes.firstHolder.back() = 0;
    nodes.holders = collect<Index>(static_cast<Index>(nodes.name.size()), this->Run,
      [&](Index i, auto& found)
      {
        const std::size_t begin = found.size();
        addHolders(i, found, begin);
        nodes.firstHolder[i] = static_cast<Index>(found.size() - begin);
      });
    std::exclusive_scan(
      nodes.firstHolder.begin(), nodes.firstHolder.end(), nodes.firstHolder.begin(), Index{ 0 });
  }

  /// Appends a holder unless it is nothing, or there from `begin` on. Always true.
  bool addOnce(Upper holder, std::vector<Index>& found, std::size_t begin) const
  {
    const Index number = this->numberOf(holder);
    const auto first = found.begin() + static_cast<std::ptrdiff_t>(begin);
    if (number != this->Nothing && std::find(first, found.end(), number) == found.end())
    {
      found.push_back(number);
    }
    return true;
  }

  /// Critical triangles first: they settle most.
  static void sortHolders(std::vector<Index>& found, std::size_t begin)
  {
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(begin), found.end(), std::greater<>());
  }

  void connectTets()
  {
    this->connect(this->Graph.Tets,
      [&](Index i, auto& found, std::size_t begin)
      {
        const Upper upper{ true, this->Graph.Tets.name[i] };
        const auto add = [&](Upper holder) { return this->addOnce(holder, found, begin); };
        forEachNearHolder(this->Flow, upper, add);
        forEachHolderAround(this->Flow, upper, add);
        sortHolders(found, begin);
      });
  }

  void connectTriangles(Nodes& nodes)
  {
    this->connect(nodes,
      [&](Index i, auto& found, std::size_t begin)
      {
        const Facet facet = nodes.name[i];
        const Index beyond = this->Complex.neighbour(facet / 4, static_cast<int>(facet % 4));
        found.push_back(this->numberOf({ true, facet / 4 }));
        found.push_back(beyond == kNone ? this->Nothing : this->numberOf({ true, beyond }));
        forEachHolderAround(this->Flow, { false, facet },
          [&](Upper holder) { return this->addOnce(holder, found, begin); });
        sortHolders(found, begin + 2);
      });
  }

  void measureCritical()
  {
    const std::vector<Index>& name = this->Graph.Critical.name;
    this->Graph.Radius.resize(name.size());
    this->Run.parallelFor(name.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Graph.Radius[i] = circumradius(this->Complex, name[i]);
        }
      });
  }

  void findDoors()
  {
    const std::span<const Door> doors = this->Graph.TheBlocks.doors();
    this->Graph.IndexOfDoor.resize(doors.size());
    for (std::size_t d = 0; d < doors.size(); ++d)
    {
      this->Graph.IndexOfDoor[d] =
        this->numberOf({ false, doors[d].triangle }) - this->Graph.Critical.first;
    }
  }

  void connectEdges()
  {
    // of each edge: its home, the number of its holders, and these
    const std::vector<Index> records =
      collect<Index>(static_cast<Index>(this->BasinOf.size()), this->Run,
        [&](Index tet, auto& found)
        {
          forEachCriticalEdge(
            this->Flow, tet, [](Facet) { return true; },
            [&](const CriticalEdge& edge) { this->describeEdge(edge, found); });
        });
    Nodes& edges = this->Graph.Edges;
    edges.ofBasin.assign(this->BasinCount + 1, 0);
    std::vector<Index> placeOfHolders(this->BasinCount + 1, 0);
    for (std::size_t at = 0; at < records.size(); at += 2 + records[at + 1])
    {
      ++edges.ofBasin[records[at] + 1];
      placeOfHolders[records[at] + 1] += records[at + 1];
    }
    std::partial_sum(edges.ofBasin.begin(), edges.ofBasin.end(), edges.ofBasin.begin());
    std::partial_sum(placeOfHolders.begin(), placeOfHolders.end(), placeOfHolders.begin());
    edges.firstHolder.resize(edges.ofBasin.back() + 1);
    edges.firstHolder.back() = placeOfHolders.back();
    edges.holders.resize(placeOfHolders.back());
    std::vector<Index> place = edges.ofBasin;
    for (std::size_t at = 0; at < records.size(); at += 2 + records[at + 1])
    {
      const Index home = records[at];
      edges.firstHolder[place[home]++] = placeOfHolders[home];
      std::copy_n(records.begin() + static_cast<std::ptrdiff_t>(at + 2), records[at + 1],
        edges.holders.begin() + placeOfHolders[home]);
      placeOfHolders[home] += records[at + 1];
    }
  }

  void describeEdge(const CriticalEdge& edge, std::vector<Index>& found) const
  {
    const std::size_t begin = found.size();
    found.insert(found.end(), { kNone, 0 });
    const auto add = [&](Upper upper)
    {
      this->addOnce(upper, found, begin + 2);
      const Index home = found[begin];
      if ((home == kNone || this->Graph.basins().leavesHull(home)) &&
        this->Found.of(upper) != kNone)
      {
        found[begin] = upper.isTet ? this->BasinOf[upper.name] : this->homeOf(upper.name);
      }
      return true;
    };
    const Facet start = this->Complex.canonical(edge.triangle);
    if (this->Flow.isFree(start))
    {
      add({ false, start });
    }
    forEachUpperAround(this->Flow, edge.triangle, edge.apex, { true, kNone }, add);
    found[begin + 1] = static_cast<Index>(found.size() - begin - 2);
    if (found[begin] == kNone)
    {
      found.resize(begin);
    }
    else
    {
      sortHolders(found, begin + 2);
    }
  }

  CollapseGraph& Graph;
  const FlowComplex& Flow;
  const DelaunayComplex& Complex;
  const std::vector<Index>& BasinOf;
  Index BasinCount;
  Execution& Run;
  Dominators Found;
  LargeArray<Index> NumberOfTet;
  std::vector<std::uint8_t> Named; ///< per tetrahedron, bit k: its facet k names a node
  LargeArray<Index> RankOf;        ///< of the first of these among all triangles that are nodes
  LargeArray<Index> NumberOfRank;
  Index Nothing = 0;
};

CollapseGraph::CollapseGraph(const Blocks& blocks, Execution& execution)
  : TheBlocks(blocks)
{
  execution.step("holders", 0, kSteps);
  Builder(*this, execution).build();
}

} // namespace scan
