// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/pushes.h"

#include <algorithm>
#include <memory>
#include <unordered_set>

namespace scan
{
namespace
{

/// Calls visit(tet) for the tetrahedra of a block that hang together with the first and are wanted.
template <class Wanted, class Visit>
void floodBlock(const Blocks& blocks, Index first, Wanted&& wanted, Visit&& visit)
{
  const DelaunayComplex& complex = blocks.flow().delaunay();
  const Index block = blocks.ofTet(first);
  std::unordered_set<Index> seen{ first };
  std::vector<Index> pending{ first };
  while (!pending.empty())
  {
    const Index tet = pending.back();
    pending.pop_back();
    visit(tet);
    for (int k = 0; k < 4; ++k)
    {
      const Index beyond = complex.neighbour(tet, k);
      if (beyond != kNone && blocks.ofTet(beyond) == block && wanted(beyond) &&
        seen.insert(beyond).second)
      {
        pending.push_back(beyond);
      }
    }
  }
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
    , Complex(model.scan->delaunay())
    , Next(std::make_shared<WrapComplex>(*model.current))
    , Editor(*Next, *model.lines)
  {
  }

  void push(std::span<const Facet> triangles, std::span<const BlockName> named)
  {
    WrapModel now = this->Model;
    now.current = this->Next;
    for (const Facet triangle : triangles)
    {
      if (isOnSurface(*this->Next, triangle))
      {
        this->removeBehind(triangle, blockBehind(now, this->TheBlocks, triangle));
        this->Editor.collapse(this->Run);
      }
    }
    for (const BlockName& block : named)
    {
      if (isKept(*this->Next, this->TheBlocks, block))
      {
        this->removeBlock(block);
        this->Editor.collapse(this->Run);
      }
    }
    this->removeDoors();
  }

  void pull(std::span<const BlockName> removed)
  {
    for (const BlockName& block : removed)
    {
      if (block.name == kNone || isKept(*this->Next, this->TheBlocks, block))
      {
        continue;
      }
      if (block.isSheet)
      {
        this->Editor.addLowerSetOfTriangle(block.name, this->limits(block), this->Run);
        this->Report.blocks.push_back(block);
        continue;
      }
      this->forEachInReach(block.name,
        [&](Index volume)
        {
          if (!this->Next->keepsTet(this->TheBlocks.sink(volume)))
          {
            this->addVolume(volume);
          }
        });
    }
  }

  PushReport finish()
  {
    this->Report.change = this->Editor.change();
    this->Report.surface = compareSurfaces(*this->Model.current, *this->Next, this->Editor);
    this->Model.current = this->Next;
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

  void removeBehind(Facet triangle, const BlockName& block)
  {
    if (block.isSheet ||
      (this->TheBlocks.isVolume(block.name) && isKept(*this->Next, this->TheBlocks, block)))
    {
      this->removeBlock(block);
      return;
    }
    this->removeRemnant(this->Next->keepsTet(triangle / 4)
        ? triangle / 4
        : this->Complex.neighbour(triangle / 4, static_cast<int>(triangle % 4)));
    this->Report.blocks.push_back(block);
  }

  void removeBlock(const BlockName& block)
  {
    if (!block.isSheet)
    {
      this->forEachInReach(block.name, [&](Index volume) { this->removeVolume(volume); });
    }
    else if (this->Next->isSheet(block.name))
    {
      this->Editor.removeSheet(block.name);
      this->Report.blocks.push_back(block);
    }
  }

  void removeVolume(Index block)
  {
    const Index sink = this->TheBlocks.sink(block);
    if (!this->Next->keepsTet(sink))
    {
      return;
    }
    this->Report.blocks.push_back({ .isSheet = false, .name = block });
    if (this->Model.isSolid)
    {
      this->removeRemnant(sink);
    }
    else
    {
      this->Editor.removeTet(sink);
    }
  }

  /// Removes what is kept of a block around a tetrahedron, and the walls between what is gone.
  void removeRemnant(Index tet)
  {
    std::vector<Index> remnant;
    floodBlock(
      this->TheBlocks, tet, [&](Index at) { return this->Next->keepsTet(at); },
      [&](Index at) { remnant.push_back(at); });
    for (const Index at : remnant)
    {
      this->Editor.removeTet(at);
    }
    const FlowComplex& flow = this->TheBlocks.flow();
    for (const Index at : remnant)
    {
      for (Facet facet = 4 * at; facet < 4 * at + 4; ++facet)
      {
        if (this->Next->isSheet(facet) && (this->Model.isSolid || !flow.isFree(facet)))
        {
          this->Editor.removeSheet(facet);
        }
      }
    }
  }

  void removeDoors()
  {
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
      this->Editor.collapse(this->Run);
    } while (this->Report.doors != before);
  }

  void removeIfBare(const Door& door)
  {
    if (this->Next->isSheet(door.triangle) &&
      (this->TheBlocks.passes(door.a, door, this->Options.reach) ||
        this->TheBlocks.passes(door.b, door, this->Options.reach)))
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
    this->Report.blocks.push_back(name);
    const WrapComplex* const within = this->limits(name);
    if (!this->Model.isSolid)
    {
      this->Editor.addLowerSet(this->TheBlocks.sink(block), within, this->Run);
      return;
    }
    floodBlock(
      this->TheBlocks, this->TheBlocks.sink(block), [](Index) { return true; },
      [&](Index tet)
      {
        if (within == nullptr || within->keepsTet(tet))
        {
          this->Editor.addTet(tet);
        }
      });
  }

  WrapModel& Model;
  const PushOptions& Options;
  Execution& Run;
  const Blocks& TheBlocks;
  const DelaunayComplex& Complex;
  std::shared_ptr<WrapComplex> Next;
  WrapEditor Editor;
  std::unordered_set<Index> Reached;
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
