// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/ordered_mesh.h"

#include "filters/geometry/hilbert_order.h"

#include <algorithm>
#include <numeric>

namespace scan
{

bool isScattered(const TriMesh& mesh)
{
  constexpr Index kFar = 4096;
  const auto far = std::ranges::count_if(mesh.triangles,
    [](const Triangle& triangle)
    {
      const auto [low, high] = std::ranges::minmax(triangle);
      return high - low > kFar;
    });
  return static_cast<std::size_t>(far) > mesh.triangles.size() / 4;
}

OrderedMesh orderedMesh(const TriMesh& mesh, Execution& execution)
{
  OrderedMesh result;
  result.mesh = mesh;
  result.pointNames.resize(mesh.points.size());
  result.triangleNames.resize(mesh.triangles.size());
  std::iota(result.pointNames.begin(), result.pointNames.end(), Index{ 0 });
  std::iota(result.triangleNames.begin(), result.triangleNames.end(), Index{ 0 });
  result.numbers = result.pointNames;
  if (!isScattered(mesh))
  {
    return result;
  }
  result.pointNames = hilbertOrder(mesh.points, execution);
  for (Index i = 0; i < result.numbers.size(); ++i)
  {
    result.numbers[result.pointNames[i]] = i;
    result.mesh.points[i] = mesh.points[result.pointNames[i]];
  }
  std::vector<Triangle> numbered = mesh.triangles;
  for (Triangle& triangle : numbered)
  {
    std::ranges::transform(
      triangle, triangle.begin(), [&](Index corner) { return result.numbers[corner]; });
  }
  std::ranges::stable_sort(
    result.triangleNames, {}, [&](Index t) { return std::ranges::min(numbered[t]); });
  std::ranges::transform(result.triangleNames, result.mesh.triangles.begin(),
    [&](Index name) { return numbered[name]; });
  return result;
}

} // namespace scan
