// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// The two sides of a sheet, 0 or 1 for every basin and every room of the outside: a second start
/// of the automatic wrap, for scans of open surfaces, whose both sides may reach the outside.
///
/// Two basins whose common triangles are small against both want opposite labels: there is a
/// surface between them; basins joined by a wide door want the same. The wish of a pair is
///
///   w = sum over the common triangles of area * (min(3, log(smaller size / radius)) - 1)
///
/// Pairs are granted by decreasing |w| unless that contradicts what was granted before; then single
/// basins flip while the granted weight grows.
/// @param walls hull walls have the number of basins + that of the room of the outside as `b`
/// Reports phase "sides". n log n in the number of walls; deterministic.
std::vector<std::uint8_t> signedRooms(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Index roomCount, Execution& execution);

} // namespace scan
