// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the objects that a 3MF file (3D Manufacturing Format) builds, joined into one model.
///
/// Every item of the build is placed by its transform, with the components it consists of, which
/// may lie in other parts of the file (production extension); an object that is built several times
/// comes as often. A file that builds nothing gives all its meshes. Mirroring transforms turn the
/// triangles over. millimetresPerUnit comes from the unit of the file. Materials, colours, beams,
/// slices and whatever other extensions say are not used.
///
/// Throws Error parse, with part and line where there is one, for a damaged or truncated archive,
/// encrypted parts, malformed XML, corners without a vertex, missing objects, objects that contain
/// themselves, coordinates that are not finite or exceed 1e50, a file without a mesh, and for files
/// that unpack to more than 200 times their size or build so many copies that they take more than
/// 1 GB and 12 times the file. Error limit for 2^32 - 1 points. Phase "read".
Model parseThreemf(std::span<const char> bytes, std::string_view name, Execution& execution);

/// The same for models that may take so many bytes, or 12 times those of the file and 64 MB.
Model parseThreemfUpTo(
  double largest, std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be of this format: a zip archive whose first part is
/// one that 3MF has.
bool looksLikeThreemf(std::span<const char> head);

} // namespace scan
