// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <vector>

namespace scan
{

/// Turns triangles so that any two at an edge of exactly two agree, wherever that is possible: a
/// one-sided piece keeps a seam where they do not. In each piece that hangs together by such edges
/// the first triangle stays as it is. Linear time.
/// @param pointCount larger than every index in `triangles`
void orientConsistently(std::vector<Triangle>& triangles, std::size_t pointCount);

} // namespace scan
