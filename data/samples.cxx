// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "data/samples.h"

#include "data/splitmix.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <numbers>

namespace samples
{
namespace
{

using scan::Vec3;
using std::numbers::pi;

/// A flat plate of 4 × 4 × 1 with a round hole of radius 0.6; a grid of step 0.1, shaken by a
/// quarter of it within the surface.
std::vector<Vec3> plateWithHole()
{
  constexpr double radius = 0.6;
  constexpr double step = 0.1;
  constexpr int around = 37;
  SplitMix random(1);
  std::vector<Vec3> points;
  const auto shaken = [&](double value) { return value + random.jitter(step / 4.0); };
  for (int i = -20; i <= 20; ++i)
  {
    for (int j = -20; j <= 20; ++j)
    {
      for (const double z : { 0.0, 1.0 })
      {
        const double x = std::abs(i) == 20 ? i * step : shaken(i * step);
        const double y = std::abs(j) == 20 ? j * step : shaken(j * step);
        if (x * x + y * y > 1.05 * radius * 1.05 * radius)
        {
          points.push_back({ x, y, z });
        }
      }
    }
  }
  for (int layer = 1; layer < 10; ++layer)
  {
    for (int i = -20; i < 20; ++i)
    {
      // each side begins at its corner
      const auto along = [&] { return i == -20 ? i * step : shaken(i * step); };
      points.push_back({ along(), -2.0, shaken(layer * step) });
      points.push_back({ 2.0, along(), shaken(layer * step) });
      points.push_back({ -along(), 2.0, shaken(layer * step) });
      points.push_back({ -2.0, -along(), shaken(layer * step) });
    }
  }
  for (int layer = 0; layer <= 10; ++layer)
  {
    for (int i = 0; i < around; ++i)
    {
      const double turn = i + (layer % 2 == 0 ? 0.0 : 0.5) + random.jitter(0.25);
      const double angle = 2.0 * pi * turn / around;
      const double z = layer % 10 == 0 ? layer * step : shaken(layer * step);
      points.push_back({ radius * std::cos(angle), radius * std::sin(angle), z });
    }
  }
  return points;
}

/// 5,000 points at random, evenly by area, on a torus of radii 1 and 0.35.
std::vector<Vec3> torus()
{
  constexpr double tube = 0.35;
  SplitMix random(1);
  std::vector<Vec3> points;
  while (points.size() < 5000)
  {
    const double u = 2.0 * pi * random.unit();
    const double v = 2.0 * pi * random.unit();
    const double distance = 1.0 + tube * std::cos(v);
    if (random.unit() * (1.0 + tube) < distance)
    {
      points.push_back({ distance * std::cos(u), distance * std::sin(u), tube * std::sin(v) });
    }
  }
  return points;
}

/// A spiral staircase: a bar of 25 points in each of 17 positions, one turn in all.
std::vector<Vec3> helix()
{
  std::vector<Vec3> points;
  for (int position = 0; position < 17; ++position)
  {
    const double angle = pi * position / 8.0;
    for (int i = -12; i <= 12; ++i)
    {
      const double along = i / 12.0;
      points.push_back({ along * std::cos(angle), along * std::sin(angle), 0.125 * position });
    }
  }
  return points;
}

/// z = r^3 cos(3 a) / 2 over the unit disk, 39 rings of 60 points, every other ring turned.
std::vector<Vec3> monkeySaddle()
{
  std::vector<Vec3> points;
  for (int i = 0; i < 60; ++i)
  {
    for (int ring = 1; ring <= 39; ++ring)
    {
      const double r = ring / 39.0;
      const double angle = 2.0 * pi * (i + (ring % 2 == 1 ? 0.5 : 0.0)) / 60.0;
      points.push_back(
        { r * std::cos(angle), r * std::sin(angle), 0.5 * r * r * r * std::cos(3.0 * angle) });
    }
  }
  return points;
}

/// One point a line, nine significant digits.
std::string asText(const std::vector<Vec3>& points)
{
  std::string text;
  for (const Vec3& p : points)
  {
    for (const double value : { p.x, p.y, p.z })
    {
      char digits[32];
      // adding zero turns -0 into 0
      const auto end =
        std::to_chars(digits, digits + sizeof digits, value + 0.0, std::chars_format::general, 9);
      text.append(digits, end.ptr);
      text += ' ';
    }
    text.back() = '\n';
  }
  return text;
}

std::string asPly(const std::vector<Vec3>& points, const std::string& comment)
{
  std::string ply = "ply\nformat binary_little_endian 1.0\ncomment " + comment +
    "\nelement vertex " + std::to_string(points.size()) +
    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const Vec3& p : points)
  {
    for (const double value : { p.x, p.y, p.z })
    {
      const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
      for (unsigned shift = 0; shift < 32; shift += 8)
      {
        ply += static_cast<char>(bits >> shift & 0xffU);
      }
    }
  }
  return ply;
}

} // namespace

std::vector<Sample> makeSamples()
{
  return {
    { "plate_hole.xyz", asText(plateWithHole()) },
    { "torus.xyz", asText(torus()) },
    { "helix.xyz", asText(helix()) },
    { "monkey_saddle.xyz", asText(monkeySaddle()) },
    { "multiview_scan.ply",
      asPly(simulateScan(), "simulated scan of a link with one eye, 12 views, millimetres") },
    { "limb_scan.ply",
      asPly(simulateLimbScan(), "simulated scan of a leg, 12 views, millimetres") },
  };
}

} // namespace samples
