// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/point_fixtures.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numbers>

namespace scan::test
{

using std::numbers::pi;

double normalNumber(Random& random)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.unit();
  }
  return sum;
}

Vec3 noise(Random& random, double deviation)
{
  const double x = normalNumber(random);
  const double y = normalNumber(random);
  const double z = normalNumber(random);
  return Vec3{ x, y, z } * deviation;
}

Truth sphereTruth(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  Truth truth{ "sphere", {}, std::sqrt(4.0 * pi / static_cast<double>(count)),
    [](const Vec3& at) { return std::abs(length(at) - 1.0); }, unitVector };
  while (truth.points.size() < count)
  {
    const double z = 2.0 * random.unit() - 1.0;
    const double angle = 2.0 * pi * random.unit();
    const double r = std::sqrt(1.0 - z * z);
    truth.points.push_back({ r * std::cos(angle), r * std::sin(angle), z });
  }
  return truth;
}

Truth torusTruth(std::size_t count, std::uint64_t seed)
{
  constexpr double kTube = 0.35;
  Random random(seed);
  const auto fromCircle = [](const Vec3& at) -> Vec3
  {
    const double r = std::hypot(at.x, at.y);
    return { at.x - at.x / r, at.y - at.y / r, at.z };
  };
  Truth truth{ "torus", {}, std::sqrt(4.0 * pi * pi * kTube / static_cast<double>(count)),
    [=](const Vec3& at) { return std::abs(length(fromCircle(at)) - kTube); },
    [=](const Vec3& at) { return unitVector(fromCircle(at)); } };
  while (truth.points.size() < count)
  {
    const double u = 2.0 * pi * random.unit();
    const double v = 2.0 * pi * random.unit();
    const double r = 1.0 + kTube * std::cos(v);
    if (random.unit() * (1.0 + kTube) < r)
    {
      truth.points.push_back({ r * std::cos(u), r * std::sin(u), kTube * std::sin(v) });
    }
  }
  return truth;
}

Truth sheetTruth(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  const auto height = [](double x, double y)
  { return 0.3 * std::sin(2.0 * x) * std::cos(2.0 * y); };
  Truth truth{ "sheet", {}, std::sqrt(4.0 / static_cast<double>(count)),
    [=](const Vec3& at)
    {
      const double dx = std::max(0.0, std::abs(at.x) - 1.0);
      const double dy = std::max(0.0, std::abs(at.y) - 1.0);
      const double dz = 0.85 * (at.z - height(at.x, at.y)); // less than half a right angle steep
      return std::sqrt(dx * dx + dy * dy + dz * dz);
    } };
  for (std::size_t i = 0; i < count; ++i)
  {
    const double x = 2.0 * random.unit() - 1.0;
    const double y = 2.0 * random.unit() - 1.0;
    truth.points.push_back({ x, y, height(x, y) });
  }
  return truth;
}

std::uint64_t pointSeed()
{
  const char* const text = std::getenv("SCAN_TEST_SEED");
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 20260101;
}

std::vector<Vec3> pointsOfFile(const std::string& path)
{
  std::vector<Vec3> points;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
  {
    Vec3 p;
    if (std::sscanf(line.c_str(), "%lf %lf %lf", &p.x, &p.y, &p.z) == 3)
    {
      points.push_back(p);
    }
  }
  return points;
}

std::string sharedFile(const std::string& name)
{
  return std::string(SCAN_SHARED_DIR) + "/data/" + name;
}

std::string sampleFile(const std::string& name)
{
  return std::string(SCAN_DATA_DIR) + "/" + name;
}

std::vector<std::pair<std::string, std::vector<Vec3>>> degenerateClouds()
{
  std::vector<std::pair<std::string, std::vector<Vec3>>> clouds{ { "none", {} },
    { "one", { { 1, 2, 3 } } }, { "two", { { 1, 2, 3 }, { 4, 5, 6 } } },
    { "three", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } } },
    { "equal", std::vector<Vec3>(5000, Vec3{ 1e6, -2, 3 }) } };
  std::vector<Vec3> line;
  std::vector<Vec3> plane;
  std::vector<Vec3> grid;
  std::vector<Vec3> scales;
  for (int i = 0; i < 500; ++i)
  {
    line.push_back({ 0.1 * i, 0.2 * i, -0.3 * i });
    plane.push_back({ i % 20 * 1.0, i / 20 * 1.0, 0.0 });
    grid.push_back({ i % 8 * 1.0, i / 8 % 8 * 1.0, i / 64 * 1.0 });
    scales.push_back({ i % 20 * 1e-9, i / 20 * 1e-9, 0.0 });
    scales.push_back({ i % 20 * 1e9, i / 20 * 1e9, 1.0 });
  }
  clouds.emplace_back("line", line);
  clouds.emplace_back("plane", plane);
  clouds.emplace_back("grid", grid);
  clouds.emplace_back("two scales", scales);
  plane.insert(plane.end(), plane.begin(), plane.end());
  clouds.emplace_back("repeated", plane);
  return clouds;
}

void expectRefusesAndStops(const std::function<void(const std::vector<Vec3>&, Execution&)>& run)
{
  std::vector<Vec3> points = sphereTruth(3000, 1).points;
  const CancelToken token;
  double last = -1.0;
  Execution stopping(2, token,
    [&](std::string_view, double fraction)
    {
      last = fraction;
      token.cancel();
    });
  stopping.plan({ { "neighbours", 1.0 } });
  EXPECT_THROW(run(points, stopping), Cancelled);
  EXPECT_LT(last, 1.0);

  points[1234].y = std::numeric_limits<double>::quiet_NaN();
  Execution execution(1);
  try
  {
    run(points, execution);
    ADD_FAILURE() << "a point that is not finite is accepted";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::badInput) << error.what();
  }
}

} // namespace scan::test
