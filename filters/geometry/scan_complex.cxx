// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/scan_complex.h"

#include "filters/geometry/dominators.h"

namespace scan
{

ScanComplex::ScanComplex(std::span<const Vec3> points, Execution& execution)
  : Delaunay(buildDelaunayComplex(points, execution))
  , Flow(Delaunay, execution)
  , TheBasins(findBasins(Flow, execution))
{
}

const Blocks& ScanComplex::blocks(Execution& execution) const
{
  const std::scoped_lock lock(this->Guard);
  if (!this->TheBlocks)
  {
    this->TheBlocks = std::make_unique<const Blocks>(this->Flow, this->TheBasins, execution);
  }
  return *this->TheBlocks;
}

const SizeScale& ScanComplex::sizes(Execution& execution) const
{
  const Blocks& blocks = this->blocks(execution);
  const std::scoped_lock lock(this->Guard);
  if (!this->TheSizes)
  {
    this->TheSizes = std::make_unique<const SizeScale>(*this, blocks, execution);
  }
  return *this->TheSizes;
}

const CollapseGraph* ScanComplex::graphFor(
  const WrapComplex& kept, std::int64_t tets, Execution& execution) const
{
  // measured: what it costs to look at one instead of editing it
  constexpr std::int64_t kAPass = 512;        // of all
  constexpr std::int64_t kOpen = 16;          // of those in blocks that are gone
  constexpr std::int64_t kPartOfTheGraph = 2; // to edit this part of all takes as long as the graph
  std::int64_t cost = this->Delaunay.tetCount() / kAPass;
  if (!kept.followsFlow() || tets <= cost || this->Delaunay.tetCount() > Dominators::kMostTets)
  {
    return nullptr;
  }
  const Blocks& blocks = this->blocks(execution);
  for (Index block = 0; block < blocks.outside(); ++block)
  {
    const bool isOpen = blocks.isVolume(block) && !kept.keepsTet(blocks.sink(block));
    cost += isOpen ? blocks.tetCount(block) / kOpen : 0;
  }
  if (tets <= cost)
  {
    return nullptr;
  }
  {
    const std::scoped_lock lock(this->Guard);
    const std::int64_t edited = this->EditedOneByOne + tets;
    if (!this->TheGraph && kPartOfTheGraph * edited < this->Delaunay.tetCount())
    {
      this->EditedOneByOne = edited;
      return nullptr;
    }
  }
  return &this->graph(execution);
}

const CollapseGraph& ScanComplex::graph(Execution& execution) const
{
  const Blocks& blocks = this->blocks(execution);
  const std::scoped_lock lock(this->Guard);
  if (!this->TheGraph)
  {
    this->TheGraph = std::make_unique<const CollapseGraph>(blocks, execution);
  }
  return *this->TheGraph;
}

void ScanComplex::prepareEdits(Execution& execution) const
{
  this->sizes(execution);
  if (this->Delaunay.tetCount() <= Dominators::kMostTets)
  {
    this->graph(execution);
  }
}

} // namespace scan
