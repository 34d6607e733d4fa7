// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/basins.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// A room that appears behind a door of radius sqrt(birth) and is filled at sqrt(death), the
/// circumradius of its sink; squared radii, birth < death.
struct PersistencePair
{
  Facet triangle;
  Index sink;
  double birth;
  double death;
};

/// The persistence pairs of dimension two of the radius function with birth < death, most
/// persistent (death / birth) first: one Kruskal pass over the critical triangles in decreasing
/// radius joins basins; at each join the smaller room dies. Gradient pairs need no pass of their
/// own: they never join two rooms.
std::vector<PersistencePair> voidPersistence(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution);

/// Inside or outside for every basin, the start of the automatic wrap: rooms with death / birth
/// radius above 1.1 and the outside seed a watershed; the most persistent room is inside, others
/// start like the room they open to and flip while that brings more points onto the surface.
/// Reports phase "rooms". Cohen-Steiner, Lieutier, Vuillamy, "Lexicographic optimal homologous
/// chains and applications to point cloud triangulations" (2020).
std::vector<std::uint8_t> persistentRooms(const FlowComplex& flow, const Basins& basins,
  const std::vector<Wall>& walls, Execution& execution);

} // namespace scan
