// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace samples
{

/// SplitMix64 (Steele, Lea, Flood 2014): unlike the standard distributions, the same numbers with
/// every library.
class SplitMix
{
public:
  explicit SplitMix(std::uint64_t seed)
    : State(seed)
  {
  }

  /// Uniform in [0, 1).
  double unit()
  {
    this->State += 0x9e3779b97f4a7c15U;
    std::uint64_t z = this->State;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  /// Uniform in [-limit, limit).
  double jitter(double limit) { return limit * (2.0 * this->unit() - 1.0); }

  /// Mean 0, standard deviation 1, at most 6: a sum of twelve, without a library function.
  double normal()
  {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i)
    {
      sum += this->unit();
    }
    return sum;
  }

private:
  std::uint64_t State;
};

} // namespace samples
