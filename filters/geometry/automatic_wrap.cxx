// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/automatic_wrap.h"

#include "filters/geometry/basin_refinement.h"
#include "filters/geometry/fine_tune.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/open_surface.h"
#include "filters/geometry/outside_rooms.h"
#include "filters/geometry/rooms.h"
#include "filters/geometry/scan_spacing.h"
#include "filters/geometry/signed_rooms.h"
#include "filters/geometry/triangle_size.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scan
{
namespace
{

constexpr double kExcessWeight = 0.2;
constexpr double kDoubtShare = 0.005; // of the points: closed surfaces that cost less are taken
constexpr double kClearShare = 0.65;  // of the closed surface's cost: an open one must cost less

/// What both starts work on.
struct Scan
{
  const FlowComplex& flow;
  const Basins& basins;
  const std::vector<float>& spacing;
  bool fineTune;

  const DelaunayComplex& complex() const { return this->flow.delaunay(); }
};

/// Swaps the sides where most of the outside is on side 1.
void nameSides(const OutsideRooms& outside, std::vector<std::uint8_t>& side, Index basinCount)
{
  const auto inwards = std::count_if(outside.room.begin(), outside.room.end(),
    [&](Index room) { return side[basinCount + room] == 1; });
  if (2 * static_cast<std::size_t>(inwards) > outside.room.size())
  {
    for (std::uint8_t& label : side)
    {
      label ^= 1U;
    }
  }
}

/// Refines a start: a side for every basin and every room of the outside.
AutomaticWrap refined(const Scan& scan, const std::vector<Wall>& walls, OutsideRooms outside,
  FinestGroups finest, std::vector<std::uint8_t> start, Execution& execution)
{
  std::vector<std::uint8_t> side =
    refineBasins(scan.flow, scan.basins, walls, scan.spacing, finest, std::move(start), execution);
  nameSides(outside, side, scan.basins.count());
  std::copy(side.begin() + scan.basins.count(), side.end(), outside.side.begin());
  AutomaticWrap wrap;
  wrap.inside.resize(scan.complex().tetCount());
  for (Index tet = 0; tet < scan.complex().tetCount(); ++tet)
  {
    wrap.inside[tet] = side[scan.basins.ofTet[tet]];
  }
  if (scan.fineTune)
  {
    FineTuned tuned = fineTune(scan.flow, scan.spacing, outside, std::move(wrap.inside), execution);
    wrap.inside = std::move(tuned.inside);
    wrap.surface = std::move(tuned.cut);
  }
  else
  {
    wrap.surface = cutTriangles(scan.complex(), outside, wrap.inside, execution);
  }
  return wrap;
}

AutomaticWrap closedWrap(const Scan& scan, const std::vector<Wall>& walls, Execution& execution)
{
  std::vector<std::uint8_t> start = persistentRooms(scan.flow, scan.basins, walls, execution);
  start.push_back(0); // the outside
  return refined(scan, walls, oneOutside(scan.complex(), execution), FinestGroups::widestDoors,
    std::move(start), execution);
}

AutomaticWrap openWrap(const Scan& scan, std::vector<Wall> walls, Execution& execution)
{
  const OutsideRooms outside = denseOutside(scan.complex(), scan.spacing, execution);
  const Index basinCount = scan.basins.count();
  std::erase_if(walls,
    [&](Wall& wall)
    {
      const bool onHull = wall.b == basinCount;
      const Index room = onHull ? outside.beyond(wall.facet) : 0;
      wall.b += room != kNone ? room : 0;
      return room == kNone;
    });
  std::vector<std::uint8_t> start =
    signedRooms(scan.flow, scan.basins, walls, basinCount + outside.count(), execution);
  AutomaticWrap wrap =
    refined(scan, walls, outside, FinestGroups::singleBasins, std::move(start), execution);
  std::vector<Facet> shown = withoutOpenings(scan.complex(), scan.spacing, wrap.surface);
  wrap.isOpen = true;
  wrap.openingTriangles = static_cast<Index>(wrap.surface.size() - shown.size());
  wrap.surface = std::move(shown);
  return wrap;
}

TriMesh meshOf(const DelaunayComplex& complex, const AutomaticWrap& wrap)
{
  TriMesh mesh{ complex.points, {} };
  mesh.triangles.reserve(wrap.surface.size());
  for (const Facet facet : wrap.surface)
  {
    mesh.triangles.push_back(outwardVertices(complex, wrap.inside, facet));
  }
  return mesh;
}

double excessOf(const Scan& scan, const AutomaticWrap& wrap, Execution& execution)
{
  std::vector<double> excess(wrap.surface.size());
  execution.parallelFor(excess.size(), 1 << 13,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Triangle triangle = scan.complex().facetVertices(wrap.surface[i]);
        excess[i] = TriangleSize(scan.complex(), scan.spacing, triangle).excess();
      }
    });
  return std::accumulate(excess.begin(), excess.end(), 0.0);
}

/// Whether a closed surface is so far from covering every point by one surface without webs that an
/// open one may do better; spares the second start where it would only cost time.
bool mayBeOpen(const Scan& scan, const AutomaticWrap& closed, Execution& execution)
{
  std::vector<std::uint8_t> covered(scan.complex().points.size(), 0);
  for (const Facet facet : closed.surface)
  {
    for (const Index v : scan.complex().facetVertices(facet))
    {
      covered[v] = 1;
    }
  }
  const auto points = static_cast<double>(std::count(covered.begin(), covered.end(), 1));
  const double missed = static_cast<double>(covered.size()) - points;
  const double euler = points - 0.5 * static_cast<double>(closed.surface.size());
  const double cost =
    missed + std::abs(2.0 - euler) + kExcessWeight * excessOf(scan, closed, execution);
  return cost > kDoubtShare * static_cast<double>(covered.size());
}

/// What keeps the surface that is shown from being one surface through every point; see
/// wrapAutomatically(). Crumbs earn nothing, though each has the Euler characteristic of a sphere.
double costOf(const Scan& scan, const AutomaticWrap& wrap, Execution& execution)
{
  const MeshReport mesh = describeMesh(meshOf(scan.complex(), wrap));
  const auto components = static_cast<double>(mesh.components.size());
  const double handles = components -
    0.5 *
      static_cast<double>(mesh.eulerCharacteristic + static_cast<std::int64_t>(mesh.boundaryLoops));
  return static_cast<double>(mesh.points - mesh.pointsUsed) + components + 2.0 * std::abs(handles) +
    0.25 * mesh.boundaryEdges + 0.5 * mesh.nonManifoldEdges +
    kExcessWeight * excessOf(scan, wrap, execution);
}

} // namespace

std::vector<Phase> automaticWrapPhases(const AutomaticWrapOptions& options)
{
  std::vector<Phase> phases{ { "edges", 1.0 }, { "walls", 0.3 } };
  if (options.opening != Opening::keep)
  {
    phases.push_back({ "rooms", 1.0 });
  }
  if (options.opening != Opening::cap)
  {
    phases.push_back({ "sides", 0.5 });
  }
  phases.push_back({ "refine", 2.0 });
  if (options.fineTune)
  {
    phases.push_back({ "fine-tune", 1.0 });
  }
  return phases;
}

AutomaticWrap wrapAutomatically(const FlowComplex& flow, const Basins& basins,
  const AutomaticWrapOptions& options, Execution& execution)
{
  const std::vector<float> spacing = localSpacing(flow, execution);
  const std::vector<Wall> walls = findWalls(flow, basins, execution);
  const Scan scan{ flow, basins, spacing, options.fineTune };
  if (options.opening == Opening::keep)
  {
    return openWrap(scan, walls, execution);
  }
  AutomaticWrap closed = closedWrap(scan, walls, execution);
  if (options.opening == Opening::cap || !mayBeOpen(scan, closed, execution))
  {
    return closed;
  }
  AutomaticWrap open = openWrap(scan, walls, execution);
  const bool isBetter =
    costOf(scan, open, execution) < kClearShare * costOf(scan, closed, execution);
  return isBetter ? open : closed;
}

} // namespace scan
