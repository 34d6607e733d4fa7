// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

/// Cyberware Echo files of every kind, and the points they hold by a formula of their own.
namespace scan::test
{

inline constexpr int kCyberwareVoid = -32768;

/// A range map; the samples are longitude after longitude.
struct CyberwareMap
{
  std::string space = "CYLINDRICAL";
  int latitudes = 5;
  int longitudes = 8;
  int latitudeStep = 1559;
  int longitudeStep = 785398; // an eighth of a turn
  int shift = 5;
  bool isInsideOut = false;
  bool isRightHanded = false;
  bool hasWindow = false;
  int firstLatitude = 0;
  int lastLatitude = 4;
  int firstLongitude = 0;
  int lastLongitude = 7;
  std::vector<int> samples = std::vector<int>(40, 1000);
};

/// A map whose samples all differ, with a window and voids, also on the window's edge.
inline CyberwareMap mapWithVoids(const std::string& space)
{
  CyberwareMap map;
  map.space = space;
  map.latitudes = 6;
  map.longitudes = 9;
  map.longitudeStep = space == "CYLINDRICAL" ? 698132 : 2400;
  map.hasWindow = true;
  map.firstLatitude = 1;
  map.lastLatitude = 4;
  map.firstLongitude = 2;
  map.lastLongitude = 7;
  map.samples.clear();
  for (int i = 0; i < map.latitudes * map.longitudes; ++i)
  {
    map.samples.push_back(i % 7 == 0 ? kCyberwareVoid : 877 + 613 * i % 32767);
  }
  return map;
}

inline void appendInteger(std::string& bytes, std::int64_t value, int width, bool isBig)
{
  for (int i = 0; i < width; ++i)
  {
    const int shift = 8 * (isBig ? width - 1 - i : i);
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> shift & 0xffU);
  }
}

inline std::string cyberwareSamples(const CyberwareMap& map, bool isBig = true)
{
  std::string bytes;
  for (const int sample : map.samples)
  {
    appendInteger(bytes, sample, 2, isBig);
  }
  return bytes;
}

/// The lines ahead of DATA= in the order of Cyberware's own programs.
inline std::string cyberwareLines(const CyberwareMap& map)
{
  const auto line = [](const char* key, int value)
  { return std::string(key) + "=" + std::to_string(value) + "\n"; };
  std::string text = "Cyberware Digitizer Data\nNAME=head\nDATE=Wed Dec 31 16:00:00 1969\n";
  text += "SPACE=" + map.space + "\nCOLOR=SGI\n";
  text += map.isInsideOut ? "INSIDE_OUT=TRUE\n" : "";
  text += map.isRightHanded ? "THETA_RIGHTHAND=TRUE\n" : "";
  text += line("NLG", map.longitudes) + line("LGINCR", map.longitudeStep);
  text += map.hasWindow ? line("LGMIN", map.firstLongitude) + line("LGMAX", map.lastLongitude) : "";
  text += line("NLT", map.latitudes) + line("LTINCR", map.latitudeStep);
  text += map.hasWindow ? line("LTMIN", map.firstLatitude) + line("LTMAX", map.lastLatitude) : "";
  text += "RMIN=28096\nRMAX=124352\n" + line("RSHIFT", map.shift);
  return text + "LGSHIFT=8\nSCALE=100.00\nRPROP=250.00\nSMOOTHED=1\n";
}

inline std::string cyberwareText(const CyberwareMap& map)
{
  return cyberwareLines(map) + "DATA=\n" + cyberwareSamples(map);
}

/// A binary header of 114, 122 or 128 bytes.
inline std::string cyberwareBinary(const CyberwareMap& map, int size, bool isBig = true)
{
  std::string bytes;
  const auto put = [&](std::int64_t value, int width)
  { appendInteger(bytes, value, width, isBig); };
  const auto align = [&] { bytes.append(size == 128 ? 2 : 0, '\x5a'); };
  put(0x00a17c40, 4);
  put(size, 4);
  bytes.append("head").append(36, '\0');
  put(0, 4);
  put(3, 2);
  put(4, 2);
  put(0x0101, 2);
  put(map.latitudes, 2);
  put(map.longitudes, 2);
  put(map.shift, 2);
  put(8, 2);
  align();
  std::int64_t flags = 0x2ff; // old header, and junk in the low byte
  flags += map.space == "CYLINDRICAL" ? 0 : 0x100;
  flags += map.space == "BILATERAL" ? 0x400 : 0;
  flags += (map.isRightHanded ? 0x1000 : 0) + (map.isInsideOut ? 0x2000 : 0);
  put(flags, 4);
  put(map.latitudeStep, 4);
  put(map.longitudeStep, 4);
  put(map.latitudes * map.latitudeStep, 4);
  put(6283185, 4);
  put(0x0000, 2);
  put(1, 2);
  put(map.hasWindow ? map.firstLatitude : 0, 2);
  put(map.hasWindow ? map.lastLatitude : 0, 2);
  put(map.hasWindow ? map.firstLongitude : 0, 2);
  put(map.hasWindow ? map.lastLongitude : 0, 2);
  put(28096, 4);
  put(124352, 4);
  bytes.resize(static_cast<std::size_t>(size), '\x11');
  return bytes + cyberwareSamples(map, isBig);
}

/// The point of a sample, in millimetres.
inline Vec3 cyberwarePoint(const CyberwareMap& map, int lg, int lt)
{
  const int sample = map.samples[static_cast<std::size_t>(lg * map.latitudes + lt)];
  const double range = std::ldexp(sample, map.shift) / 1000.0;
  const double middle = (lt - map.latitudes / 2) * map.latitudeStep / 1000.0;
  if (map.space == "CYLINDRICAL")
  {
    const double angle = static_cast<double>(lg * map.longitudeStep) / 1e6;
    const double x = range * std::sin(angle);
    return { map.isRightHanded ? -x : x, middle, -(range * std::cos(angle)) };
  }
  const double x = (lg - map.longitudes / 2) * map.longitudeStep / 1000.0;
  const int row = lt >= map.latitudes / 2 ? lt - map.latitudes / 2 : lt;
  const double y = (row - map.latitudes) * map.latitudeStep / 1000.0;
  return { x, map.space == "BILATERAL" ? y : middle, range };
}

/// The points of the window that are not void.
inline std::vector<Vec3> cyberwarePoints(const CyberwareMap& map)
{
  std::vector<Vec3> points;
  for (int lg = 0; lg < map.longitudes; ++lg)
  {
    for (int lt = 0; lt < map.latitudes; ++lt)
    {
      const bool isInside = lg >= map.firstLongitude && lg <= map.lastLongitude &&
        lt >= map.firstLatitude && lt <= map.lastLatitude;
      const int sample = map.samples[static_cast<std::size_t>(lg * map.latitudes + lt)];
      if (sample != kCyberwareVoid && (isInside || !map.hasWindow))
      {
        points.push_back(cyberwarePoint(map, lg, lt));
      }
    }
  }
  return points;
}

} // namespace scan::test
