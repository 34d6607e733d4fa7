// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes points, triangles and curves as VRML97 (ISO/IEC 14772-1, also named VRML 2.0); the caller
/// commits the file. Triangles are an IndexedFaceSet, visible from both sides; curves are an
/// IndexedLineSet, in a Shape of its own beside triangles; a scan is a PointSet.
/// Colours are written per point, normals are not. Every digit of the coordinates is written,
/// though programs read them as float32, about 7 digits. The same model gives the same bytes.
///
/// Throws Error badInput without points; Error limit for coordinates beyond float32 and for more
/// than 2^31 points. Phase "write".
void writeVrml97(const Model& model, OutputFile& file, Execution& execution);

} // namespace scan
