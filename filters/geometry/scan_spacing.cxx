// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/scan_spacing.h"

#include "filters/geometry/incidence.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

/// Per vertex the median of value(vertex, other end) over its edges; every vertex has one: the
/// edge to its nearest neighbour is critical.
template <class Value>
std::vector<float> medianOverEdges(const std::vector<CriticalEdge>& edges, const Incidence& edgesOf,
  Execution& execution, Value&& value)
{
  std::vector<float> medians(edgesOf.owners());
  execution.parallelFor(medians.size(), 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<float> values;
      for (auto v = static_cast<Index>(begin); v < end; ++v)
      {
        values.clear();
        for (const Index e : edgesOf.of(v))
        {
          const Segment& edge = edges[e].vertices;
          values.push_back(value(v, edge[0] == v ? edge[1] : edge[0]));
        }
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        medians[v] = *middle;
      }
    });
  return medians;
}

} // namespace

std::vector<float> localSpacing(const FlowComplex& flow, Execution& execution)
{
  const std::vector<Vec3>& points = flow.delaunay().points;
  const std::vector<CriticalEdge> edges = criticalEdges(flow, execution);
  const Incidence edgesOf(points.size(), edges.size(),
    [&](std::size_t e, auto&& visit)
    {
      visit(edges[e].vertices[0]);
      visit(edges[e].vertices[1]);
    });
  std::vector<float> spacing = medianOverEdges(edges, edgesOf, execution,
    [&](Index v, Index w)
    {
      const Vec3 d = points[w] - points[v];
      return static_cast<float>(std::sqrt(dot(d, d)));
    });
  // a stray point far off must not pass for a sparse part of the scan
  constexpr float kSteepestGrowth = 2.0F;
  const std::vector<float> around =
    medianOverEdges(edges, edgesOf, execution, [&](Index, Index w) { return spacing[w]; });
  for (std::size_t v = 0; v < spacing.size(); ++v)
  {
    spacing[v] = std::min(spacing[v], kSteepestGrowth * around[v]);
  }
  return spacing;
}

} // namespace scan
