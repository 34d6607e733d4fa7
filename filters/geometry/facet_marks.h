// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"
#include "filters/geometry/relaxed.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace scan
{

/// Two bits a facet, 0 at first. Several threads may set and read them; each facet is set to one
/// value only, but perhaps more than once.
class FacetMarks
{
public:
  explicit FacetMarks(Index tetCount)
    : OfTet(tetCount, 0)
  {
  }

  unsigned at(Facet facet) const
  {
    return loadRelaxed(this->OfTet[facet / 4]) >> (2 * (facet % 4)) & 3U;
  }

  void set(Facet facet, unsigned mark)
  {
    std::atomic_ref(this->OfTet[facet / 4])
      .fetch_or(static_cast<std::uint8_t>(mark << (2 * (facet % 4))), std::memory_order_relaxed);
  }

private:
  std::vector<std::uint8_t> OfTet;
};

} // namespace scan
