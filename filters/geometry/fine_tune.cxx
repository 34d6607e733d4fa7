// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/fine_tune.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/cut_cover.h"
#include "filters/geometry/scan_spacing.h"

#include <algorithm>
#include <array>
#include <bit>

namespace scan
{
namespace
{

constexpr double kExcessWeight = 0.2;
constexpr double kNonManifoldWeight = 0.5;
constexpr double kLeastGain = 1e-9;

class FineTuning
{
public:
  FineTuning(const DelaunayComplex& complex, const std::vector<float>& spacing,
    std::vector<std::uint8_t> inside)
    : Complex(complex)
    , Spacing(spacing)
    , Inside(std::move(inside))
    , Cover(complex.points.size())
    , Queued(complex.tetCount(), 0)
  {
    for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
    {
      if (this->Inside[facet / 4] && this->isCut(facet)) // each cut triangle once
      {
        this->Cover.count(complex.facetVertices(facet), +1);
      }
    }
  }

  /// The tetrahedra whose flip would pay now.
  std::vector<Index> findCandidates(Execution& execution) const
  {
    return collect<Index>(this->Complex.tetCount(), execution,
      [this](Index tet, std::vector<Index>& found)
      {
        if (this->gain(tet) > kLeastGain)
        {
          found.push_back(tet);
        }
      });
  }

  /// Flips those candidates that still pay; returns the tetrahedra around the flipped ones.
  std::vector<Index> flipCandidates(const std::vector<Index>& candidates)
  {
    std::vector<Index> around;
    for (const Index tet : candidates)
    {
      this->Queued[tet] = 0;
      if (this->gain(tet) > kLeastGain)
      {
        this->flip(tet);
        for (const Index v : this->Complex.tetrahedra[tet])
        {
          this->queueStar(tet, v, around);
        }
      }
    }
    return around;
  }

  std::vector<std::uint8_t> takeLabels() { return std::move(this->Inside); }

private:
  bool isCut(Facet facet) const
  {
    const Index beyond = this->Complex.neighbour(facet / 4, static_cast<int>(facet % 4));
    return this->Inside[facet / 4] != (beyond == kNone ? 0 : this->Inside[beyond]);
  }

  unsigned cutFacets(Index tet) const // bit k: facet k is cut
  {
    unsigned cut = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      cut |= static_cast<unsigned>(this->isCut(4 * tet + k)) << k;
    }
    return cut;
  }

  /// What the objective gains by flipping the tetrahedron.
  double gain(Index tet) const
  {
    const unsigned cut = this->cutFacets(tet);
    if (cut == 0)
    {
      return 0.0;
    }
    const int count = std::popcount(cut);
    int points = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      // of the three facets at vertex k those that are cut leave the cut, the others enter
      const int leave = std::popcount(cut & ~(1U << k));
      const int before = this->Cover.cutTriangles(this->Complex.tetrahedra[tet][k]);
      points += (before + 3 - 2 * leave > 0) - (before > 0);
    }
    double gain = 2.0 * points - 0.5 * (4 - 2 * count);
    // only edges between two cut facets can stop being non-manifold: none, 1, 3 or 6 of them
    constexpr std::array kEdgesBetween{ 0, 0, 1, 3, 6 };
    const double most = gain + kNonManifoldWeight * kEdgesBetween[count];
    double excessLost = 0.0;
    double excessMade = 0.0;
    for (unsigned k = 0; k < 4; ++k)
    {
      if (cut >> k & 1U)
      {
        excessLost += this->excess(4 * tet + k);
      }
    }
    if (most + kExcessWeight * excessLost <= kLeastGain)
    {
      return 0.0;
    }
    for (unsigned k = 0; k < 4; ++k)
    {
      if (!(cut >> k & 1U))
      {
        excessMade += this->excess(4 * tet + k);
      }
    }
    const double change = kExcessWeight * (excessLost - excessMade);
    if (most + change <= kLeastGain)
    {
      return 0.0;
    }
    return gain + change - kNonManifoldWeight * this->nonManifoldEdgesMade(tet, cut);
  }

  double excess(Facet facet) const
  {
    return static_cast<double>(
      excessSize(this->Complex, this->Spacing, this->Complex.facetVertices(facet)));
  }

  /// Change in the number of edges with more than two cut triangles.
  int nonManifoldEdgesMade(Index tet, unsigned cut) const
  {
    int made = 0;
    for (unsigned i = 0; i < 4; ++i)
    {
      for (unsigned j = i + 1; j < 4; ++j)
      {
        // the edge between facets i and j gains or loses two cut triangles, or swaps one
        const unsigned both = (cut >> i & 1U) + (cut >> j & 1U);
        if (both != 1)
        {
          const int before = this->cutTrianglesAround(tet, i, j);
          const int after = both == 2 ? before - 2 : before + 2;
          made += (after > 2) - (before > 2);
        }
      }
    }
    return made;
  }

  /// Number of cut triangles at the edge that facets i and j of the tetrahedron share.
  int cutTrianglesAround(Index tet, unsigned i, unsigned j) const
  {
    const Facet start = 4 * tet + i;
    int count = this->isCut(start) ? 1 : 0;
    this->Complex.walkWholeEdge(start, this->Complex.tetrahedra[tet][j],
      [&](Facet, Facet leaving, Facet beyond)
      {
        if (leaving != start && beyond != start && this->isCut(leaving))
        {
          ++count;
        }
        return true;
      });
    return count;
  }

  void flip(Index tet)
  {
    const unsigned cut = this->cutFacets(tet);
    for (unsigned k = 0; k < 4; ++k)
    {
      const int leave = std::popcount(cut & ~(1U << k));
      this->Cover.count(this->Complex.tetrahedra[tet][k], 3 - 2 * leave);
    }
    this->Inside[tet] ^= 1U;
  }

  /// Appends the tetrahedra at vertex v that are not queued yet.
  void queueStar(Index tet, Index v, std::vector<Index>& queue)
  {
    this->Star.assign(1, tet);
    for (std::size_t next = 0; next < this->Star.size(); ++next)
    {
      const Index at = this->Star[next];
      if (!(this->Queued[at] & kQueued))
      {
        this->Queued[at] |= kQueued;
        queue.push_back(at);
      }
      this->Queued[at] |= kSeen;
      for (int k = 0; k < 4; ++k)
      {
        const Index beyond = this->Complex.neighbour(at, k);
        if (this->Complex.tetrahedra[at][k] != v && beyond != kNone &&
          !(this->Queued[beyond] & kSeen))
        {
          this->Queued[beyond] |= kSeen;
          this->Star.push_back(beyond);
        }
      }
    }
    for (const Index at : this->Star)
    {
      this->Queued[at] &= static_cast<std::uint8_t>(~kSeen);
    }
  }

  static constexpr std::uint8_t kQueued = 1;
  static constexpr std::uint8_t kSeen = 2;

  const DelaunayComplex& Complex;
  const std::vector<float>& Spacing;
  std::vector<std::uint8_t> Inside;
  CutCover Cover;
  std::vector<std::uint8_t> Queued;
  std::vector<Index> Star;
};

} // namespace

std::vector<std::uint8_t> fineTune(const FlowComplex& flow, const std::vector<float>& spacing,
  std::vector<std::uint8_t> inside, Execution& execution)
{
  execution.step("fine-tune", 0, 3);
  FineTuning tuning(flow.delaunay(), spacing, std::move(inside));
  execution.step("fine-tune", 1, 3);
  std::vector<Index> candidates = tuning.findCandidates(execution);
  while (!candidates.empty())
  {
    execution.step("fine-tune", 2, 3);
    candidates = tuning.flipCandidates(candidates);
  }
  execution.step("fine-tune", 3, 3);
  return tuning.takeLabels();
}

} // namespace scan
