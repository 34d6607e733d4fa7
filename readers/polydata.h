// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace scan
{

/// Whether a file that starts with `head` can be VTK XML PolyData (.vtp): its first element is
/// VTKFile of that type.
bool looksLikeVtp(std::span<const char> head);

/// Whether a file that starts with `head` is a legacy VTK file (.vtk), of any kind of data.
bool looksLikeLegacyVtk(std::span<const char> head);

} // namespace scan
