// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <algorithm>
#include <vector>

namespace scan
{

/// Calls find(i, found) for i in [0, count) in parallel; it appends to `found`. Returns all found
/// items in the order of i, whatever the number of threads.
template <class Item, class Find>
std::vector<Item> collect(Index count, Execution& execution, Find&& find)
{
  constexpr std::size_t kChunk = 1 << 14;
  std::vector<std::vector<Item>> found((count + kChunk - 1) / kChunk);
  execution.parallelFor(found.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        const std::size_t last = std::min<std::size_t>(kChunk * (chunk + 1), count);
        for (std::size_t i = kChunk * chunk; i < last; ++i)
        {
          find(static_cast<Index>(i), found[chunk]);
        }
      }
    });
  std::size_t total = 0;
  for (const auto& chunk : found)
  {
    total += chunk.size();
  }
  std::vector<Item> items;
  items.reserve(total);
  for (auto& chunk : found)
  {
    items.insert(items.end(), chunk.begin(), chunk.end());
    std::vector<Item>().swap(chunk);
  }
  return items;
}

} // namespace scan
