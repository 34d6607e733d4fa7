// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/consistent_model.h"

#include "writers/single_precision.h"
#include "writers/used_points.h"

#include <algorithm>
#include <utility>

namespace scan
{
namespace
{

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
  const std::vector<bool> isUsed = usedPoints(model.triangles, model.curves, pointOrigin.size());
  std::vector<Index> places;
  std::vector<Index> number(pointOrigin.size(), kNone);
  for (std::size_t i = 0; i < pointOrigin.size(); ++i)
  {
    if (isUsed[i] || !wasUsed[pointOrigin[i]] || model.isScan())
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

/// Mends the surface with its points where the file will have them.
/// @param stored empty where that is their place
SurfaceChanges mend(
  Model& model, std::vector<Vec3> stored, double leastHeight, Execution& execution)
{
  const std::vector<bool> wasUsed = usedPoints(model.triangles, model.curves, model.points.size());
  std::vector<Vec3>& decisive = stored.empty() ? model.points : stored;
  ConsistentSurface surface =
    makeConsistent({ std::move(decisive), std::move(model.triangles) }, leastHeight, execution);
  decisive = std::move(surface.mesh.points); // where they were, and copies behind them
  model.triangles = std::move(surface.mesh.triangles);
  if (surface.changes.any())
  {
    rearrange(model, surface.pointOrigin, wasUsed);
    turnNormals(model, surface.isTurned, model.normals);
  }
  return surface.changes;
}

} // namespace

Model consistentModel(Model model, const FormatTraits& traits, Execution& execution)
{
  const bool isReadTwoWays = traits.precision == Precision::float64ReadAsFloat32;
  SurfaceChanges changes;
  constexpr int kMostPasses = 8; // the two ways may never agree about slivers
  for (int pass = 0; pass < kMostPasses && !model.triangles.empty(); ++pass)
  {
    const bool isSingle = isReadTwoWays ? pass % 2 == 1 : traits.precision == Precision::float32;
    const SurfaceChanges found =
      mend(model, isSingle ? roundedToFloat(model.points, traits.origin) : std::vector<Vec3>(),
        traits.leastHeight, execution);
    changes += found;
    if (!isReadTwoWays || (pass > 0 && !found.any()))
    {
      break;
    }
  }
  model.addNote(describe(changes));
  return model;
}

void turnNormals(const TriMesh& mesh, const std::vector<bool>& isTurned, std::vector<Vec3>& normals)
{
  if (normals.empty() || std::ranges::find(isTurned, true) == isTurned.end())
  {
    return;
  }
  std::vector<Vec3> sides(mesh.points.size());
  std::vector<bool> isOfTurned(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3 side = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    for (const Index corner : mesh.triangles[t])
    {
      sides[corner] = sides[corner] + side;
      isOfTurned[corner] = isOfTurned[corner] || isTurned[t];
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    if (isOfTurned[i] && dot(normals[i], sides[i]) < 0.0)
    {
      normals[i] = normals[i] * -1.0;
    }
  }
}

} // namespace scan
