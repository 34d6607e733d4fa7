// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/basins.h"
#include "filters/geometry/wrap_complex.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// What makes another state of the same complex of a state, a byte a tetrahedron: bytes that
/// compress to little where whole blocks were removed or filled.
///
/// Sorted by basins, which blocks consist of. Bit 4: the tetrahedron is kept in one of the states
/// only. Bits 0 to 3: its triangles (by their canonical names) differ from what to expect: a sheet
/// stays one until a tetrahedron beside it is kept, and the boundary of what is gone stays as
/// sheets.
std::vector<std::uint8_t> deltaOf(
  const WrapComplex& from, const WrapComplex& to, const Basins& basins);

/// The state that deltaOf() was made of.
/// @throws Error badInput when the bytes cannot be a delta of the state
WrapComplex applyDelta(const WrapComplex& from, std::span<const std::uint8_t> delta,
  const Basins& basins, bool followsFlow);

} // namespace scan
