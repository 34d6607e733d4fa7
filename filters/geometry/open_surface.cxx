// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/open_surface.h"

#include "filters/geometry/flow_complex.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/triangle_size.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>

namespace scan
{
namespace
{

constexpr double kSparseRadius = 4.0; // circumradius / spacing
constexpr double kSparseArea = 2.0;   // area / spacing^2
constexpr double kOpeningArea = 40.0; // area / spacing^2
constexpr double kRimSize = 3.0;      // circumradius / spacing beside a rim

class OpenSurface
{
public:
  OpenSurface(const DelaunayComplex& complex, const std::vector<float>& spacing,
    const std::vector<Facet>& facets)
    : Shown(facets.size(), 1)
    , RimEdges(complex.points.size(), 0)
  {
    this->Mesh.points = complex.points;
    for (const Facet facet : facets)
    {
      this->Mesh.triangles.push_back(complex.facetVertices(facet));
      const Triangle& v = this->Mesh.triangles.back();
      const TriangleSize size(complex, spacing, v);
      this->Areas.push_back(size.area());
      this->Radii.push_back(std::sqrt(circumradiusSquared(complex, v)) / size.spacing());
    }
    EdgePairs pairs = pairEdges(this->Mesh);
    this->Mate = std::move(pairs.mate);
    for (const Index half : pairs.crowded)
    {
      this->Mate[half] = half; // no rim
    }
    this->Crowded = std::move(pairs.crowded);
    this->CrowdedBegin = std::move(pairs.crowdedBegin);
  }

  void dropOpenings()
  {
    std::vector<std::uint8_t> seen(this->Shown.size(), 0);
    for (Index t = 0; t < seen.size(); ++t)
    {
      if (!seen[t] && this->isSparse(t))
      {
        this->dropIfOpening(t, seen);
      }
    }
  }

  /// At edges with more than two triangles drops those that end at a rim, the largest first, where
  /// no point is lost. An odd number means that the edge is itself at an opening.
  void dropFlaps()
  {
    std::vector<Index> shownAt(this->RimEdges.size(), 0);
    for (Index t = 0; t < this->Shown.size(); ++t)
    {
      for (const Index v : this->Mesh.triangles[t])
      {
        shownAt[v] += this->Shown[t];
      }
    }
    const auto isFlap = [&](Index t, bool atRim)
    {
      const Triangle& v = this->Mesh.triangles[t];
      return this->Shown[t] &&
        (atRim || this->isRim(3 * t) || this->isRim(3 * t + 1) || this->isRim(3 * t + 2)) &&
        std::all_of(v.begin(), v.end(), [&](Index point) { return shownAt[point] > 1; });
    };
    for (std::size_t edge = 0; edge + 1 < this->CrowdedBegin.size(); ++edge)
    {
      std::vector<Index> triangles;
      for (Index i = this->CrowdedBegin[edge]; i < this->CrowdedBegin[edge + 1]; ++i)
      {
        if (this->Shown[this->Crowded[i] / 3])
        {
          triangles.push_back(this->Crowded[i] / 3);
        }
      }
      std::stable_sort(triangles.begin(), triangles.end(),
        [&](Index s, Index t) { return this->Radii[s] > this->Radii[t]; });
      std::size_t left = triangles.size();
      for (std::size_t i = 0; i < triangles.size() && left > 2; ++i)
      {
        if (isFlap(triangles[i], left % 2 != 0))
        {
          this->Shown[triangles[i]] = 0;
          --left;
          for (const Index v : this->Mesh.triangles[triangles[i]])
          {
            --shownAt[v];
          }
        }
      }
    }
  }

  /// Collapses large triangles from the rims.
  void trimRims()
  {
    for (Index half = 0; half < this->Mate.size(); ++half)
    {
      if (this->Shown[half / 3] && this->isRim(half))
      {
        ++this->RimEdges[originOf(this->Mesh, half)];
        ++this->RimEdges[originOf(this->Mesh, nextHalf(half))];
        this->queueTriangle(half / 3);
      }
    }
    while (!this->Queue.empty())
    {
      const Index t = this->Queue.top().second;
      this->Queue.pop();
      this->trim(t);
    }
  }

  std::vector<Facet> shown(const std::vector<Facet>& facets) const
  {
    std::vector<Facet> kept;
    for (std::size_t t = 0; t < facets.size(); ++t)
    {
      if (this->Shown[t])
      {
        kept.push_back(facets[t]);
      }
    }
    return kept;
  }

private:
  bool isSparse(Index t) const
  {
    return this->Radii[t] > kSparseRadius && this->Areas[t] > kSparseArea;
  }

  /// For a half-edge of a shown triangle.
  bool isRim(Index half) const
  {
    const Index mate = this->Mate[half];
    return mate == kNone || !this->Shown[mate / 3];
  }

  /// Drops the sparse triangles that hang together with t if they span an opening.
  void dropIfOpening(Index t, std::vector<std::uint8_t>& seen)
  {
    std::vector<Index> piece{ t };
    seen[t] = 1;
    bool reachesRim = false;
    double area = 0.0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      area += this->Areas[piece[i]];
      for (Index half = 3 * piece[i]; half < 3 * piece[i] + 3; ++half)
      {
        const Index mate = this->Mate[half];
        reachesRim |= mate == kNone;
        if (mate != kNone && !seen[mate / 3] && this->isSparse(mate / 3))
        {
          seen[mate / 3] = 1;
          piece.push_back(mate / 3);
        }
      }
    }
    for (const Index of : piece)
    {
      this->Shown[of] = !reachesRim && area <= kOpeningArea;
    }
  }

  void queueTriangle(Index t)
  {
    if (this->Radii[t] > kRimSize)
    {
      this->Queue.emplace(this->Radii[t], t);
    }
  }

  /// Drops a triangle with one edge on the rim and the opposite vertex off it.
  void trim(Index t)
  {
    Index rim = kNone;
    int count = 0;
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      if (this->isRim(half))
      {
        rim = half;
        ++count;
      }
    }
    const Index apex = count == 1 ? originOf(this->Mesh, previousHalf(rim)) : kNone;
    if (!this->Shown[t] || count != 1 || this->RimEdges[apex] > 0)
    {
      return;
    }
    this->Shown[t] = 0;
    this->RimEdges[apex] += 2;
    for (const Index half : { nextHalf(rim), previousHalf(rim) })
    {
      this->queueTriangle(this->Mate[half] / 3);
    }
  }

  TriMesh Mesh;
  std::vector<double> Radii;  ///< per triangle: circumradius / spacing
  std::vector<double> Areas;  ///< per triangle: area / spacing^2
  std::vector<Index> Mate;    ///< per half-edge; itself where more than two triangles meet
  std::vector<Index> Crowded; ///< half-edges at edges of more than two triangles, see EdgePairs
  std::vector<Index> CrowdedBegin;
  std::vector<std::uint8_t> Shown;
  std::vector<Index> RimEdges;                         ///< per point
  std::priority_queue<std::pair<double, Index>> Queue; ///< largest first
};

} // namespace

std::vector<Facet> withoutOpenings(const DelaunayComplex& complex,
  const std::vector<float>& spacing, const std::vector<Facet>& facets)
{
  OpenSurface surface(complex, spacing, facets);
  surface.dropOpenings();
  surface.dropFlaps();
  surface.trimRims();
  return surface.shown(facets);
}

} // namespace scan
