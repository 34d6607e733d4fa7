// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/blocks.h"
#include "filters/geometry/wrap_model.h"

#include <compare>
#include <cstdint>

namespace scan
{

/// A block of a wrap: a volume block by its basin, or a sheet block by the canonical name of its
/// critical triangle. In a solid model basins that leave the hull are blocks, too.
struct BlockName
{
  bool isSheet = false;
  Index name = kNone;

  friend auto operator<=>(const BlockName&, const BlockName&) = default;
};

/// The block as one number, for people and files: a volume block its own, a sheet -1 - triangle.
inline std::int64_t numberOf(const BlockName& block)
{
  return block.isSheet ? -1 - std::int64_t{ block.name } : std::int64_t{ block.name };
}

/// The block of that number.
/// @throws Error{badParameter} when there is none
BlockName blockOfNumber(const Blocks& blocks, std::int64_t number);

/// The block that a triangle of the surface belongs to: of a boundary triangle the block of the
/// kept tetrahedron behind it, of a sheet triangle the block that it flows to. Where that block is
/// gone and the tetrahedron or triangle stayed, the kept block that it stayed for.
BlockName blockBehind(const WrapModel& model, const Blocks& blocks, Facet triangle);

/// The same, and the tetrahedron where the way to the block began or, where that block is gone,
/// came to its end: what an edit left over and nothing holds. kNone for a sheet block.
struct Keeper
{
  BlockName block;
  Index tet = kNone;
};
Keeper keeperBehind(const WrapModel& model, const Blocks& blocks, Facet triangle);

/// The removed block that a point means: the volume block around it, else the sheet block removed
/// since the start that is nearest to it. Empty names (kNone) when there is none.
BlockName removedBlockAt(const WrapModel& model, const Vec3& point, Execution& execution);

/// The removed volume block before a triangle of the surface, on the side where nothing is kept; a
/// sheet means its more roomy side. An empty name when that is the outside.
BlockName removedBlockBefore(const WrapModel& model, const Blocks& blocks, Facet triangle);

/// Whether the block has a critical simplex that is kept.
bool isKept(const WrapComplex& complex, const Blocks& blocks, const BlockName& block);

/// The size of a block: the radius of its critical simplex, infinite for what leaves the hull.
double sizeOf(const Blocks& blocks, const BlockName& block);

} // namespace scan
