// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/chamfers.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/triangle_measures.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scan
{
namespace
{

constexpr Index kSeveral = kNone - 1; // smooth parts at a point

class Finder
{
public:
  Finder(const TriMesh& mesh, double angle, Execution& execution)
    : Mesh(mesh)
    , Pairs(pairEdges(mesh, execution))
    , Normals(mesh.triangles.size())
    , IsSmooth(this->Pairs.mate.size(), 0)
    , Parts(mesh.triangles.size())
  {
    execution.parallelFor(mesh.triangles.size(), 1 << 14,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          this->Normals[t] = normalOf(mesh.points, mesh.triangles[t]);
        }
      });
    this->findSmoothEdges(std::cos(angle));
    this->findParts();
    this->findPartsOfPoints();
  }

  Chamfers chamfers(std::span<const std::uint8_t> inRegion)
  {
    Chamfers found;
    found.isAcross.assign(this->Pairs.mate.size(), 0);
    for (Index half = 0; half < this->Pairs.mate.size(); ++half)
    {
      const Index mate = this->Pairs.mate[half];
      const bool isFree = this->isFree(half, inRegion);
      found.isAcross[half] =
        isFree && (mate == kNone || this->isFree(mate, inRegion)) && this->isAcross(half) ? 1 : 0;
    }
    found.normals = this->normalsOfPoints();
    found.mate = std::move(this->Pairs.mate);
    return found;
  }

private:
  Index from(Index half) const { return originOf(this->Mesh, half); }
  Index to(Index half) const { return originOf(this->Mesh, nextHalf(half)); }

  void findSmoothEdges(double cosine)
  {
    this->IsOdd = oddHalves(this->Pairs);
    this->IsRough.assign(this->Mesh.points.size(), 0);
    for (Index half = 0; half < this->IsOdd.size(); ++half)
    {
      const Index mate = this->Pairs.mate[half];
      const bool isBoundary = mate == kNone && this->IsOdd[half] == 0;
      this->IsSmooth[half] = mate != kNone && this->IsOdd[half] == 0 &&
          dot(this->Normals[half / 3], this->Normals[mate / 3]) >= cosine
        ? 1
        : 0;
      if (this->IsSmooth[half] == 0 && !isBoundary)
      {
        this->IsRough[this->from(half)] = this->IsRough[this->to(half)] = 1;
      }
    }
  }

  /// Of triangles by smooth edges; those with a point that is not rough are smooth parts.
  void findParts()
  {
    for (Index half = 0; half < this->IsSmooth.size(); ++half)
    {
      if (this->IsSmooth[half] != 0 && half < this->Pairs.mate[half])
      {
        this->Parts.unite(half / 3, this->Pairs.mate[half] / 3);
      }
    }
    this->IsPart.assign(this->Mesh.triangles.size(), 0);
    for (Index t = 0; t < this->IsPart.size(); ++t)
    {
      if (!isCollapsed(this->Mesh.triangles[t]) &&
        std::ranges::any_of(
          this->Mesh.triangles[t], [&](Index point) { return this->IsRough[point] == 0; }))
      {
        this->IsPart[this->Parts.root(t)] = 1;
      }
    }
  }

  bool isOfPart(Index t) { return this->IsPart[this->Parts.root(t)] != 0; }

  void findPartsOfPoints()
  {
    this->PartOfPoint.assign(this->Mesh.points.size(), kNone);
    for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      for (const Index point : this->Mesh.triangles[t])
      {
        Index& part = this->PartOfPoint[point];
        const Index root = this->Parts.root(t);
        if (this->isOfPart(t) && part != root)
        {
          part = part == kNone ? root : kSeveral;
        }
      }
    }
  }

  /// Whether the triangle of a half-edge may belong to a chamfer, and the edge be cut.
  bool isFree(Index half, std::span<const std::uint8_t> inRegion)
  {
    return inRegion[half / 3] != 0 && this->IsOdd[half] == 0 && !this->isOfPart(half / 3) &&
      !isCollapsed(this->Mesh.triangles[half / 3]);
  }

  bool isAcross(Index half) const
  {
    const Index a = this->PartOfPoint[this->from(half)];
    const Index b = this->PartOfPoint[this->to(half)];
    return a < kSeveral && b < kSeveral && a != b;
  }

  std::vector<Vec3> normalsOfPoints()
  {
    std::vector<Vec3> normals(this->Mesh.points.size());
    for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      const Triangle& triangle = this->Mesh.triangles[t];
      for (std::size_t k = 0; k < 3 && this->isOfPart(t); ++k)
      {
        const Vec3& corner = this->Mesh.points[triangle[k]];
        const Vec3 ahead = unitVector(this->Mesh.points[triangle[(k + 1) % 3]] - corner);
        const Vec3 back = unitVector(this->Mesh.points[triangle[(k + 2) % 3]] - corner);
        const double angle = std::acos(std::clamp(dot(ahead, back), -1.0, 1.0));
        if (this->PartOfPoint[triangle[k]] != kSeveral)
        {
          normals[triangle[k]] = normals[triangle[k]] + this->Normals[t] * angle;
        }
      }
    }
    std::ranges::transform(normals, normals.begin(), unitVector);
    return normals;
  }

  const TriMesh& Mesh;
  EdgePairs Pairs;
  std::vector<Vec3> Normals;
  std::vector<std::uint8_t> IsSmooth; // per half-edge
  std::vector<std::uint8_t> IsOdd;    // per half-edge: of more than two triangles, or misoriented
  std::vector<std::uint8_t> IsRough; // per point: has an edge inside the surface that is not smooth
  UnionFind Parts;
  std::vector<std::uint8_t> IsPart; // per root of Parts
  std::vector<Index> PartOfPoint;   // a root, kNone or kSeveral
};

} // namespace

Chamfers findChamfers(
  const TriMesh& mesh, std::span<const std::uint8_t> inRegion, double angle, Execution& execution)
{
  return Finder(mesh, angle, execution).chamfers(inRegion);
}

} // namespace scan
