// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_adjacency.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/neighbours.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>

namespace scan
{
namespace
{

constexpr std::size_t kSpacingRank = 8;
constexpr double kReach = 2.0; // local spacings
constexpr std::size_t kGrain = 1 << 12;
constexpr std::size_t kBetweenSteps = 1 << 16;

/// Adds the corners of triangles that are not there, as long as there are few.
void addCorners(const TriMesh& mesh, std::span<const Index> triangles, std::vector<Index>& found)
{
  constexpr std::size_t kMost = 65;
  for (std::size_t i = 0; i < triangles.size() && found.size() + 3 <= kMost; ++i)
  {
    for (const Index corner : mesh.triangles[triangles[i]])
    {
      if (std::ranges::find(found, corner) == found.end())
      {
        found.push_back(corner);
      }
    }
  }
}

} // namespace

RegionAdjacency::RegionAdjacency(const TriMesh& mesh, RegionElements elements, Execution& execution)
  : Mesh(mesh)
  , Kind(elements)
{
  requireCorners(mesh);
  if (!this->isScan())
  {
    this->AtPoint = Incidence(mesh.points.size(), mesh.triangles.size(),
      [&](std::size_t t, auto&& visit) { std::ranges::for_each(mesh.triangles[t], visit); });
  }
  else
  {
    this->joinPlaces(execution);
  }
}

void RegionAdjacency::joinPlaces(Execution& execution)
{
  const Neighbours places(this->Mesh.points, execution);
  this->PlaceOf.resize(this->Mesh.points.size());
  for (Index place = 0; place < places.size(); ++place)
  {
    for (const Index point : places.pointsAt(place))
    {
      this->PlaceOf[point] = place;
    }
  }
  this->AtPlace = Incidence(places.size(), this->PlaceOf.size(),
    [&](std::size_t i, auto&& visit) { visit(this->PlaceOf[i]); });
  this->findNearest(places, execution);
}

void RegionAdjacency::findNearest(const Neighbours& places, Execution& execution)
{
  std::vector<double> spacing2(places.size());
  this->NearTo.resize(places.size());
  execution.parallelFor(places.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (auto i = static_cast<Index>(begin); i < end; ++i)
      {
        places.nearest(places[i], kNearest + 1, found);
        spacing2[i] = found[std::min(kSpacingRank, found.size() - 1)].squaredDistance;
        this->NearTo[i].fill(kNone);
        for (std::size_t k = 1; k < found.size(); ++k) // the first is the place itself
        {
          this->NearTo[i][k - 1] = found[k].place;
        }
      }
    });
  execution.parallelFor(places.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Index>(begin); i < end; ++i)
      {
        const auto isFar = [&](Index other)
        {
          const Vec3 d = other == kNone ? Vec3{} : places[other] - places[i];
          return other == kNone ||
            dot(d, d) > kReach * kReach * std::min(spacing2[i], spacing2[other]);
        };
        Nearest& near = this->NearTo[i];
        std::fill(std::remove_if(near.begin(), near.end(), isFar), near.end(), kNone);
      }
    });
  this->NearFrom = Incidence(places.size(), places.size(),
    [&](std::size_t i, auto&& visit)
    {
      for (const Index other : this->NearTo[i])
      {
        if (other != kNone)
        {
          visit(other);
        }
      }
    });
}

std::size_t RegionAdjacency::elements() const
{
  return this->Kind == RegionElements::triangles ? this->Mesh.triangles.size()
                                                 : this->Mesh.points.size();
}

std::size_t RegionAdjacency::joints() const
{
  return this->isScan()                       ? this->NearTo.size()
    : this->Kind == RegionElements::triangles ? this->Mesh.points.size()
                                              : this->Mesh.triangles.size();
}

template <class Visit>
void RegionAdjacency::forEachJoint(Index element, Visit&& visit) const
{
  if (this->Kind == RegionElements::triangles)
  {
    std::ranges::for_each(this->Mesh.triangles[element], visit);
  }
  else if (this->isScan())
  {
    visit(this->PlaceOf[element]);
  }
  else
  {
    std::ranges::for_each(this->AtPoint.of(element), visit);
  }
}

template <class Visit>
void RegionAdjacency::forEachElement(Index joint, Visit&& visit) const
{
  if (this->Kind == RegionElements::triangles)
  {
    std::ranges::for_each(this->AtPoint.of(joint), visit);
    return;
  }
  if (!this->isScan())
  {
    std::ranges::for_each(this->Mesh.triangles[joint], visit);
    return;
  }
  const auto visitPlace = [&](Index place)
  {
    if (place != kNone)
    {
      std::ranges::for_each(this->AtPlace.of(place), visit);
    }
  };
  visitPlace(joint);
  std::ranges::for_each(this->NearTo[joint], visitPlace);
  std::ranges::for_each(this->NearFrom.of(joint), visitPlace);
}

std::vector<std::uint8_t> RegionAdjacency::grow(
  std::vector<std::uint8_t> chosen, std::size_t rings, Execution& execution) const
{
  std::vector<std::uint8_t> isPassed(this->joints(), 0);
  std::vector<Index> front;
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    if (chosen[i] != 0)
    {
      front.push_back(static_cast<Index>(i));
    }
  }
  std::vector<Index> next;
  for (std::size_t ring = 0; ring < rings && !front.empty(); ++ring)
  {
    execution.step("region", ring, rings);
    next.clear();
    const auto reach = [&](Index element)
    {
      if (chosen[element] == 0)
      {
        chosen[element] = 1;
        next.push_back(element);
      }
    };
    const auto pass = [&](Index joint)
    {
      if (isPassed[joint] == 0)
      {
        isPassed[joint] = 1;
        this->forEachElement(joint, reach);
      }
    };
    for (const Index element : front)
    {
      this->forEachJoint(element, pass);
    }
    front.swap(next);
  }
  return chosen;
}

std::vector<Index> RegionAdjacency::parts(Execution& execution) const
{
  UnionFind sets(this->elements());
  if (this->Kind == RegionElements::triangles)
  {
    const EdgePairs edges = pairEdges(this->Mesh, execution);
    for (Index half = 0; half < edges.mate.size(); ++half)
    {
      if (edges.mate[half] != kNone)
      {
        sets.unite(half / 3, edges.mate[half] / 3);
      }
    }
    for (std::size_t edge = 0; edge + 1 < edges.crowdedBegin.size(); ++edge)
    {
      const Index first = edges.crowded[edges.crowdedBegin[edge]] / 3;
      for (Index i = edges.crowdedBegin[edge]; i < edges.crowdedBegin[edge + 1]; ++i)
      {
        sets.unite(first, edges.crowded[i] / 3);
      }
    }
  }
  else
  {
    for (Index joint = 0; joint < this->joints(); ++joint)
    {
      if (joint % kBetweenSteps == 0)
      {
        execution.step("region", joint, this->joints());
      }
      Index first = kNone;
      this->forEachElement(joint,
        [&](Index element)
        {
          first = first == kNone ? element : first;
          sets.unite(first, element);
        });
    }
  }
  std::vector<Index> parts(this->elements());
  for (Index i = 0; i < parts.size(); ++i)
  {
    parts[i] = sets.root(i);
  }
  return parts;
}

std::vector<Index> RegionAdjacency::around(Index point) const
{
  constexpr std::size_t kEnough = 12;
  std::vector<Index> found{ point };
  if (!this->isScan())
  {
    for (std::size_t begin = 0; begin < found.size() && found.size() <= kEnough;)
    {
      for (const std::size_t end = found.size(); begin < end; ++begin)
      {
        addCorners(this->Mesh, this->AtPoint.of(found[begin]), found);
      }
    }
  }
  else
  {
    const Nearest& near = this->NearTo[this->PlaceOf[point]];
    std::for_each(near.begin(), std::ranges::find(near, kNone),
      [&](Index place) { found.push_back(this->AtPlace.of(place).front()); });
  }
  found.erase(found.begin());
  return found;
}

} // namespace scan
