// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/flow_complex.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/exact_flow_signs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace scan
{
namespace
{

/// Rounding errors of the polynomials below are at most 1e-14 times the sum of the absolute values
/// of their monomials (at most 24 roundings, forward analysis); this much more covers underflow.
constexpr double kRelativeError = 1e-14;
constexpr double kUnderflow = 1e-290;

enum class Sign
{
  negative,
  positive,
  unsure
};

Sign filteredSign(double value, double magnitude)
{
  const double error = kRelativeError * magnitude + kUnderflow;
  return value > error ? Sign::positive : value < -error ? Sign::negative : Sign::unsure;
}

/// Which facets of the tetrahedron are attached to it: those beyond which its circumcentre lies,
/// that is where the circumcentre's barycentric coordinate of the opposite vertex is negative.
unsigned attachedFacetsOf(const std::array<Vec3, 4>& p)
{
  const Vec3 b = p[1] - p[0];
  const Vec3 c = p[2] - p[0];
  const Vec3 d = p[3] - p[0];
  const Vec3 cd = cross(c, d);
  const Vec3 db = cross(d, b);
  const Vec3 bc = cross(b, c);
  const double b2 = dot(b, b);
  const double c2 = dot(c, c);
  const double d2 = dot(d, d);
  const double det = dot(b, cd);
  const Vec3 n = cd * b2 + db * c2 + bc * d2; // circumcentre - p0 = n / 2 det
  const double lb = dot(n, cd);               // 2 det^2 times the barycentric coordinates
  const double lc = dot(n, db);
  const double ld = dot(n, bc);
  const double la = 2.0 * det * det - (lb + lc + ld);

  const double nb = std::sqrt(b2);
  const double nc = std::sqrt(c2);
  const double nd = std::sqrt(d2);
  const double perimeter = nb + nc + nd;
  const double mb = c2 * d2 * nb * perimeter;
  const double mc = b2 * d2 * nc * perimeter;
  const double md = b2 * c2 * nd * perimeter;
  const std::array<Sign, 4> signs{ filteredSign(la, 2.0 * b2 * c2 * d2 + mb + mc + md),
    filteredSign(lb, mb), filteredSign(lc, mc), filteredSign(ld, md) };

  unsigned attached = 0;
  for (int k = 0; k < 4; ++k)
  {
    const auto& f = kFacetVertices[k];
    const bool inside = signs[k] == Sign::unsure
      ? insideSmallestSphere(p[f[0]], p[f[1]], p[f[2]], p[k])
      : signs[k] == Sign::negative;
    attached |= static_cast<unsigned>(inside) << k;
  }
  return attached;
}

/// Corner 0, 1, 2 of the triangle that sees the opposite edge at an obtuse angle, or -1.
int obtuseCorner(const std::array<Vec3, 3>& p)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vec3& s = p[corner];
    const Vec3& a = p[(corner + 1) % 3];
    const Vec3& b = p[(corner + 2) % 3];
    const Vec3 sa = a - s;
    const Vec3 sb = b - s;
    const Sign sign = filteredSign(dot(sa, sb), dot(sa, sa) + dot(sb, sb));
    if (sign == Sign::unsure ? insideDiametralSphere(a, b, s) : sign == Sign::negative)
    {
      return corner;
    }
  }
  return -1;
}

} // namespace

FlowComplex::FlowComplex(const DelaunayComplex& complex, Execution& execution)
  : Complex(complex)
  , Attached(complex.tetCount())
  , Obtuse(complex.tetCount())
{
  constexpr std::size_t kGrain = 1 << 13;
  execution.step("classify", 0, 2);
  execution.parallelFor(complex.tetCount(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t tet = begin; tet < end; ++tet)
      {
        const auto& v = complex.tetrahedra[tet];
        this->Attached[tet] = static_cast<std::uint8_t>(attachedFacetsOf({ complex.points[v[0]],
          complex.points[v[1]], complex.points[v[2]], complex.points[v[3]] }));
      }
    });
  execution.step("classify", 1, 2);
  execution.parallelFor(complex.tetCount(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t tet = begin; tet < end; ++tet)
      {
        unsigned corners = 0;
        for (int k = 0; k < 4; ++k)
        {
          const Facet facet = 4 * static_cast<Facet>(tet) + static_cast<Facet>(k);
          if (complex.canonical(facet) == facet && this->isFree(facet))
          {
            const Triangle v = complex.facetVertices(facet);
            const int corner =
              obtuseCorner({ complex.points[v[0]], complex.points[v[1]], complex.points[v[2]] });
            corners |= static_cast<unsigned>(corner + 1) << (2 * k);
          }
        }
        this->Obtuse[tet] = static_cast<std::uint8_t>(corners);
      }
    });
  execution.step("classify", 2, 2);
}

Facet FlowComplex::exit(Index tet) const
{
  const unsigned attached = this->Attached[tet];
  const auto first = static_cast<unsigned>(std::countr_zero(attached));
  const unsigned rest = attached & (attached - 1);
  if (rest == 0)
  {
    return 4 * tet + first;
  }
  const auto second = static_cast<unsigned>(std::countr_zero(rest));
  const auto roomBeyond = [&](unsigned k)
  {
    const Index beyond = this->Complex.neighbour(tet, static_cast<int>(k));
    return beyond == kNone ? std::numeric_limits<double>::infinity()
                           : circumradiusSquared(this->Complex, beyond);
  };
  return 4 * tet + (roomBeyond(second) > roomBeyond(first) ? second : first);
}

double circumradiusSquared(const DelaunayComplex& complex, Index tet)
{
  const auto& v = complex.tetrahedra[tet];
  const Vec3& a = complex.points[v[0]];
  const Vec3 b = complex.points[v[1]] - a;
  const Vec3 c = complex.points[v[2]] - a;
  const Vec3 d = complex.points[v[3]] - a;
  const Vec3 cd = cross(c, d);
  const Vec3 n = cd * dot(b, b) + cross(d, b) * dot(c, c) + cross(b, c) * dot(d, d);
  const Vec3 centre = n * (0.5 / dot(b, cd));
  return dot(centre, centre);
}

double circumradiusSquared(const DelaunayComplex& complex, const Triangle& triangle)
{
  const Vec3& a = complex.points[triangle[0]];
  const Vec3& b = complex.points[triangle[1]];
  const Vec3& c = complex.points[triangle[2]];
  const Vec3 normal = cross(b - a, c - a);
  return dot(b - a, b - a) * dot(c - b, c - b) * dot(a - c, a - c) / (4.0 * dot(normal, normal));
}

namespace
{

/// Is the edge opposite `apex` in the free triangle `start` critical, and `start` the first free
/// triangle at it, so that each edge is found once?
bool findsCriticalEdge(const FlowComplex& flow, Facet start, Index apex)
{
  if (flow.obtuseVertex(start) == apex)
  {
    return false;
  }
  const DelaunayComplex& complex = flow.delaunay();
  const Facet startMirror = complex.mirror[start / 4][start % 4];
  return complex.walkWholeEdge(start, apex,
    [&](Facet entering, Facet leaving, Facet beyond)
    {
      if (flow.isAttached(leaving))
      {
        return !flow.isAttached(entering); // both: the interval [edge, tetrahedron]
      }
      if (leaving == start || leaving == startMirror ||
        (beyond != kNone && flow.isAttached(beyond)))
      {
        return true;
      }
      const Index ahead = complex.tetrahedra[entering / 4][entering % 4];
      return std::min(leaving, beyond) > start && flow.obtuseVertex(leaving) != ahead;
    });
}

} // namespace

std::vector<CriticalEdge> criticalEdges(
  const FlowComplex& flow, Execution& execution, const std::function<bool(Facet)>& wanted)
{
  const DelaunayComplex& complex = flow.delaunay();
  execution.step("edges", 0, 1);
  return collect<CriticalEdge>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        if (complex.canonical(facet) != facet || !flow.isFree(facet) || !wanted(facet))
        {
          continue;
        }
        const Triangle v = complex.facetVertices(facet);
        for (int corner = 0; corner < 3; ++corner)
        {
          if (findsCriticalEdge(flow, facet, v[corner]))
          {
            found.push_back({ { v[(corner + 1) % 3], v[(corner + 2) % 3] }, facet, v[corner] });
          }
        }
      }
    });
}

} // namespace scan
