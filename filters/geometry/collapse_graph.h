// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/large_array.h"

#include <span>
#include <vector>

namespace scan
{

/// What holds what in the Wrap complex: made once, it tells for every state that follows the flow
/// what goes, or comes back, with any number of blocks.
///
/// The relation of holders (holders.h), made smaller: a tetrahedron that hangs on another one alone
/// is a *member* of it (dominators.h). Nodes are the other tetrahedra, all free triangles, and the
/// critical edges, which hold nothing. What the collapse from outside removes has no place here,
/// nor have edges that nothing holds. Everything is grouped with a basin: while the sink of that is
/// kept, it is kept as well. Triangles and edges are grouped with one that has a sink, if they can
/// be.
class CollapseGraph
{
public:
  /// Nodes of one kind, with numbers that tell the kinds apart. Edges have no names or numbers.
  struct Nodes
  {
    Index first = 0;               ///< number of the first one
    std::vector<Index> name;       ///< tetrahedron or canonical facet
    std::vector<Index> ofBasin;    ///< of each basin the first one, and one past the last
    LargeArray<Index> firstHolder; ///< of each node, and one past the last
    std::vector<Index> holders;    ///< their numbers

    Index count() const { return static_cast<Index>(this->firstHolder.size() - 1); }
    std::span<const Index> holdersOf(Index i) const
    {
      return { this->holders.data() + this->firstHolder[i],
        this->holders.data() + this->firstHolder[i + 1] };
    }
  };

  /// Walks around every edge; about 150 bytes a point. For at most Dominators::kMostTets
  /// tetrahedra. Reports phase "holders".
  CollapseGraph(const Blocks& blocks, Execution& execution);

  const FlowComplex& flow() const { return this->TheBlocks.flow(); }
  const Basins& basins() const { return this->TheBlocks.basins(); }

  /// Tetrahedra; those without holders are the sinks.
  const Nodes& tets() const { return this->Tets; }
  /// Free triangles that are not critical. The first two holders are those on their sides.
  const Nodes& obtuse() const { return this->Obtuse; }
  /// Critical triangles, with two holders: those on their sides.
  const Nodes& critical() const { return this->Critical; }
  double radiusOf(Index critical) const { return this->Radius[critical]; }
  const Nodes& edges() const { return this->Edges; }
  /// The holder that is never kept.
  Index nothing() const { return this->Critical.first + this->Critical.count(); }

  /// The tetrahedra that hang on node i of tets(), itself among them.
  std::span<const Index> membersOf(Index i) const { return this->Members.of(i); }

  /// The place in critical() of a door of the blocks.
  Index indexOfDoor(Index door) const { return this->IndexOfDoor[door]; }

private:
  class Builder;

  const Blocks& TheBlocks;
  Nodes Tets;
  Nodes Obtuse;
  Nodes Critical;
  LargeArray<Index> IndexOfDoor;
  LargeArray<double> Radius; ///< of the critical triangles
  Nodes Edges;
  Incidence Members;
};

} // namespace scan
