// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "writers/output_file.h"

namespace scan
{

/// What a triangle becomes in IGES, which has no mesh that every program reads.
enum class IgesEntities
{
  faces,     ///< a bounded plane each: 108 form 1, its border 106 form 12
  solid,     ///< faces that know their neighbours, of closed bodies: 186
  nurbs,     ///< a bilinear patch each, one side of which is a point: 128
  wireframe, ///< a closed polyline each: 106 form 12
  points     ///< none: the points of the model, used or not, and no curves: 116
};

struct IgesOptions
{
  IgesEntities entities = IgesEntities::faces;
};

/// Writes a model as IGES 5.3 (ANSI US PRO/IPO-100-1996) with every digit of its coordinates; the
/// caller commits the file. The unit is that of the model, millimetres when it does not say or when
/// IGES has no name for it; only then the coordinates are converted. Curves
/// become polylines: 106 form 12. Colours and normals are not written. The points of a scan become
/// 116 whatever the option; of other models, points that nothing uses are left out. The same model
/// gives the same bytes. Phase "write".
///
/// A solid is a 186 for each outermost shell, in the order of their first triangles. A shell that
/// faces inwards is a void of the smallest body around it; where there is none it is turned to face
/// outwards.
///
/// Files are large, 530 to 2100 bytes a triangle, and each triangle is a surface to the program
/// that reads them: above 50,000 triangles most struggle. Decimate first.
///
/// Throws Error badInput for an empty model, a coordinate that is not finite, for faces or a solid
/// a triangle without area, for a solid a surface that is not closed, oriented and manifold. Throws
/// Error limit where a section needs more than 9,999,999 lines: about 800,000 triangles as a
/// solid, 1.5 million as faces, 1.4 million as nurbs, 2 million as wireframe, 4,999,999 points.
void writeIges(
  const Model& model, const IgesOptions& options, OutputFile& file, Execution& execution);

/// The resolution that writeIges() declares, in units of the model: readers take what is smaller
/// for nothing, so that no triangle should be lower.
double igesResolution(const Model& model);

} // namespace scan
