// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iterator>
#include <random>
#include <string>

namespace scan::test
{

/// A number of [-1, 1] with a few digits.
inline std::string randomNumber(std::mt19937_64& random)
{
  return std::to_string(static_cast<double>(random() % 2001) / 1000.0 - 1.0);
}

/// So many, with commas between them.
inline std::string randomNumbers(std::mt19937_64& random, int count)
{
  std::string text;
  for (int i = 0; i < count; ++i)
  {
    text += (i > 0 ? ", " : "") + randomNumber(random);
  }
  return text;
}

inline std::string randomView(std::mt19937_64& random)
{
  constexpr const char* kViews[] = { "front", "back", "left", "right", "top", "bottom",
    "from(3,1,2, 0,0,0, 0,0,1)", "along(1,2,-3, 0,1,0)" };
  return kViews[random() % std::size(kViews)];
}

/// A rule of functions that look at places only.
inline std::string randomShape(std::mt19937_64& random)
{
  switch (random() % 7)
  {
    case 0:
      return "box(" + randomNumbers(random, 6) + ")";
    case 1:
      return "sphere(" + randomNumbers(random, 3) + ", 0." + std::to_string(random() % 99) + ")";
    case 2:
      return "plane(" + randomNumbers(random, 5) + ", 0.5)";
    case 3:
      return "brush(0.3, " + randomNumbers(random, 3 * (1 + static_cast<int>(random() % 3))) + ")";
    case 4:
      return "rectangle(" + randomView(random) + ", " + randomNumbers(random, 4) + ")";
    case 5:
      return "polygon(" + randomView(random) + ", " +
        randomNumbers(random, 2 * (3 + static_cast<int>(random() % 4))) + ")";
    default:
      return "depth(" + randomView(random) + ", " + randomNumbers(random, 3) + ")";
  }
}

/// A rule of operators, functions of rules and shapes, at most so deep.
inline std::string randomRule(std::mt19937_64& random, int depth)
{
  const auto part = [&] { return randomRule(random, depth - 1); };
  switch (depth > 0 ? random() % 9 : 8)
  {
    case 0:
      return "!" + part();
    case 1:
      return "(" + part() + ")";
    case 2:
      return part() + " & " + part();
    case 3:
      return part() + " + " + part();
    case 4:
      return part() + " - " + part();
    case 5:
      return "(" + part() + ") - (" + part() + ")";
    case 6:
      return "grow(" + part() + ", " + std::to_string(random() % 3) + ")";
    case 7:
      return "component(" + part() + ")";
    default:
      return randomShape(random);
  }
}

} // namespace scan::test
