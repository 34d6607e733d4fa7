// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace scan
{

/// The coefficients c of the polynomial of degree `nodes` - 1 that is f at as many Chebyshev nodes:
/// the sum of c[m] T_m(x) for x from -1 to 1. Takes nodes^2 steps.
template <class Function>
std::vector<double> chebyshevSeries(std::size_t nodes, Function&& f)
{
  const double share = std::numbers::pi / static_cast<double>(nodes);
  std::vector<double> series(nodes, 0.0);
  for (std::size_t node = 0; node < nodes; ++node)
  {
    const double angle = share * (static_cast<double>(node) + 0.5);
    const double value = f(std::cos(angle)) / static_cast<double>(nodes);
    for (std::size_t m = 0; m < nodes; ++m)
    {
      series[m] += (m == 0 ? 1.0 : 2.0) * value * std::cos(static_cast<double>(m) * angle);
    }
  }
  return series;
}

/// Drops coefficients from the end while the sum of their sizes stays within `tolerance`: no value
/// changes by more.
inline void truncate(std::vector<double>& series, double tolerance)
{
  double dropped = 0.0;
  while (!series.empty() && dropped + std::abs(series.back()) <= tolerance)
  {
    dropped += std::abs(series.back());
    series.pop_back();
  }
}

} // namespace scan
