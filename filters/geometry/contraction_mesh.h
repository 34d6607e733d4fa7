// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <vector>

namespace scan
{

/// A mesh whose edges can be contracted, as flat arrays: half-edge 3 t + k runs from corner k to
/// corner k + 1 of triangle t. Points whose triangles are not one fan of oriented triangles are
/// `isSingular`, and nothing at them may be contracted.
class ContractionMesh
{
public:
  ContractionMesh(TriMesh mesh, Execution& execution);

  std::vector<Vec3> points;
  LargeArray<Index> corner; ///< per half-edge where it begins; kNone of triangles gone
  std::vector<Index> mate;  ///< per half-edge the reverse one, kNone at a boundary
  std::vector<Index> out;   ///< per point a half-edge; the first one of a boundary point
  std::vector<std::uint8_t> isSingular;
  std::size_t triangles = 0; ///< that are left

  Index from(Index half) const { return this->corner[half]; }
  Index to(Index half) const { return this->corner[nextHalf(half)]; }
  bool isGone(Index triangle) const { return this->corner[3 * std::size_t{ triangle }] == kNone; }
  bool isBoundary(Index point) const { return this->mate[this->out[point]] == kNone; }

  /// Calls visit(half-edge) for those that leave a point, counter-clockwise.
  template <class Visit>
  void forEachOut(Index point, Visit&& visit) const
  {
    const Index first = this->out[point];
    Index half = first;
    do
    {
      visit(half);
      half = this->mate[previousHalf(half)];
    } while (half != kNone && half != first);
  }

  /// Calls visit(neighbour) for the points around a point.
  template <class Visit>
  void forEachNeighbour(Index point, Visit&& visit) const
  {
    Index last = kNone;
    this->forEachOut(point,
      [&](Index half)
      {
        visit(this->to(half));
        last = half;
      });
    if (const Index closing = previousHalf(last); this->mate[closing] == kNone)
    {
      visit(this->from(closing));
    }
  }

  /// Whether contracting an edge keeps what the surface is: the neighbours that its ends have in
  /// common are those opposite to it (Dey, Edelsbrunner, Guha, Nekhayev 1999), two boundary points
  /// are joined along the boundary only, and something is left.
  bool keepsTopology(Index half);

  /// Contracts an edge that keepsTopology(): its first point goes, the other one stays.
  void contract(Index half);

  /// Closes the gaps that triangles gone have left: the others keep their order.
  /// @param moved called as moved(triangle, its new number), in increasing order
  template <class Moved>
  void compact(Moved&& moved)
  {
    std::vector<Index> number(this->corner.size() / 3, kNone);
    Index count = 0;
    for (Index t = 0; t < number.size(); ++t)
    {
      if (!this->isGone(t))
      {
        moved(t, count);
        number[t] = count++;
      }
    }
    this->renumber(number, count);
  }

private:
  void startFans();
  void renumber(const std::vector<Index>& number, Index count);
  void glue(Index a, Index b);

  std::vector<Index> Stamp; // per point, the last question that met it
  Index Question = 0;
};

} // namespace scan
