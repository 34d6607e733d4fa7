// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/fine_tune.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/cut_cover.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/triangle_size.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <limits>
#include <span>

namespace scan
{
namespace
{

constexpr double kExcessWeight = 0.2;
constexpr double kNonManifoldWeight = 0.5;
constexpr double kRimWeight = 1.0; // an edge where the cut ends at the hull
constexpr double kLeastGain = 1e-9;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Number of facets in a set of up to four: less than a call where the machine may not count bits.
int countOf(unsigned facets)
{
  constexpr std::array<std::int8_t, 16> kBits{ 0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4 };
  return kBits[facets];
}

class FineTuning
{
public:
  FineTuning(const DelaunayComplex& complex, const std::vector<float>& spacing,
    const OutsideRooms& outside, std::vector<std::uint8_t> inside, Execution& execution)
    : Complex(complex)
    , Spacing(spacing)
    , Outside(outside)
    , Inside(std::move(inside))
    , Cover(Complex.points.size())
    , Queued(Complex.tetCount(), 0)
    , Cut(cutTriangles(Complex, Outside, Inside, execution))
  {
    for (const Facet facet : this->Cut)
    {
      this->Cover.count(this->Complex.facetVertices(facet), +1);
    }
  }

  /// The tetrahedra whose flip would pay now.
  std::vector<Index> findCandidates(Execution& execution)
  {
    for (const Facet facet : this->Cut)
    {
      this->Queued[facet / 4] = kQueued;
      if (const Facet other = this->Complex.mirror[facet / 4][facet % 4]; other != kNone)
      {
        this->Queued[other / 4] = kQueued;
      }
    }
    return collect<Index>(this->Complex.tetCount(), execution,
      [this](Index tet, std::vector<Index>& found)
      {
        if (this->Queued[tet] && this->gain(tet, this->cutFacets(tet), kLeastGain) > kLeastGain)
        {
          found.push_back(tet);
        }
        this->Queued[tet] = 0;
      });
  }

  /// Flips those candidates that still pay; returns the tetrahedra around the flipped ones.
  std::vector<Index> flipCandidates(const std::vector<Index>& candidates)
  {
    std::vector<Index> around;
    for (const Index tet : candidates)
    {
      this->Queued[tet] = 0;
      const unsigned cut = this->cutFacets(tet);
      if (cut != 0 && this->gain(tet, cut, kLeastGain) > kLeastGain)
      {
        this->flip(tet);
        this->queueStars(tet, around);
      }
    }
    return around;
  }

  /// The tetrahedra at points that the cut misses.
  std::vector<Index> findMissing(Execution& execution) const
  {
    const Index all = this->Cover.coversAll() ? 0 : this->Complex.tetCount();
    return collect<Index>(all, execution,
      [this](Index tet, std::vector<Index>& found)
      {
        if (this->missesPoint(tet))
        {
          found.push_back(tet);
        }
      });
  }

  /// The tetrahedra around edges with more than two cut triangles. Seen from inside the directed
  /// edges of a manifold are all different.
  std::vector<Index> findCrowded(Execution& execution)
  {
    this->updateCut(execution);
    const std::vector<Triangle> outward = this->outwardTriangles(execution);
    const Incidence edgesFrom(this->Complex.points.size(), outward.size(),
      [&](std::size_t i, auto&& visit)
      {
        const Triangle& v = outward[i];
        for (int k = 0; k < 3; ++k)
        {
          if (v[k] < v[(k + 1) % 3])
          {
            visit(v[k]);
          }
        }
      });
    const auto after = [&](Index i, Index from, int steps)
    {
      const Triangle& v = outward[i];
      const int k = v[0] == from ? 0 : v[1] == from ? 1 : 2;
      return v[(k + steps) % 3];
    };
    return collect<Index>(static_cast<Index>(edgesFrom.owners()), execution,
      [&](Index from, std::vector<Index>& found)
      {
        const std::span<const Index> triangles = edgesFrom.of(from);
        for (auto i = triangles.begin(); i != triangles.end(); ++i)
        {
          const Index to = after(*i, from, 1);
          if (std::any_of(
                triangles.begin(), i, [&](Index other) { return after(other, from, 1) == to; }))
          {
            this->appendAround(this->Cut[*i], after(*i, from, 2), found);
          }
        }
      });
  }

  /// Flips pairs of neighbours with one label where that pays, as long as `isWanted` by the first;
  /// returns what is around them.
  template <class Wanted>
  std::vector<Index> flipPairs(const std::vector<Index>& tets, Wanted&& isWanted)
  {
    std::vector<Index> around;
    for (const Index tet : tets)
    {
      for (int k = 0; k < 4 && isWanted(tet); ++k)
      {
        const Index beyond = this->Complex.neighbour(tet, k);
        if (beyond != kNone && this->Inside[tet] == this->Inside[beyond] &&
          (this->touchesCut(tet) || this->touchesCut(beyond)) && this->flipPair(tet, beyond))
        {
          this->queueStars(tet, around);
          this->queueStars(beyond, around);
        }
      }
    }
    return around;
  }

  bool missesPoint(Index tet) const
  {
    const auto& v = this->Complex.tetrahedra[tet];
    return std::any_of(
      v.begin(), v.end(), [this](Index point) { return this->Cover.cutTriangles(point) == 0; });
  }

  FineTuned takeResult(Execution& execution)
  {
    this->updateCut(execution);
    return { std::move(this->Inside), std::move(this->Cut) };
  }

private:
  /// Brings the list of cut triangles up to date after flips.
  void updateCut(Execution& execution)
  {
    std::vector<Facet> entered;
    for (const Index tet : this->Flipped)
    {
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        if (this->isCut(facet))
        {
          entered.push_back(this->nameInside(facet));
        }
      }
    }
    if (this->Flipped.empty())
    {
      return;
    }
    this->Flipped.clear();
    std::sort(entered.begin(), entered.end());
    entered.erase(std::unique(entered.begin(), entered.end()), entered.end());
    const std::vector<Facet> stayed =
      collect<Facet>(static_cast<Index>(this->Cut.size()), execution,
        [&](Index i, std::vector<Facet>& found)
        {
          if (const Facet facet = this->Cut[i];
              this->isCut(facet) && this->nameInside(facet) == facet)
          {
            found.push_back(facet);
          }
        });
    this->Cut.clear();
    std::set_union(
      stayed.begin(), stayed.end(), entered.begin(), entered.end(), std::back_inserter(this->Cut));
  }

  /// The name of a cut triangle in the list.
  Facet nameInside(Facet facet) const
  {
    const Facet other = this->Complex.mirror[facet / 4][facet % 4];
    return this->Inside[facet / 4] || other == kNone ? facet : other;
  }

  /// The cut triangles seen from inside.
  std::vector<Triangle> outwardTriangles(Execution& execution) const
  {
    std::vector<Triangle> triangles(this->Cut.size());
    execution.parallelFor(triangles.size(), 1 << 14,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          triangles[i] = outwardVertices(this->Complex, this->Inside, this->Cut[i]);
        }
      });
    return triangles;
  }

  bool touchesCut(Index tet) const { return this->cutFacets(tet) != 0; }

  /// Appends the tetrahedra around the edge of a facet that is opposite to a vertex of it.
  void appendAround(Facet facet, Index opposite, std::vector<Index>& found) const
  {
    this->Complex.walkWholeEdge(facet, opposite,
      [&](Facet entering, Facet, Facet)
      {
        found.push_back(entering / 4);
        return true;
      });
  }

  /// Flips two tetrahedra if that pays.
  bool flipPair(Index a, Index b)
  {
    const double first = this->gain(a, this->cutFacets(a), -kInfinity);
    this->flip(a);
    const double both = first + this->gain(b, this->cutFacets(b), kLeastGain - first);
    if (both > kLeastGain)
    {
      this->flip(b);
      return true;
    }
    this->flip(a);
    return false;
  }

  bool isCut(Facet facet) const
  {
    const Facet other = this->Complex.mirror[facet / 4][facet % 4];
    if (other != kNone)
    {
      return this->Inside[facet / 4] != this->Inside[other / 4];
    }
    const Index room = this->Outside.beyond(facet);
    return room != kNone && this->Inside[facet / 4] != this->Outside.side[room];
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

  /// The facets that may be cut.
  unsigned cuttableFacets(Index tet) const
  {
    unsigned cuttable = 0xF;
    for (unsigned k = 0; k < 4; ++k)
    {
      if (this->Complex.mirror[tet][k] == kNone && this->Outside.beyond(4 * tet + k) == kNone)
      {
        cuttable &= ~(1U << k);
      }
    }
    return cuttable;
  }

  /// What the objective gains by flipping the tetrahedron; exact where that is more than `least`.
  /// @param cut its cut facets
  double gain(Index tet, unsigned cut, double least) const
  {
    const unsigned entering = this->cuttableFacets(tet) & ~cut;
    const int leave = countOf(cut);
    int points = 0;
    for (unsigned k = 0; k < 4; ++k)
    {
      const int before = this->Cover.cutTriangles(this->Complex.tetrahedra[tet][k]);
      points += (before + changeAt(k, cut, entering) > 0) - (before > 0);
    }
    double gain = 2.0 * points - 0.5 * (countOf(entering) - leave);
    // only edges between two facets that do not enter can stop being non-manifold
    constexpr std::array kEdgesBetween{ 0, 0, 1, 3, 6 };
    const int stay = 4 - countOf(entering) - leave; // free facets of the hull
    const double most = gain + kNonManifoldWeight * kEdgesBetween[4 - countOf(entering)] +
      kRimWeight * stay * (4 - stay);
    const double excessLost = this->excess(tet, cut);
    if (most + kExcessWeight * excessLost <= least)
    {
      return least;
    }
    const double change = kExcessWeight * (excessLost - this->excess(tet, entering));
    if (most + change <= least)
    {
      return least;
    }
    return gain + change - this->edgeCost(tet, cut, entering);
  }

  /// Change in the number of cut triangles at vertex k, whose facets are the other three.
  static int changeAt(unsigned k, unsigned leaving, unsigned entering)
  {
    return countOf(entering & ~(1U << k)) - countOf(leaving & ~(1U << k));
  }

  /// Excess size of some of a tetrahedron's facets.
  double excess(Index tet, unsigned facets) const
  {
    double sum = 0.0;
    for (; facets != 0; facets &= facets - 1)
    {
      const Facet facet = 4 * tet + static_cast<Facet>(std::countr_zero(facets));
      sum +=
        TriangleSize(this->Complex, this->Spacing, this->Complex.facetVertices(facet)).excess();
    }
    return sum;
  }

  /// Change in the cost of edges with more than two cut triangles and of rims.
  double edgeCost(Index tet, unsigned leaving, unsigned entering) const
  {
    const auto changeOf = [&](unsigned k)
    { return static_cast<int>(entering >> k & 1U) - static_cast<int>(leaving >> k & 1U); };
    const auto cost = [](int triangles) {
      return (triangles > 2 ? kNonManifoldWeight : 0.0) + (triangles % 2 != 0 ? kRimWeight : 0.0);
    };
    double made = 0.0;
    for (unsigned i = 0; i < 4; ++i)
    {
      for (unsigned j = i + 1; j < 4; ++j)
      {
        if (const int change = changeOf(i) + changeOf(j); change != 0)
        {
          const int before = this->cutTrianglesAround(tet, i, j);
          made += cost(before + change) - cost(before);
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
    const unsigned entering = this->cuttableFacets(tet) & ~cut;
    for (unsigned k = 0; k < 4; ++k)
    {
      this->Cover.count(this->Complex.tetrahedra[tet][k], changeAt(k, cut, entering));
    }
    this->Inside[tet] ^= 1U;
    this->Flipped.push_back(tet);
  }

  /// Appends the tetrahedra at the vertices of a tetrahedron that are not queued yet.
  void queueStars(Index tet, std::vector<Index>& queue)
  {
    for (const Index v : this->Complex.tetrahedra[tet])
    {
      this->queueStar(tet, v, queue);
    }
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
  const OutsideRooms& Outside;
  std::vector<std::uint8_t> Inside;
  CutCover Cover;
  std::vector<std::uint8_t> Queued;
  std::vector<Facet> Cut;     // as of the last update, in increasing order
  std::vector<Index> Flipped; // since then
  std::vector<Index> Star;
};

} // namespace

FineTuned fineTune(const FlowComplex& flow, const std::vector<float>& spacing,
  const OutsideRooms& outside, std::vector<std::uint8_t> inside, Execution& execution)
{
  execution.step("fine-tune", 0, 3);
  FineTuning tuning(flow.delaunay(), spacing, outside, std::move(inside), execution);
  execution.step("fine-tune", 1, 3);
  const auto flipAll = [&](std::vector<Index> candidates)
  {
    while (!candidates.empty())
    {
      execution.step("fine-tune", 2, 3);
      candidates = tuning.flipCandidates(candidates);
    }
  };
  flipAll(tuning.findCandidates(execution));
  flipAll(tuning.flipPairs(
    tuning.findMissing(execution), [&](Index tet) { return tuning.missesPoint(tet); }));
  flipAll(tuning.flipPairs(tuning.findCrowded(execution), [](Index) { return true; }));
  execution.step("fine-tune", 3, 3);
  return tuning.takeResult(execution);
}

} // namespace scan
