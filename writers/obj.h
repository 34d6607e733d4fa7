// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes points and triangles as Wavefront OBJ, without loss; the caller commits the file. A scan
/// becomes a file of vertices only. The same mesh gives the same bytes. Phase "write".
void writeObj(const TriMesh& mesh, OutputFile& file, Execution& execution);

} // namespace scan
