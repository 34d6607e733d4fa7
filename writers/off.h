// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes points and triangles as Object File Format (OFF) of Geomview, without loss; the caller
/// commits the file. With colours it is COFF: red, green, blue and alpha 1, from 0.0 to 1.0, behind
/// each point. A scan becomes a file without faces. Normals are not written. The same model gives
/// the same bytes.
///
/// Throws Error badInput without points. Phase "write".
void writeOff(const Model& model, OutputFile& file, Execution& execution);

} // namespace scan
