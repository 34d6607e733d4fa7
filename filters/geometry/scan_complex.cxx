// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/scan_complex.h"

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

const CollapseGraph* ScanComplex::graphFor(std::int64_t tets, Execution& execution) const
{
  constexpr std::int64_t kTetsAPass = 512;    // a pass over that many costs what editing one does
  constexpr std::int64_t kPartOfTheGraph = 2; // to edit this part of all takes as long as the graph
  if (kTetsAPass * tets <= this->Delaunay.tetCount())
  {
    return nullptr;
  }
  {
    const std::scoped_lock lock(this->Guard);
    if (!this->TheGraph && kPartOfTheGraph * this->EditedOneByOne < this->Delaunay.tetCount())
    {
      this->EditedOneByOne += tets;
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
  this->graph(execution);
}

} // namespace scan
