// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/limited_move.h"

#include "filters/geometry/local_plane.h"

#include <algorithm>

namespace scan
{

Vec3 limitedMove(const Vec3& from, const Vec3& to, double limit)
{
  const Vec3 way = to - from;
  const double wanted = length(way);
  if (wanted <= limit)
  {
    return to;
  }
  double share = limit / wanted;
  for (int i = 0; i < 8; ++i) // rounding may exceed it, far from the origin by much
  {
    const Vec3 held = from + way * share;
    const double excess = length(held - from) - limit;
    if (excess <= 0.0)
    {
      return held;
    }
    share = std::max(0.0, share - std::max(2.0 * excess / wanted, 0x1p-50));
  }
  return from;
}

} // namespace scan
