// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "readers/cyberware_header.h"
#include "readers/sgi_image.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scan
{

struct CyberwareOptions
{
  bool mesh = false; ///< triangles across the range grid; otherwise points only
};

/// A Cyberware range map: the points and where in the grid each was measured.
struct CyberwareScan
{
  Model model;                      ///< millimetres
  std::vector<std::uint32_t> cells; ///< per point: longitude * latitudes + latitude
  std::uint32_t latitudes = 0;      ///< of the whole grid
  std::uint32_t longitudes = 0;
};

/// Reads a Cyberware Echo range map with a portable or an older binary header; as points, longitude
/// after longitude.
///
/// Voids and samples outside the header's window are left out, in a cylindrical map also radii
/// below zero, with a note. A cylindrical map turns about the y axis from -z towards +x (towards -x
/// when it is marked as right-handed); y is 0 at the middle latitude. In a Cartesian map x runs
/// along the longitudes, y along the latitudes, both 0 at the middle of the grid, and z is the
/// sample; the halves of a bilateral map lie over each other, with a note. SCALE and RPROP are
/// settings of viewers and do not change the coordinates. Samples have the byte order of a binary
/// header, else the high byte first; bytes behind the last sample are ignored.
/// Model::millimetresPerUnit is 1.
///
/// With CyberwareOptions::mesh, each cell of the grid with four points becomes two triangles,
/// however long its edges are. The last longitude meets the first in a cylindrical map whose window
/// has all longitudes and whose steps add up to a full turn. Triangles face away from the axis, in
/// the other maps towards +z; the other way for a map marked as inside out. The halves of a
/// bilateral map are not joined.
///
/// Throws Error parse for a malformed header, for fewer samples than it announces and for a map
/// without any valid sample. Phase "read".
CyberwareScan parseCyberwareScan(std::span<const char> bytes, std::string_view name,
  const CyberwareOptions& options, Execution& execution);

/// The model of parseCyberwareScan.
Model parseCyberware(std::span<const char> bytes, std::string_view name,
  const CyberwareOptions& options, Execution& execution);

/// The points of parseCyberwareScan.
Model parseCyberware(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Gives each point the colour that the image, the file NAME.color beside the scan, has at its
/// place in the grid.
///
/// Images of another size than the grid are sampled at the nearest pixel. The longer side of the
/// image is taken for the longer side of the grid; where that decides nothing, a row of the image
/// is a longitude, as in the scan itself. Throws Error badInput for an image without pixels.
void addCyberwareColors(CyberwareScan& scan, const SgiImage& image);

} // namespace scan
