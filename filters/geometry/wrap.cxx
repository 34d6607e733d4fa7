// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/front_wrap.h"
#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/outside_rooms.h"
#include "filters/geometry/size_scale.h"
#include "filters/geometry/wrap_editor.h"

#include <algorithm>
#include <optional>

namespace scan
{
namespace
{

AutomaticWrapOptions automaticOptions(const WrapOptions& options)
{
  return { .fineTune = options.fit == WrapOptions::Fit::all, .opening = options.opening };
}

WrapModel wrapClassic(
  std::shared_ptr<const ScanComplex> scan, const WrapOptions& options, Execution& execution)
{
  auto kept = std::make_shared<WrapComplex>(collapseFromOutside(scan->flow(), execution));
  WrapModel model;
  model.lines = std::make_shared<const std::vector<CriticalEdge>>(bareEdges(*kept, execution));
  model.start = kept;
  model.current = kept;
  if (options.size < std::numeric_limits<double>::infinity())
  {
    auto opened = std::make_shared<WrapComplex>(*kept);
    WrapEditor editor(*opened, *model.lines);
    scan->sizes(execution).resize(
      editor, *opened, std::numeric_limits<double>::infinity(), options.size, execution);
    model.current = opened;
  }
  model.scan = std::move(scan);
  return model;
}

/// A model of labelled tetrahedra, or of sheets alone.
WrapModel modelOf(
  std::shared_ptr<const ScanComplex> scan, std::shared_ptr<const WrapComplex> kept, bool isSolid)
{
  WrapModel model;
  model.isSolid = isSolid;
  model.start = kept;
  model.current = std::move(kept);
  model.lines = std::make_shared<const std::vector<CriticalEdge>>();
  model.scan = std::move(scan);
  return model;
}

/// Also tells the boundary of a closed surface, which has been found on the way.
WrapModel wrapAutomatic(std::shared_ptr<const ScanComplex> scan, const WrapOptions& options,
  WrapReport& report, std::optional<std::vector<Facet>>& boundary, Execution& execution)
{
  AutomaticWrap found =
    wrapAutomatically(scan->flow(), scan->basins(), automaticOptions(options), execution);
  auto kept = std::make_shared<WrapComplex>(scan->flow());
  if (found.isOpen)
  {
    std::ranges::for_each(found.surface, [&](Facet facet) { kept->keepSheet(facet); });
  }
  for (Index tet = 0; !found.isOpen && tet < scan->delaunay().tetCount(); ++tet)
  {
    if (found.inside[tet])
    {
      kept->keepTet(tet);
    }
  }
  if (!found.isOpen)
  {
    boundary = std::move(found.surface);
  }
  report.isOpen = found.isOpen;
  report.openingTriangles = found.openingTriangles;
  WrapModel model = modelOf(std::move(scan), std::move(kept), !found.isOpen);
  model.inside = std::make_shared<const std::vector<std::uint8_t>>(std::move(found.inside));
  return model;
}

WrapModel wrapFront(std::shared_ptr<const ScanComplex> scan, Execution& execution)
{
  const DelaunayComplex& complex = scan->delaunay();
  const auto sorted = [](Triangle triangle)
  {
    std::ranges::sort(triangle);
    return triangle;
  };
  std::vector<Triangle> front = frontWrap(complex.points, execution);
  std::ranges::transform(front, front.begin(), sorted);
  std::ranges::sort(front);
  auto kept = std::make_shared<WrapComplex>(scan->flow());
  for (Facet facet = 0; facet < 4 * complex.tetCount(); ++facet)
  {
    if (complex.canonical(facet) == facet &&
      std::ranges::binary_search(front, sorted(complex.facetVertices(facet))))
    {
      kept->keepSheet(facet);
    }
  }
  return modelOf(std::move(scan), std::move(kept), false);
}

/// The boundary of the solids, seen from them.
std::vector<Facet> boundaryFacets(const WrapComplex& kept, Execution& execution)
{
  return collect<Facet>(kept.flow().delaunay().tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (Facet facet = 4 * tet; kept.keepsTet(tet) && facet < 4 * tet + 4; ++facet)
      {
        if (kept.keptSides(facet) == 1)
        {
          found.push_back(facet);
        }
      }
    });
}

/// Moves a surface on all vertices of the complex to the vertices it uses, in the same order.
void compact(const DelaunayComplex& complex, WrapResult& result, Execution& execution)
{
  constexpr Index kUsed = kNone - 1;
  std::vector<Index> number(complex.points.size(), kNone);
  for (const Triangle& triangle : result.surface.triangles)
  {
    for (const Index v : triangle)
    {
      number[v] = kUsed;
    }
  }
  result.report.pointsOnSurface =
    static_cast<Index>(std::count(number.begin(), number.end(), kUsed));
  for (const Segment& line : result.lines)
  {
    number[line[0]] = kUsed;
    number[line[1]] = kUsed;
  }
  for (Index v = 0; v < number.size(); ++v)
  {
    if (number[v] == kUsed)
    {
      number[v] = static_cast<Index>(result.surface.points.size());
      result.surface.points.push_back(complex.points[v]);
      result.scanPointIds.push_back(complex.scanPoint[v]);
    }
  }
  const auto renumber = [&](auto& cells)
  {
    execution.parallelFor(cells.size(), 1 << 14,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          for (Index& v : cells[i])
          {
            v = number[v];
          }
        }
      });
  };
  renumber(result.surface.triangles);
  renumber(result.lines);
}

/// Splits what is not a manifold and gives the new points the scan points of their originals.
void makeManifold(WrapResult& result, Execution& execution)
{
  SplitResult split = splitNonManifold(std::move(result.surface), execution);
  std::vector<Index> scanPointIds(split.pointOrigin.size());
  for (std::size_t v = 0; v < scanPointIds.size(); ++v)
  {
    scanPointIds[v] = result.scanPointIds[split.pointOrigin[v]];
  }
  result.surface = std::move(split.mesh);
  result.scanPointIds = std::move(scanPointIds);
  result.report.nonManifoldEdges = split.edgesSplit;
  result.report.nonManifoldVertices = split.verticesSplit;
}

/// The surface of a model whose solids have this boundary.
WrapResult surfaceFrom(
  const WrapModel& model, std::vector<Facet> boundary, bool manifold, Execution& execution)
{
  execution.step("surface", 1, 4);
  const DelaunayComplex& complex = model.scan->delaunay();
  WrapResult result;
  result.model = model;
  result.facets = std::move(boundary);
  const std::vector<Facet> sheets = sheetsOf(*model.current, execution);
  result.report.boundaryTriangles = static_cast<Index>(result.facets.size());
  result.report.sheetTriangles = static_cast<Index>(sheets.size());
  result.report.tetrahedraKept = model.current->keptTetCount();
  const auto trianglesOf = [&](const std::vector<Facet>& facets)
  {
    std::vector<Triangle> triangles(facets.size());
    execution.parallelFor(facets.size(), 1 << 14,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t t = begin; t < end; ++t)
        {
          triangles[t] = complex.facetVertices(facets[t]);
        }
      });
    return triangles;
  };
  result.surface.triangles = trianglesOf(result.facets);
  if (!sheets.empty())
  {
    std::vector<Triangle> oriented = trianglesOf(sheets);
    for (std::size_t t = 0; model.inside && t < sheets.size(); ++t)
    {
      oriented[t] = outwardVertices(complex, *model.inside, sheets[t]);
    }
    orientConsistently(oriented, complex.points.size());
    result.facets.insert(result.facets.end(), sheets.begin(), sheets.end());
    result.surface.triangles.insert(
      result.surface.triangles.end(), oriented.begin(), oriented.end());
  }
  for (const CriticalEdge& line : *model.lines)
  {
    if (keptTrianglesAtEdge(*model.current, { line.triangle, line.apex }, 1) == 0)
    {
      result.lines.push_back(line.vertices);
    }
  }
  execution.step("surface", 2, 4);
  compact(complex, result, execution);
  result.report.duplicatesMerged = complex.duplicates;
  result.report.pointsRead = static_cast<Index>(complex.points.size()) + complex.duplicates;
  result.report.tetrahedra = complex.tetCount();
  execution.step("surface", 3, 4);
  result.isSplit = manifold;
  if (manifold)
  {
    makeManifold(result, execution);
  }
  execution.step("surface", 4, 4);
  return result;
}

} // namespace

std::vector<Phase> wrapPhases(const WrapOptions& options)
{
  std::vector<Phase> phases{ { "triangulate", 10.0 }, { "classify", 1.0 }, { "basins", 1.0 } };
  if (options.mode == WrapOptions::Mode::classic)
  {
    phases.insert(phases.end(), { { "collapse", 2.0 }, { "edges", 1.0 } });
    if (options.size < std::numeric_limits<double>::infinity())
    {
      phases.push_back({ "blocks", 1.0 });
    }
  }
  else if (options.mode == WrapOptions::Mode::front)
  {
    phases.push_back({ "front", 20.0 });
  }
  else
  {
    const std::vector<Phase> automatic = automaticWrapPhases(automaticOptions(options));
    phases.insert(phases.end(), automatic.begin(), automatic.end());
  }
  phases.push_back({ "surface", 1.0 });
  return phases;
}

WrapResult wrap(std::span<const Vec3> points, const WrapOptions& options, Execution& execution)
{
  return wrap(std::make_shared<const ScanComplex>(points, execution), options, execution);
}

WrapResult wrap(
  std::shared_ptr<const ScanComplex> scan, const WrapOptions& options, Execution& execution)
{
  using Mode = WrapOptions::Mode;
  WrapReport found;
  std::optional<std::vector<Facet>> boundary;
  const WrapModel model = options.mode == Mode::classic
    ? wrapClassic(std::move(scan), options, execution)
    : options.mode == Mode::front
    ? wrapFront(std::move(scan), execution)
    : wrapAutomatic(std::move(scan), options, found, boundary, execution);
  execution.step("surface", 0, 4);
  WrapResult result =
    surfaceFrom(model, boundary ? std::move(*boundary) : boundaryFacets(*model.current, execution),
      options.manifold, execution);
  result.report.isOpen = found.isOpen;
  result.report.openingTriangles = found.openingTriangles;
  return result;
}

WrapResult surfaceOf(const WrapModel& model, bool manifold, Execution& execution)
{
  execution.step("surface", 0, 4);
  return surfaceFrom(model, boundaryFacets(*model.current, execution), manifold, execution);
}

} // namespace scan
