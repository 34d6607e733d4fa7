// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/contraction_mesh.h"

#include <algorithm>
#include <utility>

namespace scan
{

ContractionMesh::ContractionMesh(TriMesh mesh, Execution& execution)
{
  EdgePairs pairs = pairEdges(mesh, execution);
  this->mate = std::move(pairs.mate);
  this->isSingular.assign(mesh.points.size(), 0);
  const auto setSingular = [&](Index half)
  {
    this->isSingular[originOf(mesh, half)] = 1;
    this->isSingular[originOf(mesh, nextHalf(half))] = 1;
  };
  for (const Index half : pairs.misoriented)
  {
    setSingular(half);
    this->mate[this->mate[half]] = kNone;
    this->mate[half] = kNone;
  }
  std::ranges::for_each(pairs.crowded, setSingular);
  this->triangles = mesh.triangles.size();
  this->corner.resize(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const Triangle& triangle = mesh.triangles[t];
    std::ranges::copy(triangle, this->corner.begin() + static_cast<std::ptrdiff_t>(3 * t));
    if (isCollapsed(triangle))
    {
      for (const Index point : triangle)
      {
        this->isSingular[point] = 1;
      }
    }
  }
  this->points = std::move(mesh.points);
  this->Stamp.assign(this->points.size(), 0);
  this->startFans();
}

/// Finds the first half-edge of every fan; points with several fans are singular.
void ContractionMesh::startFans()
{
  this->out.assign(this->points.size(), kNone);
  std::vector<Index> degree(this->points.size(), 0);
  for (Index half = 0; half < this->corner.size(); ++half)
  {
    const Index point = this->corner[half];
    ++degree[point];
    if (this->out[point] == kNone || this->mate[half] == kNone)
    {
      this->out[point] = half;
    }
  }
  for (Index point = 0; point < this->points.size(); ++point)
  {
    if (this->isSingular[point] != 0 || degree[point] == 0)
    {
      this->isSingular[point] = 1;
      continue;
    }
    Index met = 0;
    this->forEachOut(point, [&](Index) { ++met; });
    if (met != degree[point])
    {
      this->isSingular[point] = 1;
    }
  }
}

bool ContractionMesh::keepsTopology(Index half)
{
  const Index u = this->from(half);
  const Index v = this->to(half);
  const Index twin = this->mate[half];
  if (twin != kNone && this->isBoundary(u) && this->isBoundary(v))
  {
    return false;
  }
  const auto hangsOn = [&](Index side)
  { return this->mate[nextHalf(side)] != kNone || this->mate[previousHalf(side)] != kNone; };
  if (!hangsOn(half) || (twin != kNone && !hangsOn(twin)))
  {
    return false;
  }
  ++this->Question;
  Index around = 0;
  this->forEachNeighbour(u,
    [&](Index neighbour)
    {
      this->Stamp[neighbour] = this->Question;
      ++around;
    });
  Index common = 0;
  Index aroundOther = 0;
  this->forEachNeighbour(v,
    [&](Index neighbour)
    {
      common += this->Stamp[neighbour] == this->Question ? 1 : 0;
      ++aroundOther;
    });
  const bool isTetrahedron = twin != kNone && around == 3 && aroundOther == 3;
  return common == (twin != kNone ? 2U : 1U) && !isTetrahedron;
}

/// Makes the outer sides of two edges that became one each other's mates.
void ContractionMesh::glue(Index a, Index b)
{
  if (a != kNone)
  {
    this->mate[a] = b;
  }
  if (b != kNone)
  {
    this->mate[b] = a;
  }
}

void ContractionMesh::contract(Index half)
{
  const Index u = this->from(half);
  const Index v = this->to(half);
  // where the fan of the merged point begins, but for the triangles that go
  Index start = this->isBoundary(u) && this->mate[half] != kNone ? this->out[u] : this->out[v];
  const bool isOpen = this->isBoundary(u) || this->isBoundary(v);
  this->forEachOut(u, [&](Index leaving) { this->corner[leaving] = v; });
  for (const Index side : { half, this->mate[half] })
  {
    if (side == kNone)
    {
      continue;
    }
    const Index intoApex = nextHalf(side);         // from the end of `side` to the apex
    const Index outOfApex = previousHalf(side);    // and back to its beginning
    const Index behindInto = this->mate[intoApex]; // leaves the apex
    const Index behindOut = this->mate[outOfApex]; // ends there
    if (const Index apex = this->corner[outOfApex]; this->out[apex] == outOfApex)
    {
      this->out[apex] = behindInto;
    }
    if (isOpen ? start == intoApex : side == half)
    {
      start = behindOut;
    }
    this->glue(behindInto, behindOut);
  }
  for (const Index side : { half, this->mate[half] })
  {
    if (side != kNone)
    {
      const Index first = side - side % 3;
      std::fill_n(this->corner.begin() + first, 3, kNone);
      --this->triangles;
    }
  }
  this->out[v] = start;
  this->out[u] = kNone;
}

void ContractionMesh::renumber(const std::vector<Index>& number, Index count)
{
  const auto numberOf = [&](Index half)
  { return half == kNone ? kNone : 3 * number[half / 3] + half % 3; };
  for (std::size_t t = 0; t < number.size(); ++t)
  {
    for (std::size_t k = 0; k < 3 && number[t] != kNone; ++k)
    {
      const std::size_t to = 3 * std::size_t{ number[t] } + k;
      this->corner[to] = this->corner[3 * t + k];
      this->mate[to] = numberOf(this->mate[3 * t + k]);
    }
  }
  this->corner.resize(3 * std::size_t{ count });
  this->mate.resize(this->corner.size());
  for (Index& half : this->out)
  {
    if (half != kNone && number[half / 3] != kNone)
    {
      half = numberOf(half);
    }
  }
}

} // namespace scan
