// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/complex_corpus.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

namespace scan::test
{

std::uint64_t testSeed()
{
  const char* text = std::getenv("SCAN_TEST_SEED"); // NOLINT(concurrency-mt-unsafe): one thread
  return text != nullptr ? std::strtoull(text, nullptr, 10) : 20030601;
}

std::vector<PointSet> pointSets(std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto uniform = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
  const auto integer = [&](int n)
  { return static_cast<double>(random() % static_cast<unsigned>(n)); };
  std::vector<PointSet> sets;
  const auto add = [&](const char* name, int count, auto&& makePoint)
  {
    PointSet set{ name, seed, {} };
    for (int i = 0; i < count; ++i)
    {
      set.points.push_back(makePoint(i));
    }
    sets.push_back(std::move(set));
  };
  add("random", 120, [&](int) { return Vec3{ uniform(), uniform(), uniform() }; });
  add("small integers", 150, [&](int) { return Vec3{ integer(5), integer(5), integer(5) }; });
  add("grid", 4 * 4 * 4,
    [&](int i)
    {
      return Vec3{ static_cast<double>(i % 4), static_cast<double>(i / 4 % 4),
        static_cast<double>(i / 16) };
    });
  add("grid far from the origin", 3 * 4 * 5,
    [&](int i) {
      return Vec3{ 5e6 + 0.1 * (i % 3), -3e6 + 0.1 * (i / 3 % 4), 0.1 * (i / 12) };
    });
  // points (a, b, c) with a^2 + b^2 + c^2 = 25 or 50: exactly cospherical
  std::vector<Vec3> sphere;
  for (int a = -7; a <= 7; ++a)
  {
    for (int b = -7; b <= 7; ++b)
    {
      for (int c = -7; c <= 7; ++c)
      {
        if (a * a + b * b + c * c == 50)
        {
          sphere.push_back(
            { static_cast<double>(a), static_cast<double>(b), static_cast<double>(c) });
        }
      }
    }
  }
  add("cospherical", static_cast<int>(sphere.size()), [&](int i) { return sphere[i]; });
  add("two planes", 90, [&](int i) { return Vec3{ integer(8), integer(8), i % 2 ? 3.0 : 0.0 }; });
  add("plane and one point", 40,
    [&](int i) {
      return i == 0 ? Vec3{ 0.3, 0.2, 1.0 } : Vec3{ integer(7), integer(7), 0.0 };
    });
  add("cylinder", 96,
    [&](int i)
    {
      const double angle = 2.0 * 3.14159265358979323846 * (i % 12) / 12.0;
      return Vec3{ std::cos(angle), std::sin(angle), 0.25 * (i / 12) };
    });
  add("sphere with noise", 150,
    [&](int)
    {
      const double z = 2.0 * uniform() - 1.0;
      const double angle = 6.283185307179586 * uniform();
      const double r = 1.0 + 0.05 * (uniform() - 0.5);
      const double s = std::sqrt(1.0 - z * z);
      return Vec3{ r * s * std::cos(angle), r * s * std::sin(angle), r * z };
    });
  add("needle clusters", 100,
    [&](int i) {
      return Vec3{ i % 2 ? 1e-9 * uniform() : 1e3 + uniform(), 1e-9 * uniform(), 1e-3 * uniform() };
    });
  return sets;
}

Simplex sorted(Simplex simplex)
{
  std::sort(simplex.begin(), simplex.end());
  return simplex;
}

std::vector<Simplex> facesOf(const Simplex& simplex)
{
  std::vector<Simplex> faces;
  for (unsigned mask = 1; mask + 1 < (1U << simplex.size()); ++mask)
  {
    Simplex face;
    for (std::size_t i = 0; i < simplex.size(); ++i)
    {
      if (mask >> i & 1U)
      {
        face.push_back(simplex[i]);
      }
    }
    faces.push_back(face);
  }
  return faces;
}

std::vector<Simplex> simplicesOf(const Simplex& lower, const Simplex& upper)
{
  std::vector<Simplex> between = facesOf(upper);
  std::erase_if(between,
    [&](const Simplex& face)
    { return !std::includes(face.begin(), face.end(), lower.begin(), lower.end()); });
  between.push_back(upper);
  return between;
}

std::map<Simplex, Simplex> lowerFaces(const Intervals& intervals)
{
  std::map<Simplex, Simplex> lowerOf;
  for (const auto& [lower, upper] : intervals)
  {
    for (const Simplex& simplex : simplicesOf(lower, upper))
    {
      lowerOf[simplex] = lower;
    }
  }
  return lowerOf;
}

namespace
{

Simplex tetSimplex(const DelaunayComplex& complex, Index tet)
{
  const auto& v = complex.tetrahedra[tet];
  return sorted({ v.begin(), v.end() });
}

Simplex triangleSimplex(const DelaunayComplex& complex, Facet facet)
{
  const Triangle v = complex.facetVertices(facet);
  return sorted({ v.begin(), v.end() });
}

void insertWithFaces(const Simplex& simplex, std::set<Simplex>& into)
{
  into.insert(simplex);
  for (const Simplex& face : facesOf(simplex))
  {
    into.insert(face);
  }
}

} // namespace

std::set<Simplex> allSimplices(const DelaunayComplex& complex)
{
  std::set<Simplex> all;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    insertWithFaces(tetSimplex(complex, tet), all);
  }
  return all;
}

Intervals intervalsOf(const FlowComplex& flow, std::vector<Simplex>* conflicts)
{
  const DelaunayComplex& complex = flow.delaunay();
  Intervals intervals;
  std::set<Simplex> taken;
  const auto add = [&](const Simplex& lower, const Simplex& upper)
  {
    intervals[lower] = upper;
    for (const Simplex& simplex : simplicesOf(lower, upper))
    {
      if (!taken.insert(simplex).second && conflicts != nullptr)
      {
        conflicts->push_back(simplex);
      }
    }
  };
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    const Simplex whole = tetSimplex(complex, tet);
    Simplex lower;
    for (int k = 0; k < 4; ++k) // the vertices opposite attached facets are not in the lower face
    {
      if (!(flow.attachedFacets(tet) >> k & 1U))
      {
        lower.push_back(complex.tetrahedra[tet][k]);
      }
    }
    add(sorted(lower), whole);
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      if (complex.canonical(facet) == facet && flow.isFree(facet))
      {
        const Simplex triangle = triangleSimplex(complex, facet);
        Simplex rest = triangle;
        std::erase(rest, flow.obtuseVertex(facet));
        add(rest, triangle);
      }
    }
  }
  Execution execution(1);
  for (const CriticalEdge& edge : criticalEdges(flow, execution))
  {
    const Simplex simplex = sorted({ edge.vertices[0], edge.vertices[1] });
    add(simplex, simplex);
  }
  for (Index v = 0; v < complex.points.size(); ++v)
  {
    add({ v }, { v });
  }
  return intervals;
}

namespace
{

std::set<Simplex> simplicesWith(const WrapComplex& wrap, const std::vector<CriticalEdge>& lines)
{
  const DelaunayComplex& complex = wrap.flow().delaunay();
  std::set<Simplex> kept;
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    if (wrap.keepsTet(tet))
    {
      insertWithFaces(tetSimplex(complex, tet), kept);
    }
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      if (wrap.keepsTriangle(facet))
      {
        insertWithFaces(triangleSimplex(complex, facet), kept);
      }
    }
  }
  for (const CriticalEdge& line : lines)
  {
    insertWithFaces({ line.vertices[0], line.vertices[1] }, kept);
  }
  for (Index v = 0; v < complex.points.size(); ++v)
  {
    kept.insert({ v });
  }
  return kept;
}

} // namespace

std::set<Simplex> simplicesOf(const WrapComplex& wrap)
{
  Execution execution(1);
  return simplicesWith(wrap, bareEdges(wrap, execution));
}

std::set<Simplex> simplicesOf(const WrapModel& model)
{
  return simplicesWith(*model.current, *model.lines);
}

} // namespace scan::test
