// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/scan_spacing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scan
{

std::vector<float> localSpacing(const FlowComplex& flow, Execution& execution)
{
  const std::vector<Vec3>& points = flow.delaunay().points;
  const std::vector<CriticalEdge> edges = criticalEdges(flow, execution);
  std::vector<Index> first(points.size() + 1, 0);
  for (const CriticalEdge& edge : edges)
  {
    ++first[edge.vertices[0]];
    ++first[edge.vertices[1]];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<float> lengths(first.back());
  for (const CriticalEdge& edge : edges)
  {
    const Vec3 d = points[edge.vertices[1]] - points[edge.vertices[0]];
    const auto length = static_cast<float>(std::sqrt(dot(d, d)));
    lengths[--first[edge.vertices[0]]] = length;
    lengths[--first[edge.vertices[1]]] = length;
  }
  std::vector<float> spacing(points.size(), 0.0F);
  execution.parallelFor(points.size(), 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v < end; ++v)
      {
        const auto middle = lengths.begin() + first[v] + (first[v + 1] - first[v]) / 2;
        std::nth_element(lengths.begin() + first[v], middle, lengths.begin() + first[v + 1]);
        spacing[v] = *middle; // every vertex has one: the edge to its nearest neighbour is critical
      }
    });
  return spacing;
}

float excessArea(
  const DelaunayComplex& complex, const std::vector<float>& spacing, const Triangle& triangle)
{
  const Vec3& a = complex.points[triangle[0]];
  const Vec3 normal = cross(complex.points[triangle[1]] - a, complex.points[triangle[2]] - a);
  const double h = std::max({ spacing[triangle[0]], spacing[triangle[1]], spacing[triangle[2]] });
  constexpr double kAllowed = 2.0;
  const double area = 0.5 * std::sqrt(dot(normal, normal));
  return static_cast<float>(std::max(0.0, area / (h * h) - kAllowed));
}

} // namespace scan
