// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/pushes.h"

#include <algorithm>
#include <unordered_set>

namespace scan
{
namespace
{

/// The tetrahedra of a basin that hang together with the first and are wanted.
template <class Wanted>
std::vector<Index> floodBasin(const ScanComplex& scan, Index first, Wanted&& wanted)
{
  const std::vector<Index>& basinOf = scan.basins().ofTet;
  std::unordered_set<Index> seen{ first };
  std::vector<Index> found{ first };
  for (std::size_t next = 0; next < found.size(); ++next)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Index beyond = scan.delaunay().neighbour(found[next], k);
      if (beyond != kNone && basinOf[beyond] == basinOf[first] && wanted(beyond) &&
        seen.insert(beyond).second)
      {
        found.push_back(beyond);
      }
    }
  }
  return found;
}

/// All tetrahedra of a basin.
std::vector<Index> tetsOfBasin(const ScanComplex& scan, Index basin)
{
  const std::vector<Index>& basinOf = scan.basins().ofTet;
  const Index sink = scan.basins().sink[basin];
  const Index first =
    sink != kNone ? sink : static_cast<Index>(std::ranges::find(basinOf, basin) - basinOf.begin());
  return floodBasin(scan, first, [](Index) { return true; });
}

/// What one push or pull is about: the state being made, and the blocks that were met.
class Pushing
{
public:
  Pushing(WrapModel& model, const PushOptions& options, Execution& execution)
    : Model(model)
    , Options(options)
    , Run(execution)
    , TheBlocks(model.scan->blocks(execution))
    , State(model)
    , Editor(State.editor())
  {
  }

  void push(std::span<const Facet> triangles, std::span<const BlockName> named)
  {
    std::vector<Keeper> marked; // what the marks mean, before anything is removed
    for (const Facet triangle : triangles)
    {
      if (isOnSurface(this->State.kept(), triangle))
      {
        marked.push_back(keeperBehind(this->Model, this->TheBlocks, triangle));
      }
    }
    for (const Keeper& keeper : marked)
    {
      this->collapse();
      this->removeKeeper(keeper);
    }
    for (const BlockName& block : named)
    {
      this->collapse();
      if (isKept(this->State.kept(), this->TheBlocks, block))
      {
        this->removeBlock(block);
      }
    }
    this->removeDoors();
  }

  void pull(std::span<const BlockName> removed)
  {
    for (const BlockName& block : removed)
    {
      if (block.name == kNone)
      {
        continue;
      }
      if (!block.isSheet)
      {
        this->forEachInReach(block.name, [&](Index volume) { this->addVolume(volume); });
      }
      else if (!this->State.kept().keepsTriangle(block.name))
      {
        this->Editor.addLowerSetOfTriangle(block.name, this->limits(block), this->Run);
        this->Report.blocks.push_back(block);
      }
    }
  }

  PushReport finish()
  {
    this->Report.change = this->Editor.change();
    if (this->Options.compare)
    {
      this->Report.surface = compareSurfaces(*this->Model.current, this->State.kept(), this->Run);
    }
    this->State.makeCurrent();
    return std::move(this->Report);
  }

private:
  /// Calls act(block) for the block and, deep, all that one passes to from there.
  template <class Act>
  void forEachInReach(Index first, Act&& act)
  {
    std::vector<Index> pending{ first };
    this->Reached.insert(first);
    while (!pending.empty())
    {
      const Index block = pending.back();
      pending.pop_back();
      act(block);
      if (!this->Options.deep)
      {
        continue;
      }
      for (const Index d : this->TheBlocks.doorsOf(block))
      {
        const Door& door = this->TheBlocks.doors()[d];
        const Index other = door.a == block ? door.b : door.a;
        if (this->TheBlocks.isVolume(other) &&
          this->TheBlocks.passes(block, door, this->Options.reach) &&
          this->Reached.insert(other).second)
        {
          pending.push_back(other);
        }
      }
    }
  }

  void removeKeeper(const Keeper& keeper)
  {
    const BlockName& block = keeper.block;
    if (block.isSheet || this->Model.isSolid || isKept(this->State.kept(), this->TheBlocks, block))
    {
      this->removeBlock(block);
    }
    else if (this->State.kept().keepsTet(keeper.tet))
    {
      this->State.removeWhole(floodBasin(*this->Model.scan, keeper.tet,
        [&](Index tet) { return this->State.kept().keepsTet(tet); }));
      this->Report.blocks.push_back(block);
    }
  }

  void removeBlock(const BlockName& block)
  {
    if (!block.isSheet)
    {
      this->removeVolumes(block.name);
    }
    else if (this->State.kept().isSheet(block.name))
    {
      this->Editor.removeSheet(block.name);
      this->Report.blocks.push_back(block);
    }
  }

  void removeVolumes(Index first)
  {
    this->forEachInReach(first,
      [&](Index volume)
      {
        const bool goes = this->Model.isSolid
          ? this->removeSolid(volume)
          : this->State.kept().keepsTet(this->TheBlocks.sink(volume));
        if (goes)
        {
          this->Going.push_back(volume);
          this->Report.blocks.push_back({ .isSheet = false, .name = volume });
        }
      });
  }

  bool removeSolid(Index block)
  {
    std::vector<Index> tets = tetsOfBasin(*this->Model.scan, block);
    std::erase_if(tets, [&](Index tet) { return !this->State.kept().keepsTet(tet); });
    this->State.removeWhole(tets);
    return !tets.empty();
  }

  void removeDoors()
  {
    if (!this->Model.isSolid && this->Editor.isBulk(this->Going, this->TheBlocks))
    {
      this->Report.doors +=
        this->Editor.removeInBulk(this->Going, this->doorsInReach(), this->TheBlocks, this->Run);
      this->Going.clear();
    }
    this->collapse();
    Index before = 0;
    do // without a door more may collapse, and bare more doors
    {
      before = this->Report.doors;
      for (const Index block : this->Reached)
      {
        for (const Index d : this->TheBlocks.doorsOf(block))
        {
          this->removeIfBare(this->TheBlocks.doors()[d]);
        }
      }
      this->collapse();
    } while (this->Report.doors != before);
  }

  std::vector<Facet> doorsInReach() const
  {
    std::vector<Facet> triangles;
    for (const Index block : this->Reached)
    {
      for (const Index d : this->TheBlocks.doorsOf(block))
      {
        const Door& door = this->TheBlocks.doors()[d];
        if (this->isPassed(door))
        {
          triangles.push_back(door.triangle);
        }
      }
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  /// Everything that collapses without the blocks that are going. Solids are not bound to the flow:
  /// of them goes what is asked for and nothing else.
  void collapse()
  {
    if (!this->Model.isSolid)
    {
      this->Editor.removeVolumes(this->Going, this->TheBlocks, this->Run);
    }
    this->Going.clear();
  }

  /// Whether one of the sides passes to the other.
  bool isPassed(const Door& door) const
  {
    return this->TheBlocks.passes(door.a, door, this->Options.reach) ||
      this->TheBlocks.passes(door.b, door, this->Options.reach);
  }

  void removeIfBare(const Door& door)
  {
    if (this->State.kept().isSheet(door.triangle) && this->isPassed(door))
    {
      this->Editor.removeSheet(door.triangle);
      ++this->Report.doors;
    }
  }

  /// What may be added with a block: what was there at the start, if the block was.
  const WrapComplex* limits(const BlockName& block) const
  {
    return isKept(*this->Model.start, this->TheBlocks, block) ? this->Model.start.get() : nullptr;
  }

  void addVolume(Index block)
  {
    const BlockName name{ .isSheet = false, .name = block };
    const std::int64_t before = this->Editor.change().tetrahedra;
    if (this->Model.isSolid)
    {
      std::vector<Index> tets = tetsOfBasin(*this->Model.scan, block);
      const auto wasThere = [&](Index tet) { return this->Model.start->keepsTet(tet); };
      if (std::ranges::any_of(tets, wasThere))
      {
        std::erase_if(tets, [&](Index tet) { return !wasThere(tet); });
      }
      for (const Index tet : tets)
      {
        this->Editor.addTet(tet);
      }
    }
    else if (!isKept(this->State.kept(), this->TheBlocks, name))
    {
      this->Editor.addLowerSet(this->TheBlocks.sink(block), this->limits(name), this->Run);
    }
    if (this->Editor.change().tetrahedra > before)
    {
      this->Report.blocks.push_back(name);
    }
  }

  WrapModel& Model;
  const PushOptions& Options;
  Execution& Run;
  const Blocks& TheBlocks;
  ModelEdit State;
  WrapEditor& Editor;
  std::unordered_set<Index> Reached;
  std::vector<Index> Going; ///< volumes that are still to be removed
  PushReport Report;
};

} // namespace

PushReport push(WrapModel& model, std::span<const Facet> triangles,
  std::span<const BlockName> named, const PushOptions& options, Execution& execution)
{
  Pushing pushing(model, options, execution);
  pushing.push(triangles, named);
  return pushing.finish();
}

PushReport pull(WrapModel& model, std::span<const BlockName> removed, const PushOptions& options,
  Execution& execution)
{
  Pushing pushing(model, options, execution);
  pushing.pull(removed);
  return pushing.finish();
}

} // namespace scan
