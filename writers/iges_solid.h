// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/iges_file.h"
#include "writers/output_file.h"

namespace scan
{

/// Writes the bodies that a mesh bounds as an IGES file of manifold solids: 186 with shells 514,
/// faces 510, loops 508, edges 504, points 502, planes 190, lines 110; and the curves of the model.
///
/// Throws Error badInput unless the mesh is closed, oriented and manifold and every triangle has
/// area; Error limit beyond about 800,000 triangles. Phase "write".
void writeIgesSolid(
  const Model& model, const IgesHeader& header, OutputFile& file, Execution& execution);

} // namespace scan
