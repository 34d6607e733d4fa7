// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/collapse_graph.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/holders.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 1 << 14;
constexpr std::size_t kSteps = 4;

} // namespace

class CollapseGraph::Builder
{
public:
  Builder(CollapseGraph& graph, const Representatives& found, Execution& execution)
    : Graph(graph)
    , Flow(graph.flow())
    , Complex(Flow.delaunay())
    , Run(execution)
    , Found(found)
  {
  }

  void build()
  {
    this->numberNodes();
    this->spreadNodes();
    this->connect();
    this->Run.step("holders", 2, kSteps);
    this->findLevels();
    this->listInLevels();
    this->listCritical();
    this->Run.step("holders", 3, kSteps);
    this->connectEdges();
    this->findPieces();
    this->Run.step("holders", kSteps, kSteps);
  }

private:
  /// Calls act(i) for i in [0, count) in parallel.
  template <class Act>
  void forEach(std::size_t count, Act&& act)
  {
    this->Run.parallelFor(count, kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          act(static_cast<Index>(i));
        }
      });
  }

  bool isNode(Upper upper) const { return this->Found.of(upper) == this->Found.codeOf(upper); }

  /// In the order of their names, triangles after the tetrahedra.
  void numberNodes()
  {
    const Index tetCount = this->Complex.tetCount();
    this->Tets = collect<Index>(tetCount, this->Run,
      [&](Index tet, auto& found)
      {
        if (this->isNode({ true, tet }))
        {
          found.push_back(tet);
        }
      });
    const FacetNumbers& numbers = this->Graph.TriangleNumbers;
    this->Triangles = collect<Facet>(4 * tetCount, this->Run,
      [&](Facet facet, auto& found)
      {
        if (numbers.contains(facet) && this->isNode({ false, facet }))
        {
          found.push_back(facet);
        }
      });
    this->Graph.NodeOfTet.resize(tetCount);
    this->Graph.Triangles.resize(numbers.count());
    this->forEach(
      this->Tets.size(), [&](Index node) { this->Graph.NodeOfTet[this->Tets[node]] = node; });
    this->forEach(this->Triangles.size(),
      [&](Index i)
      {
        this->Graph.Triangles[numbers.of(this->Triangles[i])].node =
          static_cast<Index>(this->Tets.size() + i);
      });
  }

  /// Gives all others the node of their representative.
  void spreadNodes()
  {
    const Index tetCount = this->Complex.tetCount();
    const FacetNumbers& numbers = this->Graph.TriangleNumbers;
    LargeArray<Index>& nodeOfTet = this->Graph.NodeOfTet;
    this->forEach(tetCount,
      [&](Index tet)
      {
        if (!this->isNode({ true, tet }))
        {
          nodeOfTet[tet] = this->nodeOf({ true, tet });
        }
      });
    this->forEach(4 * std::size_t{ tetCount },
      [&](Facet facet)
      {
        if (!numbers.contains(facet))
        {
          return;
        }
        Triangle& triangle = this->Graph.Triangles[numbers.of(facet)];
        const Index beyond = this->Complex.neighbour(facet / 4, static_cast<int>(facet % 4));
        triangle.beyond = beyond == kNone ? this->nothing() : nodeOfTet[beyond];
        if (!this->isNode({ false, facet }))
        {
          triangle.node = this->nodeOf({ false, facet });
        }
      });
  }

  Index nothing() const { return static_cast<Index>(this->Tets.size() + this->Triangles.size()); }

  Index nodeOf(Upper upper) const
  {
    const Representatives::Code code = this->Found.of(upper);
    if (code == kNone)
    {
      return this->nothing();
    }
    const Upper node = this->Found.at(code);
    return node.isTet ? this->Graph.NodeOfTet[node.name]
                      : this->Graph.Triangles[this->Graph.TriangleNumbers.of(node.name)].node;
  }

  bool isTet(Index node) const { return node < this->Tets.size(); }
  Facet triangle(Index node) const { return this->Triangles[node - this->Tets.size()]; }
  bool isCritical(Index node) const
  {
    return !this->isTet(node) && !this->Flow.isObtuse(this->triangle(node));
  }

  /// Fills in holders: append(i, nodes) appends those of i.
  template <class Append>
  void fill(Holders& holders, Append&& append)
  {
    holders.first.resize(this->nothing() + 1);
    holders.first.back() = 0;
    holders.nodes = collect<Index>(this->nothing(), this->Run,
      [&](Index i, auto& nodes)
      {
        const std::size_t begin = nodes.size();
        append(i, nodes);
        holders.first[i] = static_cast<Index>(nodes.size() - begin);
      });
    std::exclusive_scan(
      holders.first.begin(), holders.first.end(), holders.first.begin(), Index{ 0 });
  }

  /// Appends the node of an upper simplex, if there is one. Always true.
  bool add(Upper upper, std::vector<Index>& nodes) const
  {
    const Index node = this->nodeOf(upper);
    if (node != this->nothing())
    {
      nodes.push_back(node);
    }
    return true;
  }

  static void makeUnique(std::vector<Index>& nodes, std::size_t begin)
  {
    const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(begin);
    std::sort(first, nodes.end());
    nodes.erase(std::unique(first, nodes.end()), nodes.end());
  }

  void connect()
  {
    this->fill(this->AllHolders,
      [&](Index node, auto& nodes)
      {
        const std::size_t begin = nodes.size();
        const auto addOne = [&](Upper holder) { return this->add(holder, nodes); };
        const Upper upper = this->isTet(node) ? Upper{ true, this->Tets[node] }
                                              : Upper{ false, this->triangle(node) };
        forEachNearHolder(this->Flow, upper, addOne);
        forEachHolderAround(this->Flow, upper, addOne);
        makeUnique(nodes, begin);
      });
  }

  /// Depth first on an explicit stack: the relation is acyclic.
  void findLevels()
  {
    this->LevelOf.assign(this->nothing(), kNone);
    std::vector<Index> pending;
    for (Index node = 0; node < this->nothing(); ++node)
    {
      pending.assign(1, node);
      while (!pending.empty())
      {
        const Index top = pending.back();
        const std::size_t before = pending.size();
        Index level = this->isSink(top) ? 0 : 1;
        for (const Index holder : this->AllHolders.of(top))
        {
          if (this->LevelOf[holder] == kNone)
          {
            pending.push_back(holder);
          }
          else
          {
            level = std::max(level, this->LevelOf[holder] + 1);
          }
        }
        if (pending.size() == before)
        {
          this->LevelOf[top] = level;
          pending.pop_back();
        }
      }
    }
  }

  bool isSink(Index node) const { return this->isTet(node) && this->Flow.isSink(this->Tets[node]); }

  void listInLevels()
  {
    const Index levels = this->LevelOf.empty() ? 1 : 1 + *std::ranges::max_element(this->LevelOf);
    const Incidence parts(2 * std::size_t{ levels }, this->nothing(),
      [&](std::size_t i, auto&& visit)
      {
        const auto node = static_cast<Index>(i);
        visit(2 * this->LevelOf[node] + (this->isCritical(node) ? 1 : 0));
      });
    this->Graph.NodeAt = parts.items();
    Index critical = 0;
    for (Index level = 0; level < levels; ++level)
    {
      const Index* const begins = &parts.begins()[2 * level];
      this->Graph.Levels.push_back({ begins[0], begins[1], begins[2], critical });
      critical += begins[2] - begins[1];
    }
    this->fill(this->Graph.HoldersAt,
      [&](Index place, auto& nodes)
      { this->appendNeeded(this->AllHolders.of(this->Graph.NodeAt[place]), nodes); });
  }

  /// Appends those of some holders, sorted, that hold none of the others.
  void appendNeeded(std::span<const Index> holders, std::vector<Index>& nodes) const
  {
    thread_local std::vector<std::uint8_t> isNeeded;
    isNeeded.assign(holders.size(), 1);
    for (const Index held : holders)
    {
      for (const Index holder : this->AllHolders.of(held))
      {
        const auto at = std::ranges::lower_bound(holders, holder);
        if (at != holders.end() && *at == holder)
        {
          isNeeded[at - holders.begin()] = 0;
        }
      }
    }
    for (std::size_t i = 0; i < holders.size(); ++i)
    {
      if (isNeeded[i] != 0)
      {
        nodes.push_back(holders[i]);
      }
    }
  }

  void listCritical()
  {
    std::vector<Facet>& critical = this->Graph.CriticalTriangles;
    LargeArray<Index> indexOf(this->Triangles.size());
    for (const Level& level : this->Graph.Levels)
    {
      for (Index place = level.critical; place < level.end; ++place)
      {
        const Index node = this->Graph.NodeAt[place];
        indexOf[node - this->Tets.size()] = static_cast<Index>(critical.size());
        critical.push_back(this->triangle(node));
      }
    }
    this->Graph.Radius.resize(critical.size());
    this->forEach(critical.size(),
      [&](Index i) { this->Graph.Radius[i] = circumradius(this->Complex, critical[i]); });
    const std::span<const Door> doors = this->Graph.TheBlocks.doors();
    this->Graph.IndexOfDoor.resize(doors.size());
    this->forEach(doors.size(),
      [&](Index d)
      {
        this->Graph.IndexOfDoor[d] =
          indexOf[this->nodeOf({ false, doors[d].triangle }) - this->Tets.size()];
      });
  }

  void connectEdges()
  {
    // of each edge its piece, the number of its holders, and these
    const std::vector<Index> records = collect<Index>(this->Complex.tetCount(), this->Run,
      [&](Index tet, auto& found)
      {
        forEachCriticalEdge(
          this->Flow, tet, [](Facet) { return true; },
          [&](const CriticalEdge& edge) { this->describeEdge(edge, tet / kTetsAPiece, found); });
      });
    Holders& edges = this->Graph.Edges;
    std::vector<Index>& firstEdge = this->Graph.FirstEdge;
    edges.first.assign(1, 0);
    edges.nodes.reserve(records.size());
    for (std::size_t at = 0; at < records.size(); at += 2 + records[at + 1])
    {
      firstEdge.resize(records[at] + 1, edges.count());
      const auto first = records.begin() + static_cast<std::ptrdiff_t>(at + 2);
      edges.nodes.insert(edges.nodes.end(), first, first + records[at + 1]);
      edges.first.push_back(static_cast<Index>(edges.nodes.size()));
    }
    firstEdge.resize((this->Complex.tetCount() + kTetsAPiece - 1) / kTetsAPiece + 1, edges.count());
  }

  void describeEdge(const CriticalEdge& edge, Index piece, std::vector<Index>& found) const
  {
    thread_local std::vector<Index> holders;
    holders.clear();
    const auto addOne = [&](Upper upper) { return this->add(upper, holders); };
    const Facet start = this->Complex.canonical(edge.triangle);
    if (this->Flow.isFree(start))
    {
      addOne({ false, start });
    }
    forEachUpperAround(this->Flow, edge.triangle, edge.apex, { true, kNone }, addOne);
    makeUnique(holders, 0);
    if (!holders.empty())
    {
      const std::size_t begin = found.size();
      found.insert(found.end(), { piece, 0 });
      this->appendNeeded(holders, found);
      found[begin + 1] = static_cast<Index>(found.size() - begin - 2);
    }
  }

  void findPieces()
  {
    std::vector<std::vector<Index>> nodesOf(this->Graph.pieceCount());
    constexpr std::size_t kGrain = 64;
    this->Run.parallelFor(nodesOf.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        thread_local std::vector<std::uint8_t> isListed;
        isListed.resize(std::max<std::size_t>(isListed.size(), this->nothing() + 1), 0);
        for (std::size_t piece = begin; piece < end; ++piece)
        {
          std::vector<Index>& nodes = nodesOf[piece];
          this->forEachNodeIn(static_cast<Index>(piece),
            [&](Index node)
            {
              if (std::exchange(isListed[node], 1) == 0)
              {
                nodes.push_back(node);
              }
            });
          std::ranges::for_each(nodes, [&](Index node) { isListed[node] = 0; });
        }
      });
    this->Graph.PiecesOfNodes = Incidence(this->nothing() + 1, nodesOf.size(),
      [&](std::size_t piece, auto&& visit)
      { std::for_each(nodesOf[piece].begin(), nodesOf[piece].end(), visit); });
  }

  /// Some of them more than once.
  template <class Visit>
  void forEachNodeIn(Index piece, Visit&& visit) const
  {
    const FacetNumbers& numbers = this->Graph.TriangleNumbers;
    const Holders& edges = this->Graph.Edges;
    const Index begin = kTetsAPiece * piece;
    const Index end = std::min(begin + kTetsAPiece, this->Complex.tetCount());
    for (Index tet = begin; tet < end; ++tet)
    {
      visit(this->Graph.NodeOfTet[tet]);
    }
    for (Index i = numbers.of(4 * begin); i < numbers.of(4 * end); ++i)
    {
      visit(this->Graph.Triangles[i].node);
      visit(this->Graph.Triangles[i].beyond);
    }
    for (Index i = this->Graph.firstEdge(piece); i < this->Graph.firstEdge(piece + 1); ++i)
    {
      std::ranges::for_each(edges.of(i), visit);
    }
  }

  CollapseGraph& Graph;
  const FlowComplex& Flow;
  const DelaunayComplex& Complex;
  Execution& Run;
  const Representatives& Found;
  std::vector<Index> Tets;      ///< that are nodes
  std::vector<Facet> Triangles; ///< that are nodes
  Holders AllHolders;           ///< of nodes
  std::vector<Index> LevelOf;   ///< of nodes
};

CollapseGraph::CollapseGraph(const Blocks& blocks, Execution& execution)
  : CollapseGraph(blocks, Representatives(blocks.flow(), execution), execution)
{
}

CollapseGraph::CollapseGraph(
  const Blocks& blocks, const Representatives& found, Execution& execution)
  : TheBlocks(blocks)
  , TriangleNumbers(blocks.flow().delaunay(), execution,
      [&](Facet facet) {
        return blocks.flow().isFree(facet) && found.of({ false, facet }) != kNone;
      })
{
  execution.step("holders", 1, kSteps);
  Builder(*this, found, execution).build();
}

} // namespace scan
