// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <vector>

namespace scan
{

/// Sorts parts at the same time and merges them, two by two. `isBefore` must tell any two items
/// apart: then the result does not depend on the number of threads.
template <class Item, class Before>
void sortInParallel(std::vector<Item>& items, Execution& execution, Before&& isBefore)
{
  constexpr std::size_t kWorthAThread = 1 << 14;
  const std::size_t parts =
    items.size() < kWorthAThread ? 1 : std::bit_ceil(std::size_t{ execution.threads() });
  const auto from = [&](std::size_t part)
  { return items.begin() + static_cast<std::ptrdiff_t>(items.size() * part / parts); };
  execution.parallelFor(parts, 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t part = begin; part < end; ++part)
      {
        std::sort(from(part), from(part + 1), isBefore);
      }
    });
  for (std::size_t width = 1; width < parts; width *= 2)
  {
    execution.parallelFor(parts / (2 * width), 1,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t pair = begin; pair < end; ++pair)
        {
          const std::size_t first = 2 * width * pair;
          std::inplace_merge(from(first), from(first + width), from(first + 2 * width), isBefore);
        }
      });
  }
}

} // namespace scan
