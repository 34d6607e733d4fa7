// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace scan
{

/// Reads what other threads may write meanwhile: the value before or after.
template <class Value>
Value loadRelaxed(const Value& place)
{
  return std::atomic_ref(const_cast<Value&>(place)).load(std::memory_order_relaxed);
}

template <class Value>
void storeRelaxed(Value& place, Value value)
{
  std::atomic_ref(place).store(value, std::memory_order_relaxed);
}

} // namespace scan
