// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/replaced_triangles.h"

#include <algorithm>

namespace scan
{

SurfaceEdit replaceTriangles(const TriMesh& mesh, std::span<const std::uint8_t> isReplaced,
  const TriMesh& made, std::span<const Index> origins)
{
  const auto count = static_cast<Index>(mesh.points.size());
  // points of replaced triangles stay when they are among the made ones or others use them, too
  std::vector<std::uint8_t> stays(count, 1);
  for (Index t = 0; t < isReplaced.size(); ++t)
  {
    if (isReplaced[t] != 0)
    {
      std::ranges::for_each(mesh.triangles[t], [&](Index point) { stays[point] = 0; });
    }
  }
  for (Index t = 0; t < isReplaced.size(); ++t)
  {
    if (isReplaced[t] == 0)
    {
      std::ranges::for_each(mesh.triangles[t], [&](Index point) { stays[point] = 1; });
    }
  }
  std::vector<Vec3> places = mesh.points;
  for (Index i = 0; i < made.points.size(); ++i)
  {
    if (origins[i] != kNone)
    {
      stays[origins[i]] = 1;
      places[origins[i]] = made.points[i];
    }
  }
  SurfaceEdit edit;
  std::vector<Index> numbers(count, kNone);
  for (Index i = 0; i < count; ++i)
  {
    if (stays[i] != 0)
    {
      numbers[i] = static_cast<Index>(edit.mesh.points.size());
      edit.mesh.points.push_back(places[i]);
      edit.pointOrigin.push_back(i);
    }
  }
  std::vector<Index> madeNumbers(made.points.size(), kNone);
  for (Index i = 0; i < made.points.size(); ++i)
  {
    if (origins[i] != kNone)
    {
      madeNumbers[i] = numbers[origins[i]];
    }
    else
    {
      madeNumbers[i] = static_cast<Index>(edit.mesh.points.size());
      edit.mesh.points.push_back(made.points[i]);
      edit.pointOrigin.push_back(kNone);
    }
  }
  for (Index t = 0; t < isReplaced.size(); ++t)
  {
    if (isReplaced[t] == 0)
    {
      const auto& [a, b, c] = mesh.triangles[t];
      edit.mesh.triangles.push_back({ numbers[a], numbers[b], numbers[c] });
      edit.triangleOrigin.push_back(t);
    }
  }
  for (const auto& [a, b, c] : made.triangles)
  {
    edit.mesh.triangles.push_back({ madeNumbers[a], madeNumbers[b], madeNumbers[c] });
  }
  return edit;
}

} // namespace scan
