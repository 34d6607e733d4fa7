// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_complex.h"

#include "filters/base/error.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using CellBase = CGAL::Triangulation_cell_base_with_info_3<Index, Kernel,
  CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using Point = Kernel::Point_3;

constexpr double kLargestCoordinate = 1e50; // its sixth power is still a double
constexpr Index kMostTetrahedra = kNone / 4;
constexpr std::size_t kGrain = 1 << 14; // cells a task

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

/// A point and its index in the input.
using IndexedPoint = std::pair<Point, Index>;

/// The points along a Hilbert curve.
std::vector<IndexedPoint> sortAlongHilbertCurve(std::span<const Vec3> input, unsigned threads)
{
  std::vector<IndexedPoint> points;
  points.reserve(input.size());
  for (const Vec3& p : input)
  {
    points.emplace_back(Point(p.x, p.y, p.z), static_cast<Index>(points.size()));
  }
  using PointOf = CGAL::First_of_pair_property_map<IndexedPoint>;
  const CGAL::Spatial_sort_traits_adapter_3<Kernel, PointOf> traits;
  if (threads > 1) // the same order, sooner
  {
    CGAL::hilbert_sort<CGAL::Parallel_tag>(points.begin(), points.end(), traits);
  }
  else
  {
    CGAL::hilbert_sort<CGAL::Sequential_tag>(points.begin(), points.end(), traits);
  }
  return points;
}

/// Biased randomized insertion order: rounds of doubling size, each along the Hilbert curve. The
/// coin tosses are a hash of the rank, so that the order depends on the points alone.
int roundOf(Index rank)
{
  std::uint64_t hash = (rank + 1) * 0x9E3779B97F4A7C15ULL;
  hash = (hash ^ (hash >> 30)) * 0xBF58476D1CE4E5B9ULL;
  hash ^= hash >> 27;
  constexpr int kBitsPerRound = 3; // each round eight times the one before
  int round = 0;
  while (round < 8 && (hash & ((1U << kBitsPerRound) - 1)) == 0)
  {
    hash >>= kBitsPerRound;
    ++round;
  }
  return round;
}

std::vector<Index> insertionRanks(std::size_t count)
{
  std::vector<std::vector<Index>> rounds(9);
  for (Index rank = 0; rank < count; ++rank)
  {
    rounds[roundOf(rank)].push_back(rank);
  }
  std::vector<Index> ranks;
  ranks.reserve(count);
  for (auto round = rounds.rbegin(); round != rounds.rend(); ++round)
  {
    ranks.insert(ranks.end(), round->begin(), round->end());
  }
  return ranks;
}

/// Inserts all points; returns per Hilbert rank the smallest input index of the points merged into
/// it, kNone where the rank's point was merged into another.
std::vector<Index> insertPoints(
  Triangulation& triangulation, const std::vector<IndexedPoint>& points, Execution& execution)
{
  std::vector<Index> firstIndex(points.size(), kNone);
  Triangulation::Cell_handle hint;
  std::size_t done = 0;
  for (const Index rank : insertionRanks(points.size()))
  {
    if (done++ % 1024 == 0)
    {
      execution.step("triangulate", done, points.size() + points.size() / 4);
    }
    const auto& [point, index] = points[rank];
    Triangulation::Locate_type located{};
    int i = 0;
    int j = 0;
    const auto cell = triangulation.locate(point, located, i, j, hint);
    if (located == Triangulation::VERTEX)
    {
      Index& first = firstIndex[cell->vertex(i)->info()];
      first = std::min(first, index);
      continue;
    }
    const auto vertex = triangulation.insert(point, located, cell, i, j);
    vertex->info() = rank;
    firstIndex[rank] = index;
    hint = vertex->cell();
  }
  return firstIndex;
}

/// Gives the vertices their final numbers: the rank among the distinct points.
void numberVertices(Triangulation& triangulation, const std::vector<Index>& firstIndex,
  std::span<const Vec3> input, DelaunayComplex& complex)
{
  std::vector<Index> number(firstIndex.size(), kNone);
  complex.points.reserve(triangulation.number_of_vertices());
  complex.scanPoint.reserve(triangulation.number_of_vertices());
  for (std::size_t rank = 0; rank < firstIndex.size(); ++rank)
  {
    if (firstIndex[rank] != kNone)
    {
      number[rank] = static_cast<Index>(complex.points.size());
      complex.points.push_back(input[firstIndex[rank]]);
      complex.scanPoint.push_back(firstIndex[rank]);
    }
  }
  complex.duplicates = static_cast<Index>(input.size() - complex.points.size());
  for (const auto vertex : triangulation.finite_vertex_handles())
  {
    vertex->info() = number[vertex->info()];
  }
}

using Cells = LargeArray<Triangulation::Cell_handle>;

/// Numbers the finite cells by their smallest vertex (counting sort): each cell's info becomes its
/// number, kNone for infinite cells. Returns all cells in the order of the triangulation.
Cells numberCells(Triangulation& triangulation, std::size_t vertexCount, Execution& execution)
{
  Cells cells;
  cells.reserve(triangulation.number_of_cells());
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
  {
    cells.push_back(cell);
  }
  LargeArray<Index> number(cells.size());
  execution.parallelFor(cells.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto cell = cells[i];
        number[i] = triangulation.is_infinite(cell)
          ? kNone
          : std::min({ cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
              cell->vertex(3)->info() });
      }
    });
  std::vector<Index> next(vertexCount + 1, 0);
  for (const Index smallestVertex : number)
  {
    next[smallestVertex + 1] += smallestVertex != kNone; // kNone + 1 is 0: nothing is added
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (Index& n : number)
  {
    n = n == kNone ? kNone : next[n]++;
  }
  execution.parallelFor(cells.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        cells[i]->info() = number[i];
      }
    });
  return cells;
}

void copyCells(const Cells& cells, DelaunayComplex& complex, Execution& execution)
{
  execution.parallelFor(cells.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto cell = cells[i];
        const Index tet = cell->info();
        for (Facet k = 0; tet != kNone && k < 4; ++k)
        {
          complex.tetrahedra[tet][k] = cell->vertex(static_cast<int>(k))->info();
          const auto neighbour = cell->neighbor(static_cast<int>(k));
          const Index beyond = neighbour->info();
          if (beyond == kNone)
          {
            complex.mirror[tet][k] = kNone;
          }
          else if (beyond > tet) // each pair once
          {
            const auto back = static_cast<Facet>(neighbour->index(cell));
            complex.mirror[tet][k] = 4 * beyond + back;
            complex.mirror[beyond][back] = 4 * tet + k;
          }
        }
      }
    });
}

} // namespace

DelaunayComplex buildDelaunayComplex(std::span<const Vec3> input, Execution& execution)
{
  checkCoordinates(input);
  execution.step("triangulate", 0, 1);
  std::vector<IndexedPoint> points = sortAlongHilbertCurve(input, execution.threads());

  Triangulation triangulation;
  const std::vector<Index> firstIndex = insertPoints(triangulation, points, execution);
  if (triangulation.dimension() < 3)
  {
    static constexpr const char* kShape[] = { "there is no point", "all points are equal",
      "all points lie on one line", "all points lie in one plane" };
    throw Error(ErrorCode::badInput,
      std::string(kShape[triangulation.dimension() + 1]) +
        "; a surface in space needs at least four points that are not in one plane");
  }
  if (triangulation.number_of_finite_cells() > kMostTetrahedra)
  {
    throw Error(ErrorCode::limit, "more than 2^30 tetrahedra; thin the scan first");
  }
  std::vector<IndexedPoint>().swap(points);

  DelaunayComplex complex;
  numberVertices(triangulation, firstIndex, input, complex);
  execution.step("triangulate", 9, 10);
  complex.tetrahedra.resize(triangulation.number_of_finite_cells());
  complex.mirror.resize(complex.tetrahedra.size());
  copyCells(numberCells(triangulation, complex.points.size(), execution), complex, execution);
  execution.step("triangulate", 1, 1);
  return complex;
}

} // namespace scan
