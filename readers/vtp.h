// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/source.h"

#include <span>

namespace scan
{

/// Whether a file that starts with `head` can be VTK XML PolyData (.vtp): its first element is
/// VTKFile of that type.
bool looksLikeVtp(std::span<const char> head);

/// Holds the counts that a .vtp file announces against its size, and looks for its end.
///
/// Throws Error parse when there is more announced than even compressed data can hold, or when the
/// end tag is missing.
void checkVtp(const Source& source);

} // namespace scan
