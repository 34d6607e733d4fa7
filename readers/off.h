// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads an Object File Format mesh (Geomview's OFF, text form): OFF, NOFF, COFF, CNOFF, STOFF and
/// their combinations.
///
/// The counts of vertices, faces and, if at all, edges follow the keyword, on its line or a later
/// one; OFF itself may be missing. Then comes one vertex a line: x y z, with N a normal, with C a
/// colour, which is 0 to 1 when no channel of the file exceeds 1 and 0 to 255 otherwise; with both,
/// the normal is the one that has length 1, and the first if both have. Transparency and texture
/// coordinates are skipped. Then one face a line: the number of its corners, the corners counted
/// from 0, perhaps a colour, which is skipped. Polygons are triangulated
/// (filters/geometry/polygon.h); faces of fewer than three corners are left out. Blank lines and
/// comments (#) may stand anywhere. No faces: a scan. No unit.
///
/// Throws Error parse, with the line, for a malformed line, for counts that the lines do not match,
/// for corners without a vertex, for a file without a vertex, for the binary form and for the
/// dimensions 4OFF and nOFF, for coordinates that are not finite or exceed 1e50; Error limit for
/// 2^32 - 1 points. Phase "read".
Model parseOff(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` is an OFF file: its first word that is no comment is the
/// keyword.
bool looksLikeOff(std::span<const char> head);

} // namespace scan
