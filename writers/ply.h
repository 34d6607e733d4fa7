// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/encoding.h"
#include "writers/output_file.h"

namespace scan
{

struct PlyOptions
{
  /// Binary is little endian.
  Encoding encoding = Encoding::binary;
};

/// Writes points and triangles as PLY, without loss; the caller commits the file.
///
/// Coordinates, and normals as "nx", "ny", "nz", are declared "float" when float32 holds all of
/// them exactly, else "double"; a file never mixes both. Colours are "uchar red", "green", "blue".
/// Triangles are "list uchar int", "uint" beyond 2^31 points; a scan has no element "face". The
/// same model gives the same bytes.
///
/// Throws Error badInput without points. Phase "write".
void writePly(
  const Model& model, const PlyOptions& options, OutputFile& file, Execution& execution);

} // namespace scan
