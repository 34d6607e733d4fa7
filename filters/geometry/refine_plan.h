// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/half_marks.h"
#include "filters/geometry/large_array.h"

#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// The ends of a half-edge, and the corner across.
struct HalfCorners
{
  Index from;
  Index to;
  Index across;
};
inline HalfCorners cornersOf(const TriMesh& mesh, Index half)
{
  const Index k = half % 3;
  const Triangle& corners = mesh.triangles[half / 3];
  return { corners[k], corners[k == 2 ? 0 : k + 1], corners[k == 0 ? 2 : k - 1] };
}

/// The half-edges of an edge, whatever their number.
class EdgeFans
{
public:
  EdgeFans(const TriMesh& mesh, Execution& execution);

  /// That of the other triangle where an edge has two; else kNone.
  Index mate(Index half) const { return this->Pairs.mate[half]; }
  const std::vector<Index>& mates() const { return this->Pairs.mate; }

  /// The next one of the same edge, around and around; itself where there is no other.
  Index next(Index half) const
  {
    const Index mate = this->mate(half);
    return mate != kNone ? mate : this->Crowded.empty() ? half : this->Crowded[half];
  }

private:
  EdgePairs Pairs;
  std::vector<Index> Crowded; // per half-edge of an edge with three triangles or more, the next
};

/// Which triangles are cut, and how.
struct RefinePlan
{
  enum class Cut : std::uint8_t
  {
    none,
    two,
    four,
    join ///< a half that is put together with the other; the whole is cut into four
  };
  std::vector<Cut> cuts;     ///< per triangle
  LargeArray<Index> middles; ///< per half-edge the number of the new point, or kNone
  LargeArray<Index> cutHalf; ///< per new point the first half-edge of its edge
  std::size_t cutInFour = 0; ///< with the wholes of joined halves
  std::size_t cutInTwo = 0;
  std::size_t joined = 0; ///< pairs
};

/// The least that is cut when the chosen triangles are.
/// @param isChosen per triangle 0 or 1
/// @param halves of trustedHalves()
RefinePlan planRefinement(const TriMesh& mesh, const EdgeFans& fans,
  std::span<const std::uint8_t> isChosen, std::span<const std::uint8_t> halves);

/// A part of a triangle.
struct RefinedPart
{
  Triangle corners{};
  std::uint8_t half = 0;    ///< its mark
  std::uint8_t creases = 0; ///< bit k: corner k to k + 1 lies on such an edge of the triangle
};

/// The parts of triangles of a mesh.
class RefinedParts
{
public:
  static constexpr unsigned kMost = 4;

  /// @param creases per triangle a bit for each edge; or empty
  RefinedParts(const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan,
    std::span<const std::uint8_t> halves, std::span<const std::uint8_t> creases);

  unsigned count(Index triangle) const;

  /// Writes them to `parts`, one after the other; returns the end.
  RefinedPart* write(Index triangle, RefinedPart* parts) const;

private:
  std::uint8_t creasesOf(Index t) const { return this->Creases.empty() ? 0 : this->Creases[t]; }
  std::uint8_t halfOf(Index t) const { return this->Halves.empty() ? 0 : this->Halves[t]; }
  /// The new point as one of the refined mesh.
  Index middle(Index half) const
  {
    return static_cast<Index>(this->Mesh.points.size()) + this->Plan.middles[half];
  }
  RefinedPart* writeFour(Index triangle, RefinedPart* parts) const;
  RefinedPart* writeTwo(Index triangle, RefinedPart* parts) const;
  RefinedPart* writeJoined(Index triangle, RefinedPart* parts) const;

  const TriMesh& Mesh;
  const EdgeFans& Fans;
  const RefinePlan& Plan;
  std::span<const std::uint8_t> Halves;
  std::span<const std::uint8_t> Creases;
};

} // namespace scan
