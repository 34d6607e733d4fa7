// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_truths.h"

#include "data/multiview_scan_truth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quality
{
namespace
{

using scan::Index;
using scan::TriMesh;
using scan::Vec3;
using std::numbers::pi;

/// The image of a grid: place(row, column) for rows and columns from 0 on, both ends included.
template <class Place>
TriMesh gridSurface(Index rows, Index columns, const Place& place)
{
  TriMesh mesh;
  for (Index row = 0; row <= rows; ++row)
  {
    for (Index column = 0; column <= columns; ++column)
    {
      mesh.points.push_back(place(row, column));
    }
  }
  const Index width = columns + 1;
  for (Index row = 0; row < rows; ++row)
  {
    for (Index at = row * width; at < row * width + columns; ++at)
    {
      mesh.triangles.push_back({ at, at + 1, at + width });
      mesh.triangles.push_back({ at + 1, at + width + 1, at + width });
    }
  }
  return mesh;
}

/// From 0 to `range` while i goes from 0 to n.
double part(Index i, Index n, double range)
{
  return range * i / n;
}

/// A corner of an outline: the centre of its rounding and the direction away from it.
struct Corner
{
  Vec3 centre;
  Vec3 normal;
};

/// The outline of the link: around the wide end, then around the narrow one.
std::vector<Corner> linkOutline()
{
  constexpr Index kSteps = 180; // for each end
  const double tangent = std::acos((truth::kWideRadius - truth::kNarrowRadius) / truth::kLength);
  std::vector<Corner> corners;
  const auto arc = [&](double centre, double from, double to)
  {
    for (Index i = 0; i <= kSteps; ++i)
    {
      const double angle = from + part(i, kSteps, to - from);
      corners.push_back({ { centre, 0.0, 0.0 }, { std::cos(angle), std::sin(angle), 0.0 } });
    }
  };
  arc(0.0, tangent, 2.0 * pi - tangent);
  arc(truth::kLength, -tangent, tangent);
  corners.push_back(corners.front());
  return corners;
}

} // namespace

TriMesh torusSurface()
{
  constexpr Index kAround = 840;
  constexpr Index kTube = 220;
  return gridSurface(kAround, kTube,
    [](Index row, Index column)
    {
      const double u = part(row, kAround, 2.0 * pi);
      const double v = part(column, kTube, 2.0 * pi);
      const double r = 1.0 + 0.35 * std::cos(v);
      return Vec3{ r * std::cos(u), r * std::sin(u), 0.35 * std::sin(v) };
    });
}

TriMesh sphereSurface()
{
  constexpr Index kSteps = 300; // from pole to pole
  return gridSurface(kSteps, 2 * kSteps,
    [](Index row, Index column)
    {
      const double latitude = part(row, kSteps, pi);
      const double longitude = part(column, kSteps, pi);
      const double r = row % kSteps == 0 ? 0.0 : std::sin(latitude);
      return Vec3{ r * std::cos(longitude), r * std::sin(longitude), std::cos(latitude) };
    });
}

TriMesh plateSurface()
{
  constexpr Index kAround = 720; // a multiple of eight: the corners of the plate are vertices
  return gridSurface(kAround, 4,
    [](Index row, Index column) // around the profile: hole, top, rim, bottom
    {
      const double angle = part(row, kAround, 2.0 * pi);
      const Vec3 ray{ std::cos(angle), std::sin(angle), 0.0 };
      const double toRim = 2.0 / std::max(std::abs(ray.x), std::abs(ray.y));
      const bool atRim = column == 2 || column == 3;
      return ray * (atRim ? toRim : 0.6) + Vec3{ 0.0, 0.0, column == 1 || column == 2 ? 1.0 : 0.0 };
    });
}

TriMesh saddleSurface()
{
  constexpr Index kRings = 120;
  constexpr Index kAround = 720;
  return gridSurface(kRings, kAround,
    [](Index row, Index column)
    {
      const double r = part(row, kRings, 1.0);
      const double angle = part(column, kAround, 2.0 * pi);
      return Vec3{ r * std::cos(angle), r * std::sin(angle),
        0.5 * r * r * r * std::cos(3.0 * angle) };
    });
}

TriMesh helixSurface()
{
  constexpr Index kTurn = 720;
  constexpr Index kAlong = 24;
  return gridSurface(kTurn, kAlong,
    [](Index row, Index column)
    {
      const double angle = part(row, kTurn, 2.0 * pi);
      const double along = part(column, kAlong, 2.0) - 1.0;
      return Vec3{ along * std::cos(angle), along * std::sin(angle), part(row, kTurn, 2.0) };
    });
}

TriMesh linkSurface()
{
  constexpr Index kArc = 40; // steps across half a rounded edge
  constexpr double kFlat = 0.5 * truth::kThickness - truth::kRounding;
  const std::vector<Corner> outline = linkOutline();
  return gridSurface(static_cast<Index>(outline.size() - 1), 4 * kArc + 4,
    [&](Index row, Index column) // around the profile: rim downwards, eye upwards
    {
      const auto& [centre, normal] = outline[row];
      const Index step = column % (4 * kArc + 4);
      const bool eye = step >= 2 * kArc + 2;
      const Index inHalf = eye ? step - (2 * kArc + 2) : step;
      const bool upper = (inHalf <= kArc) != eye; // the flat between the arcs joins two steps
      const Index onArc = inHalf <= kArc ? inHalf : inHalf - 1;
      const double angle = part(onArc, 2 * kArc, pi); // 0 on the face where the half begins
      const double out = truth::kRounding * std::sin(angle);
      const double z =
        (upper ? kFlat : -kFlat) + (eye ? -1.0 : 1.0) * truth::kRounding * std::cos(angle);
      if (eye)
      {
        return normal * (truth::kEyeRadius + truth::kRounding - out) + Vec3{ 0.0, 0.0, z };
      }
      const double wide = centre.x == 0.0 ? truth::kWideRadius : truth::kNarrowRadius;
      return centre + normal * (wide - truth::kRounding + out) + Vec3{ 0.0, 0.0, z };
    });
}

} // namespace quality
