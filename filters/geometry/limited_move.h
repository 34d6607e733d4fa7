// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// `to`, or where the way there is `limit` from its beginning: never farther, whatever the
/// rounding.
Vec3 limitedMove(const Vec3& from, const Vec3& to, double limit);

} // namespace scan
