// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mesh_checks.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

namespace scan
{
namespace
{

class Survey
{
public:
  explicit Survey(const TriMesh& mesh)
    : Mesh(mesh)
    , Pairs(pairEdges(mesh))
  {
  }

  MeshReport run();

private:
  void measureBox();
  void measureTriangles();
  void measureEdges();
  void labelComponents();
  void countFans();
  void countLoops();
  void conclude();
  void addEdge(Index half);
  void followBoundary(Index half, Index pivot, std::vector<bool>& visited) const;
  Index markFan(Index half, Index point, std::vector<bool>& visited) const;

  std::span<const Index> crowded(std::size_t edge) const
  {
    return std::span(this->Pairs.crowded)
      .subspan(this->Pairs.crowdedBegin[edge],
        this->Pairs.crowdedBegin[edge + 1] - this->Pairs.crowdedBegin[edge]);
  }
  std::size_t crowdedEdges() const { return this->Pairs.crowdedBegin.size() - 1; }
  Index origin(Index half) const { return originOf(this->Mesh, half); }
  Index target(Index half) const { return originOf(this->Mesh, nextHalf(half)); }
  ComponentReport& componentOf(Index half)
  {
    return this->Report.components[this->Component[half / 3]];
  }
  /// The other edge at `point` in the triangle of `half`, which has `point` at one end.
  Index otherEdge(Index half, Index point) const
  {
    return this->origin(half) == point ? previousHalf(half) : nextHalf(half);
  }

  const TriMesh& Mesh;
  EdgePairs Pairs;
  std::vector<bool> IsCrowded;     // per half-edge
  std::vector<Index> Component;    // per triangle; kNone when collapsed
  std::vector<bool> ManifoldSoFar; // per component
  double EdgeSum = 0.0;
  MeshReport Report;
};

void Survey::measureBox()
{
  const BoundingBox box(this->Mesh.points);
  this->Report.boxMin = box.low;
  this->Report.boxMax = box.high;
  this->Report.boxDiagonal = box.diagonal();
}

void Survey::measureTriangles()
{
  const std::vector<Vec3>& points = this->Mesh.points;
  // volumes are summed from the middle of the model, far from which they lose digits
  const Vec3 middle = (this->Report.boxMin + this->Report.boxMax) * 0.5;
  double sixVolumes = 0.0;
  for (const Triangle& corner : this->Mesh.triangles)
  {
    if (isCollapsed(corner))
    {
      ++this->Report.collapsedTriangles;
      continue;
    }
    const Vec3 a = points[corner[0]] - middle;
    const Vec3 b = points[corner[1]] - middle;
    const Vec3 c = points[corner[2]] - middle;
    const Vec3 normal = cross(b - a, c - a);
    const double doubleArea = std::sqrt(dot(normal, normal));
    this->Report.area += 0.5 * doubleArea;
    sixVolumes += dot(a, cross(b, c));
    this->Report.flatTriangles +=
      isFlat(points[corner[0]], points[corner[1]], points[corner[2]]) ? 1 : 0;
  }
  this->Report.volume = sixVolumes / 6.0;
}

void Survey::addEdge(Index half)
{
  const Vec3 along = this->Mesh.points[this->target(half)] - this->Mesh.points[this->origin(half)];
  const double length = std::sqrt(dot(along, along));
  this->EdgeSum += length;
  this->Report.shortestEdge = std::min(this->Report.shortestEdge, length);
  this->Report.longestEdge = std::max(this->Report.longestEdge, length);
  --this->componentOf(half).eulerCharacteristic;
}

/// Visits each edge once, by its first half-edge.
void Survey::measureEdges()
{
  MeshReport& report = this->Report;
  report.shortestEdge = std::numeric_limits<double>::max();
  report.isClosed = this->Pairs.edges > 0 && this->Pairs.boundaryEdges == 0;
  for (Index half = 0; half < this->Pairs.mate.size(); ++half)
  {
    const Index mate = this->Pairs.mate[half];
    if (this->Component[half / 3] == kNone || this->IsCrowded[half] || mate < half)
    {
      continue;
    }
    this->addEdge(half);
  }
  report.misorientedEdges = static_cast<Index>(this->Pairs.misoriented.size());
  for (std::size_t edge = 0; edge < this->crowdedEdges(); ++edge)
  {
    const std::span<const Index> halves = this->crowded(edge);
    this->addEdge(halves.front());
    const auto sameWay = std::count_if(halves.begin(), halves.end(),
      [&](Index half) { return this->origin(half) == this->origin(halves.front()); });
    const bool even = halves.size() % 2 == 0;
    report.misorientedEdges += even && 2 * sameWay != std::ssize(halves) ? 1 : 0;
    report.isClosed = report.isClosed && even;
    this->ManifoldSoFar[this->Component[halves.front() / 3]] = false;
  }
  report.edges = this->Pairs.edges;
  report.boundaryEdges = this->Pairs.boundaryEdges;
  report.nonManifoldEdges = static_cast<Index>(this->crowdedEdges());
  report.meanEdge = report.edges > 0 ? this->EdgeSum / report.edges : 0.0;
  report.shortestEdge = report.edges > 0 ? report.shortestEdge : 0.0;
}

void Survey::labelComponents()
{
  UnionFind sets(this->Mesh.triangles.size());
  for (Index half = 0; half < this->Pairs.mate.size(); ++half)
  {
    if (this->Pairs.mate[half] != kNone && half < this->Pairs.mate[half])
    {
      sets.unite(half / 3, this->Pairs.mate[half] / 3);
    }
  }
  this->IsCrowded.assign(this->Pairs.mate.size(), false);
  for (std::size_t edge = 0; edge < this->crowdedEdges(); ++edge)
  {
    for (const Index half : this->crowded(edge))
    {
      this->IsCrowded[half] = true;
      sets.unite(half / 3, this->crowded(edge).front() / 3);
    }
  }
  this->Component.assign(this->Mesh.triangles.size(), kNone);
  for (Index t = 0; t < this->Component.size(); ++t)
  {
    if (isCollapsed(this->Mesh.triangles[t]))
    {
      continue;
    }
    const Index first =
      sets.root(t); // the component's first triangle: already labelled or t itself
    if (first == t)
    {
      this->Component[t] = static_cast<Index>(this->Report.components.size());
      this->Report.components.emplace_back();
    }
    this->Component[t] = this->Component[first];
    ++this->Report.components[this->Component[t]].triangles;
    ++this->Report.components[this->Component[t]].eulerCharacteristic;
  }
  this->ManifoldSoFar.assign(this->Report.components.size(), true);
}

/// Marks the corners at `point` that hang together with the triangle of `half`, which leaves
/// `point`, and returns how many of the two ends of the fan lie on a crowded edge.
Index Survey::markFan(Index half, Index point, std::vector<bool>& visited) const
{
  Index crowdedEnds = 0;
  for (Index edge : { half, previousHalf(half) })
  {
    for (Index mate = this->Pairs.mate[edge]; mate != kNone; mate = this->Pairs.mate[edge])
    {
      const Index leaving = this->origin(mate) == point ? mate : nextHalf(mate);
      if (visited[leaving])
      {
        return crowdedEnds; // once around
      }
      visited[leaving] = true;
      edge = this->otherEdge(mate, point);
    }
    crowdedEnds += this->IsCrowded[edge] ? 1 : 0;
  }
  return crowdedEnds;
}

/// Counts points and the fans of triangles at them, for the whole and for each component.
void Survey::countFans()
{
  const std::size_t halves = this->Pairs.mate.size();
  std::vector<Index> begin(this->Mesh.points.size() + 2, 0);
  for (const Triangle& corner : this->Mesh.triangles)
  {
    for (const Index point : corner)
    {
      ++begin[point + 2];
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> leaving(halves); // half-edges by the point that they leave
  for (Index half = 0; half < halves; ++half)
  {
    leaving[begin[this->origin(half) + 1]++] = half;
  }

  std::vector<bool> visited(halves, false);
  std::vector<Index> lastPoint(this->Report.components.size(), kNone);
  for (Index point = 0; point < this->Mesh.points.size(); ++point)
  {
    Index fans = 0;
    Index crowdedEnds = 0;
    for (Index i = begin[point]; i < begin[point + 1]; ++i)
    {
      const Index half = leaving[i];
      if (visited[half] || this->Component[half / 3] == kNone)
      {
        continue;
      }
      visited[half] = true;
      crowdedEnds += this->markFan(half, point, visited);
      ++fans;
      const Index component = this->Component[half / 3];
      if (lastPoint[component] == point)
      {
        this->ManifoldSoFar[component] = false;
        continue;
      }
      lastPoint[component] = point;
      ++this->Report.components[component].points;
      ++this->Report.components[component].eulerCharacteristic;
    }
    this->Report.pointsUsed += fans > 0 ? 1 : 0;
    this->Report.nonManifoldVertices += fans > 1 && crowdedEnds == 0 ? 1 : 0;
  }
}

/// Marks boundary edges from `half`, leaving it over `pivot`, until the chain closes or meets a
/// crowded edge.
void Survey::followBoundary(Index half, Index pivot, std::vector<bool>& visited) const
{
  while (true)
  {
    Index edge = this->otherEdge(half, pivot);
    for (Index mate = this->Pairs.mate[edge]; mate != kNone; mate = this->Pairs.mate[edge])
    {
      edge = this->otherEdge(mate, pivot);
    }
    if (this->IsCrowded[edge] || visited[edge])
    {
      return;
    }
    visited[edge] = true;
    pivot = this->origin(edge) == pivot ? this->target(edge) : this->origin(edge);
    half = edge;
  }
}

void Survey::countLoops()
{
  std::vector<bool> visited(this->Pairs.mate.size(), false);
  for (Index half = 0; half < visited.size(); ++half)
  {
    if (visited[half] || this->Pairs.mate[half] != kNone || this->IsCrowded[half] ||
      this->Component[half / 3] == kNone)
    {
      continue;
    }
    visited[half] = true;
    this->followBoundary(half, this->target(half), visited);
    this->followBoundary(half, this->origin(half), visited);
    ++this->Report.boundaryLoops;
    ++this->componentOf(half).boundaryLoops;
  }
}

void Survey::conclude()
{
  MeshReport& report = this->Report;
  report.points = static_cast<Index>(this->Mesh.points.size());
  report.triangles = static_cast<Index>(this->Mesh.triangles.size());
  report.eulerCharacteristic =
    std::int64_t{ report.pointsUsed } - report.edges + report.triangles - report.collapsedTriangles;
  report.isManifold = report.nonManifoldEdges == 0 && report.nonManifoldVertices == 0 &&
    report.collapsedTriangles == 0;
  report.isOriented = report.misorientedEdges == 0;
  if (!report.isClosed || !report.isOriented)
  {
    report.volume.reset();
  }
  std::vector<bool> isOriented(report.components.size(), true);
  for (const Index half : this->Pairs.misoriented)
  {
    isOriented[this->Component[half / 3]] = false;
  }
  report.genus = 0;
  for (std::size_t i = 0; i < report.components.size(); ++i)
  {
    ComponentReport& component = report.components[i];
    if (this->ManifoldSoFar[i] && isOriented[i])
    {
      component.genus = (2 - component.eulerCharacteristic - component.boundaryLoops) / 2;
      report.genus = report.genus ? *report.genus + *component.genus : report.genus;
    }
    else
    {
      report.genus.reset();
    }
  }
  std::stable_sort(report.components.begin(), report.components.end(),
    [](const ComponentReport& a, const ComponentReport& b) { return a.triangles > b.triangles; });
}

MeshReport Survey::run()
{
  this->measureBox();
  this->measureTriangles();
  this->labelComponents();
  this->measureEdges();
  this->countFans();
  this->countLoops();
  this->conclude();
  return std::move(this->Report);
}

} // namespace

MeshReport describeMesh(const TriMesh& mesh)
{
  return Survey(mesh).run();
}

} // namespace scan
