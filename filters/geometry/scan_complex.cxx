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
    this->TheSizes = std::make_unique<const SizeScale>(blocks);
  }
  return *this->TheSizes;
}

} // namespace scan
