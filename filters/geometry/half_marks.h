// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// How the two halves of a triangle (a, b, c) that was cut at the middle m of its edge a b say so:
/// the first, (a, m, c), and the second, (m, b, c), whatever the corner that they begin with.
/// A mark is 0 for a triangle that is no half, else 1 + 2 (corner that is m) + (1 for the second).
inline std::uint8_t halfMark(Index middle, bool isSecond)
{
  return static_cast<std::uint8_t>(1U + 2U * middle + (isSecond ? 1U : 0U));
}
inline Index middleOf(std::uint8_t mark)
{
  return (mark - Index{ 1 }) / 2;
}
inline bool isSecondHalf(std::uint8_t mark)
{
  return mark % 2 == 0;
}

/// The half-edge between the two, m c or c m.
inline Index seamOf(Index triangle, std::uint8_t mark)
{
  return 3 * triangle + (middleOf(mark) + (isSecondHalf(mark) ? 2 : 0)) % 3;
}

/// The marks that can be trusted, 0 for all others: both halves are there, face the same way, and
/// the middle is in the middle. So marks may outlive changes of the mesh that know nothing of them.
/// @param marks per triangle, any values; or empty: none
/// @param mate of pairEdges()
/// @return per triangle; empty where there is none
std::vector<std::uint8_t> trustedHalves(
  const TriMesh& mesh, std::span<const std::uint8_t> marks, std::span<const Index> mate);

} // namespace scan
