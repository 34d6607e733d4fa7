// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "tests/readers/temporary_folder.h"
#include "writers/output_file.h"
#include "writers/single_precision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace scan::test
{

/// @param format (model, file, execution)
template <class Format>
void writeModel(
  const std::string& path, const Model& model, const Format& format, unsigned threads = 0)
{
  Execution execution(threads);
  OutputFile file(path);
  format(model, file, execution);
  file.commit();
}

/// @param format (model, file, execution)
template <class Format>
std::string modelBytes(const Model& model, const Format& format, unsigned threads = 0)
{
  const TemporaryFolder folder;
  writeModel(folder.file("out"), model, format, threads);
  return contentOf(folder.file("out"));
}

/// A format (model, file, execution) of one that also takes what coordinates are relative to.
template <class Format>
auto aroundItsMiddle(const Format& format)
{
  return [&format](const Model& model, OutputFile& file, Execution& execution)
  { format(model, originForFloats(model.points), file, execution); };
}

/// The code of the Error that the writer ends in; internal when it accepts the model.
template <class Format>
ErrorCode writeError(const Model& model, const Format& format)
{
  try
  {
    modelBytes(model, format);
  }
  catch (const Error& error)
  {
    return error.code();
  }
  return ErrorCode::internal;
}

/// The message of the Error badInput that the writer ends in; empty when it accepts the model.
template <class Format>
std::string writeMessage(const Model& model, const Format& format)
{
  try
  {
    modelBytes(model, format);
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::badInput ? error.what() : "another code";
  }
  return {};
}

/// Expects that the writer ends early when the user has cancelled.
template <class Format>
void expectCancels(const Model& model, const Format& format)
{
  const TemporaryFolder folder;
  CancelToken token;
  token.cancel();
  Execution execution(1, token);
  OutputFile file(folder.file("out"));
  EXPECT_THROW(format(model, file, execution), Cancelled);
}

inline Model oneTriangle()
{
  Model model;
  model.points = { { 0, 0, 0 }, { 2.5, 0, 0 }, { 0, -0.125, 1e-7 } };
  model.triangles = { { 0, 1, 2 } };
  return model;
}

inline Model threePoints()
{
  Model model = oneTriangle();
  model.triangles.clear();
  return model;
}

inline Model colored(Model model)
{
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.colors.push_back({ static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 256),
      static_cast<std::uint8_t>(255 - i % 256) });
  }
  return model;
}

/// A grid of rows x columns squares, each of two triangles, with coordinates that float32 holds;
/// closed in both directions (a torus), or open.
inline Model grid(Index rows, Index columns, bool isClosed)
{
  Model model;
  const Index across = columns + (isClosed ? 0 : 1);
  const Index down = rows + (isClosed ? 0 : 1);
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double turn = isClosed ? kTurn : kTurn / 2.0;
  for (Index i = 0; i < down; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double u = turn * i / rows;
      const double v = turn * j / columns;
      const double r = 30.0 + 10.0 * std::cos(v);
      model.points.push_back(
        roundedToFloat({ r * std::cos(u), r * std::sin(u), 7.0 + 10.0 * std::sin(v) }));
    }
  }
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < columns; ++j)
    {
      const Index a = i * across + j;
      const Index b = (i + 1) % down * across + j;
      const Index c = (i + 1) % down * across + (j + 1) % across;
      const Index d = i * across + (j + 1) % across;
      model.triangles.push_back({ a, b, c });
      model.triangles.push_back({ a, c, d });
    }
  }
  return model;
}

/// The model somewhere else, and its coordinates in another unit.
inline Model moved(Model model, const Vec3& by, double scale = 1.0)
{
  for (Vec3& p : model.points)
  {
    p = (p + by) * scale;
  }
  return model;
}

/// The model with an open and a closed curve through its first points, which are at least five.
inline Model withCurves(Model model)
{
  model.curves = { { 3, 1, 4, 0, 2, 3, 0 }, { 3, 7 } };
  return model;
}

/// The points along each curve of a model.
inline std::vector<std::vector<Vec3>> placesOf(const Model& model)
{
  std::vector<std::vector<Vec3>> places(model.curves.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (const Index corner : model.curves[i])
    {
      places[i].push_back(model.points[corner]);
    }
  }
  return places;
}

/// Triangles that share no point.
inline Model scattered(Index count)
{
  Model model;
  for (Index i = 0; i < count; ++i)
  {
    const double x = i % 100;
    const double y = i / 100;
    model.points.insert(
      model.points.end(), { { x, y, 0 }, { x + 0.5, y, 0.25 }, { x, y + 0.5, 0.5 } });
    model.triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
  }
  return model;
}

/// Three triangles on one edge.
inline Model nonManifold()
{
  Model model;
  model.points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
  model.triangles = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  return model;
}

/// What two files of the same surface have in common, however they hold it.
struct Summary
{
  std::size_t points = 0; ///< different ones
  std::size_t triangles = 0;
  double volume = 0.0;
  Vec3 lowest;
  Vec3 highest;
};

inline Summary summaryOf(const TriMesh& mesh)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Summary summary{ .triangles = mesh.triangles.size(),
    .lowest = { kFar, kFar, kFar },
    .highest = { -kFar, -kFar, -kFar } };
  std::vector<std::array<double, 3>> places;
  for (const Vec3& p : mesh.points)
  {
    places.push_back({ p.x, p.y, p.z });
    summary.lowest = { std::min(summary.lowest.x, p.x), std::min(summary.lowest.y, p.y),
      std::min(summary.lowest.z, p.z) };
    summary.highest = { std::max(summary.highest.x, p.x), std::max(summary.highest.y, p.y),
      std::max(summary.highest.z, p.z) };
  }
  std::sort(places.begin(), places.end());
  summary.points =
    static_cast<std::size_t>(std::unique(places.begin(), places.end()) - places.begin());
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const Vec3& from = summary.lowest; // far from the surface, volumes lose digits
    summary.volume +=
      dot(mesh.points[a] - from, cross(mesh.points[b] - from, mesh.points[c] - from)) / 6.0;
  }
  return summary;
}

/// Expects the same surface, up to the rounding of coordinates.
inline void expectSame(const TriMesh& mesh, const TriMesh& expected, double tolerance = 1e-6)
{
  const Summary a = summaryOf(mesh);
  const Summary b = summaryOf(expected);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_NEAR(a.volume, b.volume, std::abs(b.volume) * tolerance + 1e-12);
  const Vec3 low = a.lowest - b.lowest;
  const Vec3 high = a.highest - b.highest;
  const double size = std::sqrt(dot(b.highest, b.highest)) + std::sqrt(dot(b.lowest, b.lowest));
  EXPECT_LE(std::sqrt(dot(low, low)), size * tolerance);
  EXPECT_LE(std::sqrt(dot(high, high)), size * tolerance);
}

} // namespace scan::test
