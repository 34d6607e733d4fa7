// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

// Exact signs for the flow relation, for the cases that floating point cannot decide. Points on
// the sphere itself are decided as if each point p had weight -eps(p), the lexicographically
// largest (x, then y, then z) having the largest eps, each next one infinitely smaller: the same
// perturbation as in the Delaunay complex, so the answer is never "on".

/// Is s strictly inside the smallest sphere through a, b, c? The points are not collinear.
bool insideSmallestSphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& s);

/// Is s strictly inside the sphere that has the segment a, b as diameter?
bool insideDiametralSphere(const Vec3& a, const Vec3& b, const Vec3& s);

} // namespace scan
