// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/facet_search.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <array>
#include <limits>

namespace scan
{
namespace
{

/// Of a point from a facet; infinite where that is clearly more than `atMost`.
double squaredDistance(
  const DelaunayComplex& complex, Facet facet, const Vec3& point, double atMost)
{
  constexpr double kRounding = 1e-9;
  const Triangle v = complex.facetVertices(facet);
  const std::array<Vec3, 3> p{ complex.points[v[0]], complex.points[v[1]], complex.points[v[2]] };
  return BoundingBox(p).squaredDistance(point) > (1.0 + kRounding) * atMost
    ? std::numeric_limits<double>::infinity()
    : squaredDistance(point, p[0], p[1], p[2]);
}

} // namespace

Facet nearestFacet(const DelaunayComplex& complex, std::span<const Facet> facets, const Vec3& point,
  Execution& execution)
{
  struct Candidate
  {
    Facet facet = kNone;
    double distance2 = std::numeric_limits<double>::infinity();
  };
  constexpr std::size_t kChunk = 1 << 14;
  std::vector<Candidate> nearest((facets.size() + kChunk - 1) / kChunk);
  execution.parallelFor(nearest.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        const std::size_t count = std::min(kChunk, facets.size() - kChunk * chunk);
        for (const Facet facet : facets.subspan(kChunk * chunk, count))
        {
          const double distance2 = squaredDistance(complex, facet, point, nearest[chunk].distance2);
          if (distance2 < nearest[chunk].distance2)
          {
            nearest[chunk] = { facet, distance2 };
          }
        }
      }
    });
  Candidate best;
  for (const Candidate& candidate : nearest)
  {
    best = candidate.distance2 < best.distance2 ? candidate : best;
  }
  return best.facet;
}

Facet facetTowards(const DelaunayComplex& complex, Facet facet, const Vec3& point)
{
  const Triangle v = complex.facetVertices(facet);
  const Vec3& a = complex.points[v[0]];
  const Vec3 outward = cross(complex.points[v[1]] - a, complex.points[v[2]] - a);
  const Facet mirror = complex.mirror[facet / 4][facet % 4];
  return mirror != kNone && dot(point - a, outward) > 0.0 ? mirror : facet;
}

std::vector<Facet> facetsWithin(const DelaunayComplex& complex, std::span<const Facet> facets,
  const Vec3& point, double distance, Execution& execution)
{
  return collect<Facet>(static_cast<Index>(facets.size()), execution,
    [&](Index i, auto& found)
    {
      const double most = distance * distance;
      if (squaredDistance(complex, facets[i], point, most) <= most)
      {
        found.push_back(facets[i]);
      }
    });
}

} // namespace scan
