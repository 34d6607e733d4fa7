// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// How a DXF file holds triangles.
enum class DxfFaces
{
  face3d,  ///< a 3DFACE each, which every program reads
  polyface ///< POLYLINE meshes with shared points, smaller; some programs do not read them
};

struct DxfOptions
{
  DxfFaces faces = DxfFaces::face3d;
};

/// Writes triangles and curves as AutoCAD DXF release 12, in ascii, without loss; the caller
/// commits the file. A curve is a POLYLINE, a scan one POINT a point. A polyface mesh holds at most
/// 32,767 points and as many triangles; a larger surface becomes several, which repeat the points
/// between them. Other points that nothing uses, colours and normals are not written. The same
/// model gives the same bytes.
///
/// Throws Error badInput without points. Phase "write".
void writeDxf(
  const Model& model, const DxfOptions& options, OutputFile& file, Execution& execution);

} // namespace scan
