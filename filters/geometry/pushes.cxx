// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/pushes.h"

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <utility>

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
    , Progress(TheBlocks.outside() + 1, Progressed::no)
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
      this->collapse(Doors::stay);
      this->removeKeeper(keeper);
    }
    for (const BlockName& block : named)
    {
      this->collapse(Doors::stay);
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
      if (block.name != kNone && !block.isSheet)
      {
        this->forEachInReach(block.name, [](Index) { return true; });
      }
    }
    this->addVolumes();
    for (const BlockName& block : removed)
    {
      if (block.name != kNone && block.isSheet && !this->State.kept().keepsTriangle(block.name))
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
  enum class Progressed : std::uint8_t
  {
    no,
    upTo,
    through
  };

  enum class Doors : std::uint8_t
  {
    stay,
    goAlong
  };

  /// Calls act(block) -> whether it is kept, for the block, whether it was reached before or not,
  /// and, deep, for all others that one passes to from there. Lists the doors of them through which
  /// one passes in one direction at least.
  template <class Act>
  void forEachInReach(Index first, Act&& act)
  {
    constexpr std::size_t kAhead = 8;
    std::vector<Index> queue{ first };
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
      if (next + kAhead < queue.size())
      {
        const Index soon = queue[next + kAhead];
        __builtin_prefetch(this->TheBlocks.waysFrom(soon).data());
        this->State.kept().prefetch(this->TheBlocks.sink(soon));
      }
      const Index block = queue[next];
      const bool isGone = !act(block) || !this->State.kept().followsFlow();
      if (std::exchange(this->Progress[block], Progressed::through) == Progressed::through)
      {
        continue;
      }
      this->Reached.push_back(block);
      const double own = this->TheBlocks.size(block);
      for (const Way& way : this->TheBlocks.waysFrom(block))
      {
        Progressed& progress = this->Progress[way.beyond];
        if (progress == Progressed::through)
        {
          continue;
        }
        constexpr double kRounding = 1e-9;
        const double size = std::min(own, this->TheBlocks.size(way.beyond));
        const double widest = this->Options.reach * way.radius;
        if (size > (1.0 + kRounding) * widest)
        {
          break; // nor through those that follow
        }
        if (size > widest)
        {
          continue;
        }
        this->DoorsInReach.push_back(way.door);
        if (isGone)
        {
          this->DoorsOfGone.push_back(way.door);
        }
        if (this->Options.deep && progress == Progressed::no &&
          this->TheBlocks.isVolume(way.beyond) && own <= widest)
        {
          progress = Progressed::upTo;
          queue.push_back(way.beyond);
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
        const bool isKept = this->Model.isSolid
          ? this->removeSolid(volume)
          : this->State.kept().keepsTet(this->TheBlocks.sink(volume));
        if (isKept)
        {
          this->Going.push_back(volume);
          this->Report.blocks.push_back({ .isSheet = false, .name = volume });
        }
        return isKept;
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
    const std::vector<BlockName> earlier = this->bareDoors();
    if (this->collapse(Doors::goAlong) == Doors::stay)
    {
      this->removeBareDoors();
    }
    this->nameEarlierDoors(earlier);
  }

  void removeBareDoors()
  {
    Index before = 0;
    do // without a door more may collapse, and bare more doors
    {
      before = this->Report.doors;
      for (const Index d : this->DoorsInReach)
      {
        const Facet triangle = this->TheBlocks.doors()[d].triangle;
        if (this->State.kept().isSheetNamed(triangle))
        {
          this->Editor.removeSheet(triangle);
          ++this->Report.doors;
        }
      }
      this->collapse(Doors::stay);
    } while (this->Report.doors != before);
  }

  /// Walls that stand between blocks that were gone before this push.
  std::vector<BlockName> bareDoors() const
  {
    std::vector<BlockName> bare;
    for (const Index d : this->DoorsOfGone)
    {
      const Facet triangle = this->TheBlocks.doors()[d].triangle;
      if (this->Model.current->isSheetNamed(triangle) && this->State.kept().isSheetNamed(triangle))
      {
        bare.push_back({ .isSheet = true, .name = triangle });
      }
    }
    return bare;
  }

  /// Those that went belong to no block that goes now: they are blocks of their own, so that a pull
  /// brings them back.
  void nameEarlierDoors(std::span<const BlockName> bare)
  {
    for (const BlockName& door : bare)
    {
      if (!this->State.kept().keepsTriangle(door.name))
      {
        this->Report.blocks.push_back(door);
        --this->Report.doors;
      }
    }
  }

  /// What edits these volumes at once, null where that is not worth it, or not possible.
  const CollapseGraph* graph(std::span<const Index> volumes) const
  {
    std::int64_t tets = 0;
    for (const Index volume : volumes)
    {
      tets += this->TheBlocks.tetCount(volume);
    }
    return this->Model.scan->graphFor(this->State.kept(), tets, this->Run);
  }

  /// Everything that collapses without the blocks that are going; in bulk the doors go along, if
  /// they may. Solids are not bound to the flow: of them goes what is asked for and nothing else.
  Doors collapse(Doors doors)
  {
    const std::vector<Index> going = std::exchange(this->Going, {});
    if (this->Model.isSolid)
    {
      return Doors::stay;
    }
    const CollapseGraph* graph = this->graph(going);
    if (graph == nullptr)
    {
      this->Editor.removeVolumes(going, this->TheBlocks, this->Run);
      return Doors::stay;
    }
    CriticalChoice choice = criticalChoiceOf(this->State.kept(), this->TheBlocks.basins());
    for (const Index volume : going)
    {
      choice.holdsBasin[volume] = 0;
    }
    std::vector<std::uint8_t> opened; // per critical triangle of the graph
    if (doors == Doors::goAlong)
    {
      opened.resize(graph->criticalTriangles().size(), 0);
      for (const Index d : this->DoorsInReach)
      {
        opened[graph->indexOfDoor(d)] = 1;
      }
      choice.keepsTriangle = [&](Index i, bool was) { return was && opened[i] == 0; };
    }
    this->Report.doors += this->Editor.choose(*graph, choice, this->Run);
    return doors;
  }

  /// What may be added with a block: what was there at the start, if the block was.
  const WrapComplex* limits(const BlockName& block) const
  {
    return isKept(*this->Model.start, this->TheBlocks, block) ? this->Model.start.get() : nullptr;
  }

  /// All blocks in reach.
  void addVolumes()
  {
    std::vector<Index> coming;
    for (const Index block : this->Reached)
    {
      if (!isKept(this->State.kept(), this->TheBlocks, { .isSheet = false, .name = block }))
      {
        coming.push_back(block);
      }
    }
    const CollapseGraph* graph = this->Model.start->followsFlow() ? this->graph(coming) : nullptr;
    if (graph == nullptr)
    {
      std::ranges::for_each(this->Reached, [&](Index block) { this->addVolume(block); });
      return;
    }
    CriticalChoice choice = criticalChoiceOf(this->State.kept(), this->TheBlocks.basins());
    for (const Index block : coming)
    {
      choice.holdsBasin[block] = 1;
      this->Report.blocks.push_back({ .isSheet = false, .name = block });
    }
    this->Editor.choose(*graph, choice, this->Run);
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
  std::vector<Progressed> Progress; ///< per block
  std::vector<Index> Reached;       ///< blocks
  std::vector<Index> DoorsInReach;  ///< of them
  std::vector<Index> DoorsOfGone;   ///< those of blocks that may have gone before this push
  std::vector<Index> Going;         ///< volumes that are still to be removed
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
