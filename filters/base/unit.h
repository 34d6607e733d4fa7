// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

namespace scan
{

/// A unit of length that people choose.
struct Unit
{
  std::string_view symbol; ///< as in --unit=mm
  std::string_view name;
  double millimetres;
};

inline constexpr std::array<Unit, 7> kUnits = { { { "um", "micrometre", 1e-3 },
  { "mm", "millimetre", 1.0 }, { "cm", "centimetre", 10.0 }, { "m", "metre", 1000.0 },
  { "km", "kilometre", 1e6 }, { "in", "inch", 25.4 }, { "ft", "foot", 304.8 } } };

/// Whether two units, in millimetres, are the same but for rounding.
inline bool isSameUnit(double a, double b)
{
  return std::abs(a - b) <= 1e-9 * std::abs(b);
}

/// "millimetre", or "304.8006 mm" for a unit without a name.
inline std::string nameOfUnit(double millimetres)
{
  for (const Unit& unit : kUnits)
  {
    if (isSameUnit(millimetres, unit.millimetres))
    {
      return std::string(unit.name);
    }
  }
  std::array<char, 32> digits;
  char* const end = std::to_chars(digits.begin(), digits.end(), millimetres).ptr;
  return std::string(digits.data(), end) + " mm";
}

} // namespace scan
