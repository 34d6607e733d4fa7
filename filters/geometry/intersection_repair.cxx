// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/intersection_repair.h"

#include "filters/geometry/intersecting.h"
#include "filters/geometry/local_relaxation.h"
#include "filters/geometry/patch_refill.h"
#include "filters/geometry/shell_union.h"

#include <cmath>
#include <optional>

namespace scan
{
namespace
{

constexpr std::size_t kMostRings = 6;

/// Exchanges patches that grow until nothing intersects; keeps the state with the fewest bad ones.
Exchange refillGrowing(MendSurface& surface, double maxDeviation, Execution& execution)
{
  std::vector<Index> bad = trianglesOf(activeIntersections(surface, execution));
  std::optional<MendSurface> best;
  std::size_t fewest = bad.size();
  Exchange sum;
  Exchange atBest;
  for (std::size_t rings = 0; rings <= kMostRings && !bad.empty(); ++rings)
  {
    if (!best)
    {
      best = surface;
    }
    const Exchange exchange = refillPatches(
      surface, withRings(surface.mesh, bad, rings, execution), maxDeviation, execution);
    sum.removed += exchange.removed;
    sum.added += exchange.added;
    bad = trianglesOf(activeIntersections(surface, execution));
    if (bad.size() < fewest)
    {
      fewest = bad.size();
      best = surface;
      atBest = sum;
    }
  }
  if (!bad.empty() && best)
  {
    surface = *best;
  }
  return bad.empty() ? sum : atBest;
}

} // namespace

IntersectionRepair repairIntersections(
  MendSurface& surface, double maxDeviation, Execution& execution)
{
  IntersectionRepair repair;
  const auto isDone = [&] { return activeIntersections(surface, execution).empty(); };
  if (isDone())
  {
    return repair;
  }
  repair.pulled = pullApart(surface, maxDeviation, execution);
  if (std::isinf(maxDeviation))
  {
    const ShellUnions unions = uniteShells(surface, execution);
    repair.unions = unions.unions;
    repair.removed = unions.exchange.removed;
    repair.added = unions.exchange.added;
  }
  repair.relaxed = relaxLocally(surface, maxDeviation, execution);
  const Exchange refilled = refillGrowing(surface, maxDeviation, execution);
  repair.removed += refilled.removed;
  repair.added += refilled.added;
  return repair;
}

} // namespace scan
