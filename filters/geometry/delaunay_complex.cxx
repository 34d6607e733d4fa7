// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_complex.h"

#include "filters/base/error.h"
#include "filters/geometry/delaunay_insertion.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/hilbert_order.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>

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

/// A tetrahedron on its way to its number.
struct NamedCell
{
  Index cell;
  std::uint32_t places;          ///< two bits per vertex of the cell: its place in `vertices`
  std::array<Index, 4> vertices; ///< ascending, then perhaps the last two exchanged
  std::uint64_t middle;          ///< vertices 1 and 2: the first 0 is that of the bucket

  NamedCell(const DelaunayCell& original, Index number)
    : cell(number)
    , places(0)
  {
    std::array<std::uint64_t, 4> from; // vertex and its place in the cell
    for (unsigned k = 0; k < 4; ++k)
    {
      from[k] = std::uint64_t{ original.vertices[k] } << 2 | k;
    }
    bool odd = false;
    const auto sort = [&](int a, int b)
    {
      const std::uint64_t low = std::min(from[a], from[b]);
      odd ^= from[a] != low;
      from[b] = std::max(from[a], from[b]);
      from[a] = low;
    };
    sort(0, 1);
    sort(2, 3);
    sort(0, 2);
    sort(1, 3);
    sort(1, 2);
    if (odd) // keeps the orientation
    {
      std::swap(from[2], from[3]);
    }
    for (unsigned k = 0; k < 4; ++k)
    {
      this->vertices[k] = static_cast<Index>(from[k] >> 2);
      this->places |= k << (2 * (from[k] & 3U));
    }
    this->middle = std::uint64_t{ this->vertices[1] } << 32 | this->vertices[2];
  }

  /// For cells with the same smallest vertex.
  bool operator<(const NamedCell& other) const
  {
    return this->middle != other.middle ? this->middle < other.middle
                                        : this->vertices[3] < other.vertices[3];
  }
};

/// The number of a cell in the complex and where its vertices have gone.
struct CellName
{
  Index number;
  std::uint32_t places;

  /// The facet's name; kNone at infinity.
  Facet facet(Facet k) const
  {
    return this->number == kNone ? kNone : 4 * this->number + (this->places >> (2 * k) & 3U);
  }
};

/// The tetrahedra filed under their smallest vertex.
struct CellsByVertex
{
  std::vector<Index> begin; ///< per vertex, and the end
  LargeArray<Index> cells;
};

/// Also sets the number of all other cells to kNone.
CellsByVertex fileUnderSmallestVertex(
  const DelaunayCells& all, LargeArray<CellName>& names, Execution& execution)
{
  execution.parallelFor(names.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto& v = all.cells[i].vertices;
        names[i].number =
          all.cells[i].isTetrahedron() ? std::min({ v[0], v[1], v[2], v[3] }) : kNone;
      }
    });
  CellsByVertex filed;
  // counted two places ahead, so that filing leaves begin[] right where it belongs
  filed.begin.assign(all.points.size() + 2, 0);
  for (const CellName& name : names)
  {
    if (name.number != kNone)
    {
      ++filed.begin[name.number + 2];
    }
  }
  std::partial_sum(filed.begin.begin(), filed.begin.end(), filed.begin.begin());
  filed.cells.resize(filed.begin.back());
  for (Index cell = 0; cell < names.size(); ++cell)
  {
    if (names[cell].number != kNone)
    {
      filed.cells[filed.begin[names[cell].number + 1]++] = cell;
    }
  }
  filed.begin.pop_back();
  return filed;
}

/// Cells are scattered over memory: fetches one of the next, before `end`.
void prefetch(
  const DelaunayCells& all, const LargeArray<Index>& order, std::size_t current, std::size_t end)
{
  constexpr std::size_t kAhead = 16;
  if (current + kAhead < end)
  {
    __builtin_prefetch(&all.cells[order[current + kAhead]]);
  }
}

/// Numbers the tetrahedra by their sorted vertices, whatever their order in the triangulation.
void copyCells(const DelaunayCells& all, DelaunayComplex& complex, Execution& execution)
{
  LargeArray<CellName> names(all.used());
  CellsByVertex filed = fileUnderSmallestVertex(all, names, execution);
  complex.tetrahedra.resize(filed.cells.size());
  execution.parallelFor(complex.points.size(), kGrain / 8,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<NamedCell> bucket;
      for (std::size_t vertex = begin; vertex < end; ++vertex)
      {
        bucket.clear();
        for (Index i = filed.begin[vertex]; i < filed.begin[vertex + 1]; ++i)
        {
          prefetch(all, filed.cells, i, filed.begin[end]);
          bucket.emplace_back(all.cells[filed.cells[i]], filed.cells[i]);
        }
        std::sort(bucket.begin(), bucket.end());
        Index tet = filed.begin[vertex];
        for (const NamedCell& named : bucket)
        {
          complex.tetrahedra[tet] = named.vertices;
          filed.cells[tet] = named.cell;
          names[named.cell] = { tet, named.places };
          ++tet;
        }
      }
    });
  complex.mirror.resize(filed.cells.size());
  execution.parallelFor(complex.mirror.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t tet = begin; tet < end; ++tet)
      {
        prefetch(all, filed.cells, tet, end);
        const Index cell = filed.cells[tet];
        for (Facet k = 0; k < 4; ++k)
        {
          const Facet beyond = all.cells[cell].mirror[k];
          complex.mirror[tet][names[cell].facet(k) % 4] = names[beyond / 4].facet(beyond % 4);
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

bool isWhole(const DelaunayComplex& complex, Execution& execution)
{
  const std::size_t tets = complex.tetrahedra.size();
  const auto points = static_cast<Index>(complex.points.size());
  if (complex.mirror.size() != tets || complex.scanPoint.size() != complex.points.size() ||
    tets > kNone / 4 || complex.points.size() >= kNone)
  {
    return false;
  }
  const auto sortedVertices = [&](Facet facet)
  {
    Triangle vertices = complex.facetVertices(facet);
    std::ranges::sort(vertices);
    return vertices;
  };
  const auto fits = [&](Facet facet)
  {
    const Facet other = complex.mirror[facet / 4][facet % 4];
    return other == kNone ||
      (other < 4 * tets && other / 4 != facet / 4 &&
        complex.mirror[other / 4][other % 4] == facet &&
        sortedVertices(other) == sortedVertices(facet));
  };
  std::atomic<bool> isWhole = std::ranges::all_of(complex.points, isFinite);
  const auto forEachTet = [&](const auto& holds)
  {
    execution.parallelFor(tets, kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t tet = begin; tet < end; ++tet)
        {
          if (!holds(static_cast<Index>(tet)))
          {
            isWhole = false;
          }
        }
      });
    return isWhole.load();
  };
  return forEachTet(
           [&](Index tet)
           {
             std::array<Index, 4> v = complex.tetrahedra[tet];
             std::ranges::sort(v);
             return v[0] < v[1] && v[1] < v[2] && v[2] < v[3] && v[3] < points;
           }) &&
    forEachTet([&](Index tet)
      { return fits(4 * tet) && fits(4 * tet + 1) && fits(4 * tet + 2) && fits(4 * tet + 3); });
}

} // namespace scan
