// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sys/mman.h>

namespace scan
{

/// Reserves memory and asks the system for large pages there: what is written for the first time
/// then costs a third, as the system is called for every two megabytes instead of every four
/// thousand bytes. A hint; nothing depends on it.
template <class T, class Allocator>
void reserveLarge(std::vector<T, Allocator>& array, std::size_t size)
{
  array.reserve(size);
#ifdef MADV_HUGEPAGE
  constexpr std::uintptr_t kPage = std::uintptr_t{ 1 } << 21U;
  const auto begin = (reinterpret_cast<std::uintptr_t>(array.data()) + kPage - 1) / kPage * kPage;
  const auto end = reinterpret_cast<std::uintptr_t>(array.data() + size) / kPage * kPage;
  if (array.data() != nullptr && begin < end)
  {
    ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
#endif
}

} // namespace scan
