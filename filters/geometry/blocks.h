// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"
#include "filters/geometry/large_array.h"

#include <algorithm>
#include <span>
#include <vector>

namespace scan
{

/// A critical triangle whose two sides flow to different volume blocks, or to one and outside.
struct Door
{
  Facet triangle;
  Index a;
  Index b;
  double radius;
};

/// A door as a way out of one of its blocks.
struct Way
{
  Index door;
  Index beyond; ///< the block on the other side
  double radius;
};

/// The volume blocks of a Delaunay complex and the doors between them.
///
/// A volume block is what flows to one sink: a basin that does not leave the hull, under the same
/// number. Everything that leaves the hull is one block, the outside. The size of a block is the
/// circumradius of its sink, infinite for the outside; a door is never larger than the blocks on
/// its two sides. Lengths are in model units.
class Blocks
{
public:
  Blocks(const FlowComplex& flow, const Basins& basins, Execution& execution);

  const FlowComplex& flow() const { return this->Flow; }
  const Basins& basins() const { return this->TheBasins; }

  Index outside() const { return this->TheBasins.count(); }
  bool isVolume(Index block) const
  {
    return block < this->outside() && !this->TheBasins.leavesHull(block);
  }

  /// The volume block or the outside.
  Index ofTet(Index tet) const
  {
    const Index basin = this->TheBasins.ofTet[tet];
    return this->TheBasins.leavesHull(basin) ? this->outside() : basin;
  }

  Index tetCount(Index block) const { return this->TetCount[block]; } ///< that flow to its sink
  Index sink(Index block) const { return this->TheBasins.sink[block]; }
  double size(Index block) const { return this->Size[block]; }

  /// Death / birth radius, at least 1: how much wider the room is than its way out.
  double persistence(Index block) const { return this->Persistence[block]; }

  /// The widest radius at which one still gets into the block from outside: the smallest door on
  /// the way is as large as possible. The merge tree of the blocks, cut at every block at once.
  double opening(Index block) const { return this->Opening[block]; }

  std::span<const Door> doors() const { return this->Doors; } ///< in the order of their triangles

  /// Out of a volume block; those through which one passes at a small reach, in one direction at
  /// least, come first.
  std::span<const Way> waysFrom(Index block) const
  {
    return { this->Ways.data() + this->FirstWay[block],
      this->Ways.data() + this->FirstWay[block + 1] };
  }

private:
  void listWays(Execution& execution);
  void measureOpenings(Execution& execution);

  const FlowComplex& Flow;
  const Basins& TheBasins;
  std::vector<Index> TetCount;
  std::vector<double> Size;
  std::vector<double> Persistence;
  std::vector<double> Opening;
  std::vector<Door> Doors;
  std::vector<Index> FirstWay; ///< of each block, and one past the last
  LargeArray<Way> Ways;
};

} // namespace scan
