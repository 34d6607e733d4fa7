// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"
#include "filters/geometry/large_array.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// A cell of a triangulation that grows: a tetrahedron, or what is between a triangle of the hull
/// and infinity, or free.
struct DelaunayCell
{
  static constexpr Index kInfinity = kNone - 1; ///< as a vertex; always the last one of a cell

  std::array<Index, 4> vertices;
  std::array<Facet, 4> mirror; ///< as in DelaunayComplex, never kNone

  bool isFree() const { return this->vertices[3] == kNone; }
  bool isTetrahedron() const { return this->vertices[3] < kInfinity; }
  void setFree() { this->vertices[3] = kNone; }
};

/// The cells of a Delaunay triangulation that several workers enlarge at the same time.
///
/// Who holds the mark of a cell may read and change it, and read the vertices of its neighbours,
/// which nobody can remove then. Free cells are always held.
class DelaunayCells
{
public:
  /// The triangulation of four points that are not in one plane, in any order.
  DelaunayCells(std::span<const Vec3> points, std::array<Index, 4> corners);

  std::span<const Vec3> points;     ///< distinct
  LargeArray<DelaunayCell> cells;   ///< the first used() of them
  std::vector<std::uint16_t> marks; ///< per cell: 0, or of the worker that holds it

  Index used() const { return this->Used.load(std::memory_order_relaxed); }

  static constexpr Index kBlock = 128;
  /// The first of kBlock new free cells, kNone when there is no room for them.
  Index takeBlock();
  /// Makes room for `more` cells; only while no worker is at work.
  /// @throws Error limit beyond 2^30.
  void makeRoom(std::size_t more);

private:
  std::atomic<Index> Used{ 0 };
};

} // namespace scan
