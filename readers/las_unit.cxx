// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/las_unit.h"

#include "readers/text_scanner.h"

#include <cmath>
#include <cstdint>
#include <cstring>

namespace scan
{
namespace
{

constexpr std::uint16_t kProjectedUnitKey = 3076;
constexpr std::uint16_t kVerticalUnitKey = 4099;
constexpr double kMillimetresPerMetre = 1000.0;
constexpr double kLargestUnit = 1e6; // metres

/// Millimetres in a unit of the EPSG list; 0 when it is not one of length or not known.
double epsgUnit(std::uint16_t code)
{
  switch (code)
  {
    case 9001:
      return kMillimetresPerMetre;
    case 9002: // international foot
      return 304.8;
    case 9003: // US survey foot
      return 1200.0 / 3937.0 * kMillimetresPerMetre;
    default:
      return 0.0;
  }
}

/// The number behind the name in UNIT["name", number, ...]; `at` is behind the bracket.
double unitNumber(std::string_view text, std::size_t at)
{
  const std::size_t name = text.find('"', at);
  const std::size_t nameEnd = name == text.npos ? text.npos : text.find('"', name + 1);
  const std::size_t comma = nameEnd == text.npos ? text.npos : text.find(',', nameEnd);
  if (comma == text.npos)
  {
    return 0.0;
  }
  const char* const end = text.data() + text.size();
  double metres = 0.0;
  const char* const number = skipBlanks(text.data() + comma + 1, end);
  const bool isNumber = parseNumber(number, end, metres) != nullptr;
  return isNumber && metres > 0.0 && metres < kLargestUnit ? metres * kMillimetresPerMetre : 0.0;
}

/// The unit that stands directly in a system, "PROJCS[" or another; 0 when there is none.
double systemUnit(std::string_view text, std::string_view system)
{
  const std::size_t start = text.find(system);
  int depth = 0;
  bool isQuoted = false;
  for (std::size_t at = start; at < text.size(); ++at)
  {
    const char c = text[at];
    isQuoted = isQuoted != (c == '"');
    if (isQuoted)
    {
      continue;
    }
    if (depth == 1 && text.substr(at).starts_with("UNIT["))
    {
      return unitNumber(text, at);
    }
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ']' && depth == 0)
    {
      break;
    }
  }
  return 0.0;
}

} // namespace

double geoKeyUnit(std::span<const char> directory)
{
  constexpr std::size_t kEntry = 8; // key, place, count, value
  double unit = 0.0;
  double vertical = 0.0;
  for (std::size_t at = kEntry; at + kEntry <= directory.size(); at += kEntry)
  {
    std::uint16_t entry[4];
    std::memcpy(entry, directory.data() + at, kEntry);
    const auto& [key, place, count, value] = entry;
    if (place == 0 && key == kProjectedUnitKey)
    {
      unit = epsgUnit(value);
    }
    else if (place == 0 && key == kVerticalUnitKey)
    {
      vertical = epsgUnit(value);
    }
  }
  return vertical == 0.0 || vertical == unit ? unit : 0.0;
}

double wellKnownTextUnit(std::string_view text)
{
  const double unit = systemUnit(text, "PROJCS[");
  const double vertical = systemUnit(text, "VERT_CS[");
  return vertical == 0.0 || vertical == unit ? unit : 0.0;
}

} // namespace scan
