// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/fill_holes.h"
#include "filters/geometry/hole_patch.h"

#include <span>
#include <vector>

namespace scan
{

/// All boundary loops, with the fate of those that are left, and what is to be spanned.
struct HoleChoice
{
  std::vector<Hole> holes;
  std::vector<HolePolygon> polygons; ///< per hole; without points where it is left
};

/// Which holes fillHoles() is asked for. Throws as it does.
HoleChoice chooseHoles(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const FillHolesOptions& options, Execution& execution);

} // namespace scan
