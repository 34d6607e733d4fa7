// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/facet_numbers.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/representatives.h"

#include <span>
#include <vector>

namespace scan
{

/// What holds what in the Wrap complex: made once, it tells for every state that follows the flow
/// what goes, or comes back, with any number of blocks.
///
/// The relation of holders (holders.h), made smaller. Nodes are the representatives
/// (representatives.h) and stand for all that goes and stays with them: sinks, critical triangles,
/// and few others. Of holders that hold one another only the last ones count.
class CollapseGraph
{
public:
  /// For each of some things the nodes that hold it.
  struct Holders
  {
    LargeArray<Index> first; ///< of each, and one past the last
    std::vector<Index> nodes;

    Index count() const { return static_cast<Index>(this->first.size() - 1); }
    std::span<const Index> of(Index i) const
    {
      return { this->nodes.data() + this->first[i], this->nodes.data() + this->first[i + 1] };
    }
  };

  /// Nodes whose holders are in levels before, by their places in a list of all.
  struct Level
  {
    Index begin;
    Index critical; ///< from here on they are critical triangles
    Index end;
    Index firstCritical; ///< how many of these there are in levels before
  };

  /// A free triangle: its node, and that of the tetrahedron beyond the one it is named after.
  struct Triangle
  {
    Index node;
    Index beyond;
  };

  /// Walks around every edge; about 130 bytes a point. For at most Representatives::kMostTets
  /// tetrahedra. Reports phase "holders".
  CollapseGraph(const Blocks& blocks, Execution& execution);

  const FlowComplex& flow() const { return this->TheBlocks.flow(); }
  const Basins& basins() const { return this->TheBlocks.basins(); }

  Index nodeCount() const { return static_cast<Index>(this->NodeAt.size()); }
  Index nothing() const { return this->nodeCount(); } ///< the node of what is never kept

  /// The first level are the sinks, which have no holders.
  std::span<const Level> levels() const { return this->Levels; }
  Index nodeAt(Index place) const { return this->NodeAt[place]; }
  std::span<const Index> holdersAt(Index place) const { return this->HoldersAt.of(place); }

  Index nodeOfTet(Index tet) const { return this->NodeOfTet[tet]; }

  /// The free triangles that a critical simplex holds.
  const FacetNumbers& triangleNumbers() const { return this->TriangleNumbers; }
  Triangle triangle(Index number) const { return this->Triangles[number]; }

  /// Critical edges that a node holds.
  const Holders& edges() const { return this->Edges; }

  /// Pieces of the complex: so many tetrahedra each, with the triangles named after them.
  static constexpr Index kTetsAPiece = 1 << 10;
  /// A node and the pieces in which it is the node of a tetrahedron or on a side of a triangle, or
  /// holds an edge: what it changes is there.
  const Incidence& piecesOfNodes() const { return this->PiecesOfNodes; }
  Index pieceCount() const { return static_cast<Index>(this->FirstEdge.size() - 1); }
  /// The first edge of a piece, or one past all.
  Index firstEdge(Index piece) const { return this->FirstEdge[piece]; }

  /// In the order of the list, by canonical facets.
  std::span<const Facet> criticalTriangles() const { return this->CriticalTriangles; }
  double radiusOf(Index critical) const { return this->Radius[critical]; }
  /// The place in criticalTriangles() of a door of the blocks.
  Index indexOfDoor(Index door) const { return this->IndexOfDoor[door]; }

private:
  class Builder;

  CollapseGraph(const Blocks& blocks, const Representatives& found, Execution& execution);

  const Blocks& TheBlocks;
  FacetNumbers TriangleNumbers;
  LargeArray<Triangle> Triangles;
  LargeArray<Index> NodeOfTet;
  std::vector<Level> Levels;
  std::vector<Index> NodeAt;
  Holders HoldersAt;
  Holders Edges;
  std::vector<Index> FirstEdge;
  Incidence PiecesOfNodes;
  std::vector<Facet> CriticalTriangles;
  LargeArray<double> Radius;
  LargeArray<Index> IndexOfDoor;
};

} // namespace scan
