// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <vector>

namespace scan
{

/// Leaves elements of trivial types uninitialised on resize: hundreds of megabytes that are written
/// next, perhaps by several threads, are not cleared first.
template <class T>
struct UninitializedAllocator : std::allocator<T>
{
  template <class U>
  struct rebind
  {
    using other = UninitializedAllocator<U>;
  };

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
};

/// A vector whose resize(n) does not touch the memory.
template <class T>
using LargeArray = std::vector<T, UninitializedAllocator<T>>;

} // namespace scan
