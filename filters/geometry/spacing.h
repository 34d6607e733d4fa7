// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <span>

namespace scan
{

/// Mean distance from a point to its nearest other point: the length that "3x" means three of.
///
/// Duplicates count once; points that are not finite are ignored, and so are stray points, whose
/// distance exceeds eight times the median. From 16,384 points on a sample of that size stands for
/// all, which is within about one percent. The result does not depend on the order of the points.
/// Zero for fewer than two distinct points. About 0.4 s and 25 bytes a point for a million.
double meanSpacing(std::span<const Vec3> points);

} // namespace scan
