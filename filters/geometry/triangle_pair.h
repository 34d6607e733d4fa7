// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>

namespace scan
{

/// Exactly: do two triangles meet in more than the corners or the edge that they share by number?
/// Neither is flat.
bool meetBeyondShared(const TriMesh& mesh, const Triangle& first, const Triangle& second);

} // namespace scan
