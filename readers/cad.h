// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// How finely the surfaces of a CAD file become triangles.
struct CadOptions
{
  /// Largest distance wanted between the triangles and the surface, in millimetres; 0: the relative
  /// one counts. Held for samples of all triangles.
  double deflection = 0.0;

  /// The same as a fraction of the diagonal of the bounding box, more than 0.
  double relativeDeflection = 1e-3;

  /// Largest turn of the surface along an edge of a triangle, in radians, more than 0.
  double angle = 0.35;
};

/// Reads the faces of a STEP file (ISO 10303-21: AP203, AP214 and the boundary models of AP242) as
/// triangles. Curves, points and drawings are skipped; parts of an assembly are in their places.
///
/// Faces that share an edge share its points, so that a solid becomes a closed mesh; solids share
/// none with each other. Triangles of solids and closed shells face outwards. Coordinates are
/// millimetres whatever the unit of the file, and Model::millimetresPerUnit says so. The same file
/// gives the same mesh.
///
/// The work is done by OpenCASCADE in a process of its own, which a cancel ends within 0.1 s.
///
/// Throws Error parse for a file that is malformed, cut off, without faces, or with faces that
/// cannot become triangles; Error badParameter for options out of range; Error memory. Phase
/// "read".
Model parseStep(std::span<const char> bytes, std::string_view name, const CadOptions& options,
  Execution& execution);

/// Reads the faces of an IGES file (fixed ASCII form, 5.3 and before), as parseStep() does. Faces
/// that are not part of a shell are sewn where their edges are closer than the resolution that the
/// file tells, or than 1e-5 of the diagonal if that is more; at most half the deflection.
Model parseIges(std::span<const char> bytes, std::string_view name, const CadOptions& options,
  Execution& execution);

/// Whether a file that starts with `head` can be a STEP file: "ISO-10303-21;" behind blanks.
bool looksLikeStep(std::span<const char> head);

/// Whether a file that starts with `head` can be an IGES file: a first line with the number 1
/// in columns 74 to 80 behind an S, or behind C or B, the forms that parseIges() refuses.
bool looksLikeIges(std::span<const char> head);

} // namespace scan
