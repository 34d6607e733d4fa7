// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/consistent_model.h"

#include <algorithm>
#include <utility>

namespace scan
{
namespace
{

std::vector<bool> usedPoints(const std::vector<Triangle>& triangles, std::size_t pointCount)
{
  std::vector<bool> isUsed(pointCount);
  for (const Triangle& triangle : triangles)
  {
    for (const Index corner : triangle)
    {
      isUsed[corner] = true;
    }
  }
  return isUsed;
}

/// The values at `places`, in that order.
template <class Value>
void choose(std::vector<Value>& values, const std::vector<Index>& places)
{
  if (!values.empty())
  {
    std::vector<Value> chosen(places.size());
    std::ranges::transform(places, chosen.begin(), [&](Index place) { return values[place]; });
    values = std::move(chosen);
  }
}

/// Gives the model's points the new order and drops those that the surface has lost: the triangles
/// used them, and now nothing does.
void rearrange(
  Model& model, const std::vector<Index>& pointOrigin, const std::vector<bool>& wasUsed)
{
  std::vector<bool> isUsed = usedPoints(model.triangles, pointOrigin.size());
  for (const Index corner : model.curves.corners)
  {
    isUsed[corner] = true;
  }
  std::vector<Index> places;
  std::vector<Index> number(pointOrigin.size(), kNone);
  for (std::size_t i = 0; i < pointOrigin.size(); ++i)
  {
    if (isUsed[i] || !wasUsed[pointOrigin[i]])
    {
      number[i] = static_cast<Index>(places.size());
      places.push_back(pointOrigin[i]);
    }
  }
  choose(model.points, places);
  choose(model.colors, places);
  choose(model.normals, places);
  for (Triangle& triangle : model.triangles)
  {
    triangle = { number[triangle[0]], number[triangle[1]], number[triangle[2]] };
  }
  for (Index& corner : model.curves.corners)
  {
    corner = number[corner];
  }
}

/// Turns the normals that point to the far side of the triangles around them.
void turnNormals(Model& model)
{
  std::vector<Vec3> sides(model.normals.empty() ? 0 : model.points.size());
  for (std::size_t t = 0; t < model.triangles.size() && !sides.empty(); ++t)
  {
    const auto& [a, b, c] = model.triangles[t];
    const Vec3 side = cross(model.points[b] - model.points[a], model.points[c] - model.points[a]);
    for (const Index corner : model.triangles[t])
    {
      sides[corner] = sides[corner] + side;
    }
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (dot(model.normals[i], sides[i]) < 0.0)
    {
      model.normals[i] = model.normals[i] * -1.0;
    }
  }
}

} // namespace

Model consistentModel(
  Model model, std::vector<Vec3> stored, double leastHeight, Execution& execution)
{
  if (model.triangles.empty())
  {
    return model;
  }
  const std::vector<bool> wasUsed = usedPoints(model.triangles, model.points.size());
  std::vector<Vec3>& decisive = stored.empty() ? model.points : stored;
  ConsistentSurface surface =
    makeConsistent({ std::move(decisive), std::move(model.triangles) }, leastHeight, execution);
  decisive = std::move(surface.mesh.points); // where they were, and copies behind them
  model.triangles = std::move(surface.mesh.triangles);
  if (surface.isChanged())
  {
    rearrange(model, surface.pointOrigin, wasUsed);
    model.note = changesOf(surface);
  }
  if (surface.turned > 0)
  {
    turnNormals(model);
  }
  return model;
}

std::string changesOf(const ConsistentSurface& surface)
{
  std::string changes;
  const auto add = [&](Index number, const char* thing, const char* what)
  {
    if (number > 0)
    {
      changes += changes.empty() ? "the surface is mended: " : ", ";
      changes += std::to_string(number) + " " + thing + (number == 1 ? "" : "s") + " " + what;
    }
  };
  add(surface.removed, "triangle", "without area left out");
  add(surface.repeats, "triangle", "that repeats another left out");
  add(surface.cut, "triangle", "cut");
  add(surface.turned, "triangle", "turned over");
  add(surface.edgesSplit, "edge", "split");
  add(surface.verticesSplit, "point", "repeated");
  return changes;
}

} // namespace scan
