// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/scan_complex.h"

#include "filters/base/error.h"
#include "filters/geometry/representatives.h"

#include <utility>

namespace scan
{

namespace
{

DelaunayComplex whole(DelaunayComplex complex, Execution& execution)
{
  if (!isWhole(complex, execution))
  {
    throw Error(ErrorCode::badInput, "the complex is damaged; wrap the points again");
  }
  return complex;
}

} // namespace

ScanComplex::ScanComplex(std::span<const Vec3> points, Execution& execution)
  : Delaunay(buildDelaunayComplex(points, execution))
  , Flow(Delaunay, execution)
  , TheBasins(findBasins(Flow, execution))
{
}

ScanComplex::ScanComplex(DelaunayComplex complex, Execution& execution)
  : Delaunay(whole(std::move(complex), execution))
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
  // measured: to look at all of them once takes as long as to edit this part of them
  constexpr std::int64_t kPartOfAPass = 256;
  constexpr std::int64_t kPartOfTheGraph = 2; // and to make the graph, this part
  const std::int64_t all = this->Delaunay.tetCount();
  if (!kept.followsFlow() || kPartOfAPass * tets <= all || all > Representatives::kMostTets)
  {
    return nullptr;
  }
  {
    const std::scoped_lock lock(this->Guard);
    const std::int64_t edited = this->EditedOneByOne + tets;
    if (!this->TheGraph && kPartOfTheGraph * edited < all)
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
  if (this->Delaunay.tetCount() <= Representatives::kMostTets)
  {
    this->graph(execution);
  }
}

} // namespace scan
