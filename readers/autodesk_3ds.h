// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads the meshes of an Autodesk 3D Studio file (.3ds), joined into one in the order of the file.
///
/// The vertices of such a file are in world coordinates, so the local axes and the key frames are
/// not used; neither are materials, mapping, lights and cameras. The format has no unit. A mesh
/// without faces is a scan. What follows the main chunk is not looked at.
///
/// Throws Error parse, with the byte, for a chunk that does not fit the one around it, for counts
/// that do not fit their chunk, for corners without a vertex, for a file without any vertex and for
/// coordinates that are not finite or exceed 1e50; Error limit for 2^32 - 1 points. Phase "read".
Model parseAutodesk3ds(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be of this format.
bool looksLikeAutodesk3ds(std::span<const char> head);

} // namespace scan
