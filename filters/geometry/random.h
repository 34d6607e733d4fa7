// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace scan
{

/// SplitMix64 (Steele, Lea, Flood 2014): unlike the standard distributions, the same numbers with
/// every library.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : State(seed)
  {
  }

  std::uint64_t next()
  {
    this->State += 0x9e3779b97f4a7c15U;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(this->next() >> 11U) * 0x1p-53; }

  /// Uniform in [0, bound), exactly: numbers that would favour some are drawn again.
  /// @param bound 1 or more
  std::uint64_t below(std::uint64_t bound)
  {
    const std::uint64_t uneven = (0 - bound) % bound; // 2^64 modulo bound
    std::uint64_t drawn = this->next();
    while (drawn < uneven)
    {
      drawn = this->next();
    }
    return drawn % bound;
  }

private:
  std::uint64_t State;
};

} // namespace scan
