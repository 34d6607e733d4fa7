// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/huge_pages.h"
#include "filters/geometry/surface_edit.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace scan
{

/// Where the data of the points of a surface that is refined several times come from.
class RefineBlends
{
public:
  /// @param points of the input
  explicit RefineBlends(Index points)
    : Points(points)
  {
  }

  /// The middle m of the edge a b of a triangle that was put together of halves, and a, and b.
  using Join = std::array<Index, 3>;
  void addJoins(std::span<const Join> joins);

  /// Makes room for so many points, those of the input among them.
  void reserve(std::size_t points) { reserveLarge(this->Blends, points - this->Points); }
  void grow(std::size_t points) { this->Blends.resize(points - this->Points); }

  /// Sets the blend of a new point in the middle between two that have theirs.
  void setMiddle(Index point, Index a, Index b);

  std::vector<PointBlend> take() { return std::move(this->Blends); }

private:
  struct Shares;

  void reduce(Shares& shares) const;
  PointBlend of(Index point) const;
  PointBlend middleOf(const PointBlend& a, const PointBlend& b) const;

  Index Points;
  std::vector<PointBlend> Blends;
  std::vector<Join> Joins; // of points of the input, sorted
};

} // namespace scan
