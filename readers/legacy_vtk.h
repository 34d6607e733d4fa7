// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the points, faces and lines of a legacy VTK file, .vtk, ascii or binary, versions 1
/// to 5.1, whose data set is POLYDATA.
///
/// Polygons and strips become triangles, lines curves; vertices are skipped. COLOR_SCALARS and
/// NORMALS of the points become colours and normals, the field MillimetresPerUnit the unit; other
/// attributes are skipped, with all that follows where their kind is not known.
///
/// Throws Error parse, with the line or byte, for a file that is malformed or cut off, another
/// kind of data set, cells that name a point that is not there, a file without points and
/// coordinates that are not finite or exceed 1e50; Error limit for 2^32 - 1 points. Phase "read".
Model parseLegacyVtk(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` is a legacy VTK file, of any kind of data.
bool looksLikeLegacyVtk(std::span<const char> head);

} // namespace scan
