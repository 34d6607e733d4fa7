// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "writers/encoding.h"
#include "writers/output_file.h"

namespace scan
{

struct StlOptions
{
  /// Binary holds coordinates as float32, about 7 digits; ascii holds every digit of the model.
  Encoding encoding = Encoding::binary;
};

/// Writes the triangles as STL; the caller commits the file. Normals are computed, 0 0 0 for a
/// triangle without area. The same mesh gives the same bytes.
///
/// Throws Error badInput without triangles; Error limit for 2^32 - 1 triangles and for
/// coordinates beyond float32, in binary. Phase "write".
void writeStl(
  const TriMesh& mesh, const StlOptions& options, OutputFile& file, Execution& execution);

} // namespace scan
