// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_complex.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_insertion.h"
#include "filters/geometry/hilbert_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

namespace scan
{
namespace
{

constexpr double kLargestCoordinate = 1e50; // its sixth power is still a double
constexpr std::size_t kGrain = 1 << 14;     // cells a task

void checkCoordinates(std::span<const Vec3> points)
{
  if (points.size() >= kNone / 32)
  {
    throw Error(ErrorCode::limit,
      std::to_string(points.size()) + " points are more than the " +
        std::to_string(kNone / 32 - 1) + " that fit; thin the scan first");
  }
  const auto usable = [](double c) { return std::abs(c) <= kLargestCoordinate; }; // false for NaN
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3& p = points[i];
    if (!usable(p.x) || !usable(p.y) || !usable(p.z))
    {
      throw Error(ErrorCode::badInput,
        "point " + std::to_string(i) +
          " has a coordinate that is not finite or beyond 1e50; remove it first");
    }
  }
}

/// The distinct points along a Hilbert curve.
void numberVertices(std::span<const Vec3> input, DelaunayComplex& complex, Execution& execution)
{
  complex.scanPoint = hilbertOrder(input, execution);
  const auto last = std::unique(complex.scanPoint.begin(), complex.scanPoint.end(),
    [&](Index a, Index b) { return input[a] == input[b]; });
  complex.duplicates = static_cast<Index>(complex.scanPoint.end() - last);
  complex.scanPoint.erase(last, complex.scanPoint.end());
  complex.points.reserve(complex.scanPoint.size());
  for (const Index i : complex.scanPoint)
  {
    complex.points.push_back(input[i]);
  }
}

/// A cell with its vertices in the order of the complex.
struct NamedCell
{
  std::array<Index, 4> vertices;
  Index cell;
  std::uint8_t places; ///< two bits per vertex of the cell: its place in `vertices`

  NamedCell(const DelaunayCell& original, Index number)
    : cell(number)
    , places(0)
  {
    std::array<std::uint64_t, 4> from{}; // vertex and its place in the cell
    for (unsigned k = 0; k < 4; ++k)
    {
      from[k] = std::uint64_t{ original.vertices[k] } << 2 | k;
    }
    bool even = true;
    const auto sort = [&](int a, int b)
    {
      even ^= from[b] < from[a];
      std::tie(from[a], from[b]) = std::minmax({ from[a], from[b] });
    };
    sort(0, 1);
    sort(2, 3);
    sort(0, 2);
    sort(1, 3);
    sort(1, 2);
    if (!even) // keeps the orientation
    {
      std::swap(from[2], from[3]);
    }
    for (unsigned k = 0; k < 4; ++k)
    {
      this->vertices[k] = static_cast<Index>(from[k] >> 2);
      this->places |= static_cast<std::uint8_t>(k << (2 * (from[k] & 3U)));
    }
  }
};

/// The tetrahedra filed under their smallest vertex.
struct CellsByVertex
{
  std::vector<Index> begin; ///< per vertex, and the end
  LargeArray<Index> cells;
};

CellsByVertex fileUnderSmallestVertex(const DelaunayCells& all, Execution& execution)
{
  LargeArray<Index> smallest(all.used());
  execution.parallelFor(smallest.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto& v = all.cells[i].vertices;
        smallest[i] = all.cells[i].isTetrahedron() ? std::min({ v[0], v[1], v[2], v[3] }) : kNone;
      }
    });
  CellsByVertex filed;
  // counted two places ahead, so that filing leaves begin[] right where it belongs
  filed.begin.assign(all.points.size() + 2, 0);
  for (const Index vertex : smallest)
  {
    if (vertex != kNone)
    {
      ++filed.begin[vertex + 2];
    }
  }
  std::partial_sum(filed.begin.begin(), filed.begin.end(), filed.begin.begin());
  filed.cells.resize(filed.begin.back());
  for (Index cell = 0; cell < smallest.size(); ++cell)
  {
    if (smallest[cell] != kNone)
    {
      filed.cells[filed.begin[smallest[cell] + 1]++] = cell;
    }
  }
  filed.begin.pop_back();
  return filed;
}

/// Numbers the tetrahedra by their sorted vertices, whatever their order in the triangulation.
void copyCells(const DelaunayCells& all, DelaunayComplex& complex, Execution& execution)
{
  CellsByVertex filed = fileUnderSmallestVertex(all, execution);
  complex.tetrahedra.resize(filed.cells.size());
  complex.mirror.resize(filed.cells.size());
  LargeArray<Index> number(all.used());
  LargeArray<std::uint8_t> places(all.used());
  execution.parallelFor(complex.points.size(), kGrain / 8,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<NamedCell> bucket;
      for (std::size_t vertex = begin; vertex < end; ++vertex)
      {
        bucket.clear();
        for (Index i = filed.begin[vertex]; i < filed.begin[vertex + 1]; ++i)
        {
          bucket.emplace_back(all.cells[filed.cells[i]], filed.cells[i]);
        }
        std::sort(bucket.begin(), bucket.end(),
          [](const NamedCell& a, const NamedCell& b) { return a.vertices < b.vertices; });
        Index tet = filed.begin[vertex];
        for (const NamedCell& named : bucket)
        {
          complex.tetrahedra[tet] = named.vertices;
          filed.cells[tet] = named.cell;
          places[named.cell] = named.places;
          number[named.cell] = tet++;
        }
      }
    });
  execution.parallelFor(complex.mirror.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      const auto placeOf = [&](Index cell, Facet k) { return places[cell] >> (2 * k) & 3U; };
      for (std::size_t tet = begin; tet < end; ++tet)
      {
        const Index cell = filed.cells[tet];
        for (Facet k = 0; k < 4; ++k)
        {
          const Facet other = all.cells[cell].mirror[k];
          const Index beyond = other / 4;
          complex.mirror[tet][placeOf(cell, k)] = all.cells[beyond].isTetrahedron()
            ? 4 * number[beyond] + placeOf(beyond, other % 4)
            : kNone;
        }
      }
    });
}

} // namespace

DelaunayComplex buildDelaunayComplex(std::span<const Vec3> input, Execution& execution)
{
  checkCoordinates(input);
  execution.step("triangulate", 0, 1);
  DelaunayComplex complex;
  numberVertices(input, complex, execution);
  const std::unique_ptr<DelaunayCells> cells = insertPoints(complex.points, execution);
  copyCells(*cells, complex, execution);
  execution.step("triangulate", 1, 1);
  return complex;
}

} // namespace scan
