// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/base/execution.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace scan::test
{

/// Points on a surface of which everything is known.
struct Truth
{
  std::string name;
  std::vector<Vec3> points;                        ///< at random, evenly by area
  double spacing = 0.0;                            ///< root of the area per point
  std::function<double(const Vec3& at)> distance;  ///< from the surface
  std::function<Vec3(const Vec3& at)> normal = {}; ///< outward, of the nearest point of the surface
};

Truth sphereTruth(std::size_t count, std::uint64_t seed); ///< radius 1
Truth torusTruth(std::size_t count, std::uint64_t seed);  ///< radii 1 and 0.35
Truth sheetTruth(std::size_t count, std::uint64_t seed);  ///< a wave over a square of side 2

/// Approximately normal, standard deviation 1, at most 6.
double normalNumber(Random& random);

/// Random numbers in every direction.
Vec3 noise(Random& random, double deviation);

/// The seed of this run: SCAN_TEST_SEED or a fixed one.
std::uint64_t pointSeed();

/// The points of a file with one point a line; none when it is not there.
std::vector<Vec3> pointsOfFile(const std::string& path);

std::string sharedFile(const std::string& name);
std::string sampleFile(const std::string& name);

/// A region of all points.
inline std::vector<std::uint8_t> everywhere(std::span<const Vec3> points)
{
  return std::vector<std::uint8_t>(points.size(), 1);
}

/// Awkward inputs: none to three points, equal, on a line, in a plane, repeated, a grid, two
/// scales.
std::vector<std::pair<std::string, std::vector<Vec3>>> degenerateClouds();

/// Calls run(points, execution) with what must be refused or stopped, and expects that it is.
void expectRefusesAndStops(const std::function<void(const std::vector<Vec3>&, Execution&)>& run);

} // namespace scan::test
