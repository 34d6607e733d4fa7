// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// The languages that share their nodes.
enum class InventorVersion
{
  inventor, ///< Open Inventor 2.1, files *.iv
  vrml1     ///< VRML 1.0, files *.wrl
};

struct InventorOptions
{
  InventorVersion version = InventorVersion::inventor;
};

/// Writes points, triangles and curves as Open Inventor or VRML 1.0, in ascii; the caller commits
/// the file. Triangles are an IndexedFaceSet, lit from both sides; curves are an IndexedLineSet; a
/// scan is a PointSet. Colours are one
/// Material per point. Normals are not written. Every digit of the coordinates is written, though
/// programs read them as float32, about 7 digits. The same model gives the same bytes.
///
/// Throws Error badInput without points; Error limit for coordinates beyond float32 and for more
/// than 2^31 points. Phase "write".
void writeInventor(
  const Model& model, const InventorOptions& options, OutputFile& file, Execution& execution);

} // namespace scan
