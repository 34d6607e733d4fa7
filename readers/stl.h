// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <span>
#include <string_view>

namespace scan
{

/// Reads an STL file, binary or ascii, and welds equal corners into shared vertices.
///
/// Binary when the size is exactly 84 + 50 n, whatever the header says; else ascii when the text
/// starts with "solid" and goes on as text; else binary, where bytes behind the last facet are
/// ignored. A binary header that announces no facet has as many as follow. Several ascii solids
/// become one mesh; stored normals are ignored. Ascii text that ends without "endsolid" is read,
/// with a note.
///
/// Throws Error parse, with line or byte, for a malformed or truncated file, for one without facets
/// and for coordinates that are not finite or exceed 1e50; Error limit for 2^32 - 1 vertices. Phase
/// "read".
Model parseStl(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be an STL file: for the binary form, facets of which
/// all coordinates are below 1e15 and most normals have the length 0 or 1 or are not a number.
bool looksLikeStl(std::span<const char> head);

} // namespace scan
