// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bridge.h"

#include "filters/base/error.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/holes.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace scan
{
namespace
{

/// An edge of a boundary loop, from a corner to the next.
struct RimEdge
{
  Index loop = kNone;
  Index corner = 0;
};

Error refusal(const std::string& why)
{
  return { ErrorCode::badParameter, "no bridge is built: " + why };
}

/// The edge of a rim inside the region that is nearest to a place.
RimEdge nearestRimEdge(const TriMesh& mesh, const std::vector<BoundaryLoop>& loops,
  std::span<const std::uint8_t> inRegion, const Vec3& at)
{
  RimEdge nearest;
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < loops.size(); ++i)
  {
    const auto& points = loops[i].points;
    for (Index k = 0; k < points.size() && loops[i].isManifold; ++k)
    {
      const Index a = points[k];
      const Index b = points[(k + 1) % points.size()];
      const double distance = squaredDistance(at, mesh.points[a], mesh.points[b], mesh.points[b]);
      if (inRegion[a] != 0 && inRegion[b] != 0 && distance < least)
      {
        least = distance;
        nearest = { i, k };
      }
    }
  }
  if (nearest.loop == kNone)
  {
    throw refusal("the surface has no rim there");
  }
  return nearest;
}

/// The points of so many edges around one, in the order of the loop.
std::vector<Index> chainAround(const BoundaryLoop& loop, Index corner, Index width)
{
  const auto count = static_cast<Index>(loop.points.size());
  if (width >= count)
  {
    throw refusal(
      "a rim there has " + std::to_string(count) + " edges only; choose a smaller width");
  }
  std::vector<Index> chain;
  for (Index i = 0; i <= width; ++i)
  {
    chain.push_back(loop.points[(corner + count - (width - 1) / 2 + i) % count]);
  }
  return chain;
}

double lengthOf(const TriMesh& mesh, const std::vector<Index>& chain)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
  {
    sum += length(mesh.points[chain[i + 1]] - mesh.points[chain[i]]);
  }
  return sum;
}

/// The strip between a chain and another against its direction, in rows across.
class Strip
{
public:
  Strip(const TriMesh& mesh, std::vector<Index> from, std::vector<Index> to)
    : Mesh(mesh)
    , From(std::move(from))
    , To(std::move(to))
  {
    std::ranges::reverse(this->To);
  }

  void requireFit() const;
  BridgeResult build() const;

private:
  const Vec3& start(std::size_t i) const { return this->Mesh.points[this->From[i]]; }
  const Vec3& end(std::size_t i) const { return this->Mesh.points[this->To[i]]; }
  double span() const;

  const TriMesh& Mesh;
  std::vector<Index> From;
  std::vector<Index> To; // as From runs
};

/// The mean length along the strip.
double Strip::span() const
{
  double sum = 0.0;
  for (std::size_t i = 0; i < this->From.size(); ++i)
  {
    sum += length(this->end(i) - this->start(i));
  }
  return sum / static_cast<double>(this->From.size());
}

void Strip::requireFit() const
{
  for (const Index point : this->From)
  {
    if (std::ranges::find(this->To, point) != this->To.end())
    {
      throw refusal("its ends meet; name places that are farther apart");
    }
  }
  for (const Triangle& t : this->Mesh.triangles)
  {
    const auto has = [&](const std::vector<Index>& chain)
    {
      return std::ranges::any_of(
        t, [&](Index point) { return std::ranges::find(chain, point) != chain.end(); });
    };
    if (has(this->From) && has(this->To))
    {
      throw refusal("an edge joins its ends already; name places that are farther apart");
    }
  }
  const std::size_t last = this->From.size() - 1;
  const double straight =
    length(this->end(0) - this->start(0)) + length(this->end(last) - this->start(last));
  const double crossed =
    length(this->end(last) - this->start(0)) + length(this->end(0) - this->start(last));
  if (crossed < straight)
  {
    throw refusal("the two rims face opposite ways; turn one over first");
  }
}

BridgeResult Strip::build() const
{
  BridgeResult result;
  result.edit = unchanged(this->Mesh);
  result.length = this->span();
  const std::size_t columns = this->From.size();
  const double edge = (lengthOf(this->Mesh, this->From) + lengthOf(this->Mesh, this->To)) /
    (2.0 * static_cast<double>(columns - 1));
  constexpr double kMostRows = 1000.0;
  const auto rows = static_cast<std::size_t>(
    std::clamp(edge > 0.0 ? std::round(result.length / edge) : 1.0, 1.0, kMostRows));
  TriMesh& mesh = result.edit.mesh;
  std::vector<Index> previous = this->From;
  for (std::size_t row = 1; row <= rows; ++row)
  {
    std::vector<Index> next = this->To;
    for (std::size_t i = 0; i < columns && row < rows; ++i)
    {
      const double share = static_cast<double>(row) / static_cast<double>(rows);
      next[i] = static_cast<Index>(mesh.points.size());
      mesh.points.push_back(this->start(i) * (1.0 - share) + this->end(i) * share);
      result.edit.pointOrigin.push_back(kNone);
      result.edit.blends.push_back(
        { { this->From[i], this->To[i], this->To[i] }, { 1.0 - share, share, 0.0 } });
    }
    for (std::size_t i = 0; i + 1 < columns; ++i)
    {
      // the shorter diagonal
      const Index a = previous[i];
      const Index b = previous[i + 1];
      const Index c = next[i + 1];
      const Index d = next[i];
      const bool isOther =
        length(mesh.points[c] - mesh.points[a]) < length(mesh.points[d] - mesh.points[b]);
      mesh.triangles.push_back(isOther ? Triangle{ b, a, c } : Triangle{ b, a, d });
      mesh.triangles.push_back(isOther ? Triangle{ c, a, d } : Triangle{ c, b, d });
    }
    previous = std::move(next);
  }
  result.pointsAdded = static_cast<Index>(mesh.points.size() - this->Mesh.points.size());
  result.trianglesAdded = static_cast<Index>(mesh.triangles.size() - this->Mesh.triangles.size());
  result.edit.triangleOrigin.resize(mesh.triangles.size(), kNone);
  return result;
}

} // namespace

BridgeResult bridge(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const BridgeOptions& options, Execution& execution)
{
  execution.step("bridge", 0, 4);
  requireFinitePoints(mesh.points);
  const std::vector<BoundaryLoop> loops = boundaryLoops(mesh, execution);
  const RimEdge from = nearestRimEdge(mesh, loops, inRegion, options.from);
  const RimEdge to = nearestRimEdge(mesh, loops, inRegion, options.to);
  const Strip strip(mesh, chainAround(loops[from.loop], from.corner, options.width),
    chainAround(loops[to.loop], to.corner, options.width));
  strip.requireFit();
  execution.step("bridge", 1, 4);
  BridgeResult result = strip.build();
  result.joinsTwo = from.loop != to.loop;
  std::vector<Index> fresh(result.trianglesAdded);
  std::iota(fresh.begin(), fresh.end(), static_cast<Index>(mesh.triangles.size()));
  execution.step("bridge", 2, 4);
  if (!selfIntersections(result.edit.mesh, fresh, execution).empty())
  {
    throw refusal("it would cut the surface; name other places or a smaller width");
  }
  execution.step("bridge", 3, 4);
  if (options.maxDeviation < std::numeric_limits<double>::infinity())
  {
    const TriangleTree tree(mesh, execution);
    if (!trianglesBeyond(result.edit.mesh, tree, options.maxDeviation, execution).empty())
    {
      throw refusal("it would be farther from the surface than the limit");
    }
  }
  execution.step("bridge", 4, 4);
  return result;
}

} // namespace scan
