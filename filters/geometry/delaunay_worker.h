// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_cells.h"

#include <array>
#include <cstdint>
#include <vector>

namespace scan
{

/// Inserts points one at a time: finds the cells whose circumspheres hold the point and replaces
/// them by the cells between the point and their rim.
/// Bowyer, "Computing Dirichlet tessellations" (1981); Watson (1981).
class DelaunayWorker
{
public:
  /// @param number of the worker, less than 30,000
  DelaunayWorker(DelaunayCells& cells, unsigned number);

  /// While others work: returns false, without a change, when one is in the way or room is short.
  bool insertAmongOthers(Index vertex) { return this->insert(vertex, false); }
  /// While nobody else works: always succeeds.
  void insertAlone(Index vertex) { this->insert(vertex, true); }

private:
  /// Small numbers for the vertices of a cavity, in the order in which they are first met.
  class Numbering
  {
  public:
    static constexpr Index kMost = 64;

    void reset()
    {
      this->Round += std::uint64_t{ 1 } << 32;
      this->Count = 0;
    }
    /// The vertex's number, kMost when there are too many.
    Index operator()(Index vertex);

  private:
    struct Slot
    {
      std::uint64_t key; // round in which it was filled and vertex
      Index number;
    };
    std::array<Slot, 4 * kMost> Slots{};
    std::uint64_t Round = 0; // in the upper half
    Index Count = 0;
  };

  bool insert(Index vertex, bool alone);
  bool acquire(Index cell);
  void setMark(Index cell, std::uint16_t mark);
  bool moveTo(Index& cell, Index next);
  bool acquireHint();
  bool locate(const Vec3& p, Index& found);
  int facetBefore(const DelaunayCell& cell, const Vec3& p, int entered) const;
  bool inConflict(const DelaunayCell& cell, const Vec3& p) const;
  bool findCavity(Index first, const Vec3& p);
  bool haveFreeCells(std::size_t count);
  void fillCavity(Index vertex);
  bool linkThroughTable();
  void linkBySorting();
  Facet& facetAt(Index from, Index to) { return this->FacetAt[Numbering::kMost * from + to]; }
  void release(bool done);

  DelaunayCells& All;
  const std::uint16_t Held;     // mark of cells around the cavity
  const std::uint16_t InCavity; // mark of cells in it
  bool Alone = true;
  Index Hint = 0;
  Numbering NumberOf;
  std::array<Facet, Numbering::kMost * Numbering::kMost> FacetAt; // by the ends of its rim edge
  std::vector<std::array<Index, 3>> Corners; // numbers of the corners of each facet
  std::vector<Index> Free;
  std::vector<Index> Cavity;
  std::vector<Index> Rim;      // cells beside the cavity
  std::vector<Facet> Boundary; // facets of the cavity, seen from inside
  std::vector<Index> Fresh;    // per facet of the boundary: the new cell there
};

} // namespace scan
