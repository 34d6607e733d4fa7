// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace scan
{

/// Memory for any type, from large pages where there is much of it and the system has them: it is
/// touched first, and then found, in less than half the time. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void freeLarge(void* memory, std::size_t bytes) noexcept;

/// Leaves elements of trivial types uninitialised on resize: hundreds of megabytes that are written
/// next, perhaps by several threads, are not cleared first.
template <class T>
struct LargeAllocator
{
  using value_type = T;

  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>& /*other*/) noexcept
  {
  }

  T* allocate(std::size_t count)
  {
    if (count > static_cast<std::size_t>(-1) / sizeof(T))
    {
      throw std::bad_array_new_length();
    }
    return static_cast<T*>(allocateLarge(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept { freeLarge(memory, count * sizeof(T)); }

  template <class U>
  void construct(U* place) noexcept
  {
    ::new (static_cast<void*>(place)) U;
  }

  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  template <class U>
  bool operator==(const LargeAllocator<U>& /*other*/) const noexcept
  {
    return true;
  }
};

/// A vector whose resize(n) does not touch the memory.
template <class T>
using LargeArray = std::vector<T, LargeAllocator<T>>;

} // namespace scan
