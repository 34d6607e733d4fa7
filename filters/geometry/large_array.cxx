// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/large_array.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace scan
{
namespace
{

constexpr std::size_t kPage = std::size_t{ 2 } << 20;
constexpr std::size_t kMuch = 2 * kPage; // what is lost at its end counts for little

} // namespace

void* allocateLarge(std::size_t bytes)
{
  if (bytes < kMuch)
  {
    return ::operator new(bytes);
  }
  void* const memory = ::operator new (bytes, std::align_val_t{ kPage });
#ifdef __linux__
  madvise(memory, bytes - bytes % kPage, MADV_HUGEPAGE); // that may be refused
#endif
  return memory;
}

void freeLarge(void* memory, std::size_t bytes) noexcept
{
  if (bytes < kMuch)
  {
    ::operator delete(memory);
  }
  else
  {
    ::operator delete (memory, std::align_val_t{ kPage });
  }
}

} // namespace scan
