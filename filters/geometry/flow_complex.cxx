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

bool isUnsure(double value, double magnitude)
{
  return std::abs(value) <= kRelativeError * magnitude + kUnderflow;
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
  const std::array<double, 4> values{ la, lb, lc, ld };
  const std::array<double, 4> magnitudes{ 2.0 * b2 * c2 * d2 + mb + mc + md, mb, mc, md };

  unsigned attached = 0; // without branches: nobody can foresee them
  unsigned unsure = 0;
  for (int k = 0; k < 4; ++k)
  {
    attached |= static_cast<unsigned>(values[k] < 0.0) << k;
    unsure |= static_cast<unsigned>(isUnsure(values[k], magnitudes[k])) << k;
  }
  for (; unsure != 0; unsure &= unsure - 1)
  {
    const int k = std::countr_zero(unsure);
    const auto& f = kFacetVertices[k];
    const bool inside = insideSmallestSphere(p[f[0]], p[f[1]], p[f[2]], p[k]);
    attached = (attached & ~(1U << k)) | static_cast<unsigned>(inside) << k;
  }
  return attached;
}

/// The edges of a tetrahedron by their ends, and the other two vertices.
constexpr int kEdges = 6;
constexpr std::array<std::array<int, 2>, kEdges> kEdgeEnds{ { { 0, 1 }, { 0, 2 }, { 0, 3 },
  { 1, 2 }, { 1, 3 }, { 2, 3 } } };
constexpr std::array<std::array<int, 2>, kEdges> kEdgeOthers{ { { 2, 3 }, { 1, 3 }, { 1, 2 },
  { 0, 3 }, { 0, 2 }, { 0, 1 } } };

/// The edge between two vertices.
constexpr int edgeBetween(int i, int j)
{
  constexpr std::array<std::array<int, 4>, 4> kBetween{ { { -1, 0, 1, 2 }, { 0, -1, 3, 4 },
    { 1, 3, -1, 5 }, { 2, 4, 5, -1 } } };
  return kBetween[i][j];
}

/// Per facet and corner: the edge of the facet opposite the corner.
constexpr auto kOppositeEdge = []
{
  std::array<std::array<int, 3>, 4> edges{};
  for (int k = 0; k < 4; ++k)
  {
    const auto& f = kFacetVertices[k];
    edges[k] = { edgeBetween(f[1], f[2]), edgeBetween(f[2], f[0]), edgeBetween(f[0], f[1]) };
  }
  return edges;
}();

/// 1 + the corner of the triangle that sees the opposite edge at an obtuse angle, or 0; exactly.
unsigned obtuseCorner(const std::array<const Vec3*, 3>& p)
{
  for (unsigned corner = 0; corner < 3; ++corner)
  {
    if (insideDiametralSphere(*p[(corner + 1) % 3], *p[(corner + 2) % 3], *p[corner]))
    {
      return 1 + corner;
    }
  }
  return 0;
}

/// Per facet, two bits: 1 + the corner with an obtuse angle, 0 where there is none.
unsigned obtuseCornersOf(const std::array<Vec3, 4>& p)
{
  std::array<double, kEdges> squares; // of lengths
  for (int e = 0; e < kEdges; ++e)
  {
    const Vec3 along = p[kEdgeEnds[e][1]] - p[kEdgeEnds[e][0]];
    squares[e] = dot(along, along);
  }
  unsigned corners = 0;
  for (int k = 0; k < 4; ++k)
  {
    const auto& opposite = kOppositeEdge[k];
    const double a = squares[opposite[0]];
    const double b = squares[opposite[1]];
    const double c = squares[opposite[2]];
    const double sum = a + b + c;
    const double longest = std::max({ a, b, c });
    const double cosine = sum - 2.0 * longest; // its sign
    unsigned corner = 1U + static_cast<unsigned>(longest != a) * (1U + (longest != b));
    corner &= 0U - static_cast<unsigned>(cosine < 0.0);
    if (isUnsure(cosine, sum)) [[unlikely]]
    {
      const auto& f = kFacetVertices[k];
      corner = obtuseCorner({ &p[f[0]], &p[f[1]], &p[f[2]] });
    }
    corners |= corner << (2 * k);
  }
  return corners;
}

/// From the bits above: the edges, a bit each, that a corner sees at an obtuse angle.
constexpr auto kEdgesSeenObtuse = []
{
  std::array<std::uint8_t, 256> edges{};
  for (unsigned corners = 0; corners < 256; ++corners)
  {
    for (int k = 0; k < 4; ++k)
    {
      const unsigned corner = corners >> (2 * k) & 3U;
      edges[corners] |=
        static_cast<std::uint8_t>(corner == 0 ? 0U : 1U << kOppositeEdge[k][corner - 1]);
    }
  }
  return edges;
}();

/// From a bit per facet: the edges, a bit each, of these facets.
constexpr auto kEdgesOfFacets = []
{
  std::array<std::uint8_t, 16> edges{};
  for (unsigned facets = 0; facets < 16; ++facets)
  {
    for (int e = 0; e < kEdges; ++e)
    {
      const bool has = (facets >> kEdgeOthers[e][0] | facets >> kEdgeOthers[e][1]) & 1U;
      edges[facets] |= static_cast<std::uint8_t>(has ? 1U << e : 0U);
    }
  }
  return edges;
}();

} // namespace

FlowComplex::FlowComplex(const DelaunayComplex& complex, Execution& execution)
  : Complex(complex)
  , Attached(complex.tetCount())
  , Obtuse(complex.tetCount())
{
  execution.step("classify", 0, 1);
  execution.parallelFor(complex.tetCount(), 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t tet = begin; tet < end; ++tet)
      {
        const auto& v = complex.tetrahedra[tet];
        const std::array<Vec3, 4> p{ complex.points[v[0]], complex.points[v[1]],
          complex.points[v[2]], complex.points[v[3]] };
        this->Attached[tet] = static_cast<std::uint8_t>(attachedFacetsOf(p));
        this->Obtuse[tet] = static_cast<std::uint8_t>(obtuseCornersOf(p));
      }
    });
  execution.step("classify", 1, 1);
}

unsigned FlowComplex::edgesSeenObtuse(Index tet) const
{
  return kEdgesSeenObtuse[this->Obtuse[tet]];
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
  const double squared = dot(centre, centre);
  return std::isnan(squared) ? std::numeric_limits<double>::infinity() : squared;
}

double circumradius(const DelaunayComplex& complex, Facet facet)
{
  return std::sqrt(circumradiusSquared(complex, complex.facetVertices(facet)));
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

/// Is the edge critical, and its tetrahedron the first one at it, so that each edge is found once?
/// It is when no vertex around it lies inside its smallest sphere.
bool findsCriticalEdge(const FlowComplex& flow, const CriticalEdge& edge)
{
  const Index first = edge.triangle / 4;
  return flow.delaunay().walkWholeEdge(edge.triangle, edge.apex,
    [&](Facet entering, Facet leaving, Facet)
    {
      const Index tet = entering / 4;
      const auto across = static_cast<unsigned>(
        edgeBetween(static_cast<int>(entering % 4), static_cast<int>(leaving % 4)));
      return tet >= first && !(flow.edgesSeenObtuse(tet) >> (kEdges - 1 - across) & 1U);
    });
}

} // namespace

void forEachCriticalEdge(const FlowComplex& flow, Index tet,
  const std::function<bool(Facet)>& wanted, const std::function<void(const CriticalEdge&)>& visit)
{
  const DelaunayComplex& complex = flow.delaunay();
  unsigned towardsEarlier = 0; // facets
  for (unsigned k = 0; k < 4; ++k)
  {
    towardsEarlier |= static_cast<unsigned>(complex.mirror[tet][k] < 4 * tet) << k;
  }
  const unsigned skipped = kEdgesOfFacets[towardsEarlier] | flow.edgesSeenObtuse(tet);
  const auto& v = complex.tetrahedra[tet];
  for (int e = 0; e < kEdges; ++e)
  {
    if (skipped >> e & 1U)
    {
      continue;
    }
    const Facet triangle = 4 * tet + static_cast<Facet>(kEdgeOthers[e][0]);
    const CriticalEdge edge{ { v[kEdgeEnds[e][0]], v[kEdgeEnds[e][1]] }, triangle,
      v[kEdgeOthers[e][1]] };
    if (wanted(triangle) && findsCriticalEdge(flow, edge))
    {
      visit(edge);
    }
  }
}

std::vector<CriticalEdge> criticalEdges(
  const FlowComplex& flow, Execution& execution, const std::function<bool(Facet)>& wanted)
{
  execution.step("edges", 0, 1);
  return collect<CriticalEdge>(flow.delaunay().tetCount(), execution,
    [&](Index tet, auto& found)
    {
      forEachCriticalEdge(
        flow, tet, wanted, [&](const CriticalEdge& edge) { found.push_back(edge); });
    });
}

} // namespace scan
