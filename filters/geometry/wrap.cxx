// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap.h"

#include "filters/geometry/automatic_wrap.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/mesh_orient.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/wrap_complex.h"

#include <algorithm>

namespace scan
{
namespace
{

/// Moves a surface on all vertices of the complex to the vertices it uses, in the same order.
void compact(const DelaunayComplex& complex, WrapResult& result)
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
    for (auto& cell : cells)
    {
      for (Index& v : cell)
      {
        v = number[v];
      }
    }
  };
  renumber(result.surface.triangles);
  renumber(result.lines);
}

/// The wanted facets as triangles that face away from their tetrahedra.
template <class Wanted>
std::vector<Triangle> collectFacets(
  const DelaunayComplex& complex, Execution& execution, Wanted&& wanted)
{
  return collect<Triangle>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        if (wanted(facet))
        {
          found.push_back(complex.facetVertices(facet));
        }
      }
    });
}

AutomaticWrapOptions automaticOptions(WrapOptions::Fit fit)
{
  return { .fineTune = fit == WrapOptions::Fit::all };
}

WrapResult wrapClassic(const DelaunayComplex& complex, Execution& execution)
{
  const FlowComplex flow(complex, execution);
  const WrapComplex kept = collapseFromOutside(flow, execution);
  WrapResult result;
  result.surface.triangles = collectFacets(complex, execution,
    [&](Facet facet) { return kept.keepsTet(facet / 4) && kept.keptSides(facet) == 1; });
  std::vector<Triangle> sheets = collectFacets(complex, execution,
    [&](Facet facet) { return kept.isSheet(facet) && complex.canonical(facet) == facet; });
  orientConsistently(sheets, complex.points.size());
  result.report.tetrahedraKept = kept.keptTetCount();
  result.report.boundaryTriangles = static_cast<Index>(result.surface.triangles.size());
  result.report.sheetTriangles = static_cast<Index>(sheets.size());
  result.surface.triangles.insert(result.surface.triangles.end(), sheets.begin(), sheets.end());
  result.lines = keptLines(kept, execution);
  return result;
}

WrapResult wrapAutomatic(const DelaunayComplex& complex, WrapOptions::Fit fit, Execution& execution)
{
  const FlowComplex flow(complex, execution);
  const Basins basins = findBasins(flow, execution);
  const AutomaticWrap found = wrapAutomatically(flow, basins, automaticOptions(fit), execution);
  WrapResult result;
  result.surface.triangles.reserve(found.surface.size());
  for (const Facet facet : found.surface)
  {
    result.surface.triangles.push_back(complex.facetVertices(facet));
  }
  result.report.tetrahedraKept =
    static_cast<Index>(std::count(found.inside.begin(), found.inside.end(), std::uint8_t{ 1 }));
  result.report.boundaryTriangles = static_cast<Index>(result.surface.triangles.size());
  return result;
}

/// Splits what is not a manifold and gives the new points the scan points of their originals.
void makeManifold(WrapResult& result)
{
  SplitResult split = splitNonManifold(result.surface);
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

} // namespace

std::vector<Phase> wrapPhases(const WrapOptions& options)
{
  std::vector<Phase> phases{ { "triangulate", 10.0 }, { "classify", 1.0 } };
  if (options.mode == WrapOptions::Mode::classic)
  {
    phases.insert(phases.end(), { { "collapse", 2.0 }, { "edges", 1.0 } });
  }
  else
  {
    phases.push_back({ "basins", 1.0 });
    const std::vector<Phase> automatic = automaticWrapPhases(automaticOptions(options.fit));
    phases.insert(phases.end(), automatic.begin(), automatic.end());
  }
  phases.push_back({ "surface", 1.0 });
  return phases;
}

WrapResult wrap(std::span<const Vec3> points, const WrapOptions& options, Execution& execution)
{
  const DelaunayComplex complex = buildDelaunayComplex(points, execution);
  WrapResult result = options.mode == WrapOptions::Mode::classic
    ? wrapClassic(complex, execution)
    : wrapAutomatic(complex, options.fit, execution);
  execution.step("surface", 0, 2);
  compact(complex, result);
  result.report.pointsRead = static_cast<Index>(points.size());
  result.report.duplicatesMerged = complex.duplicates;
  result.report.tetrahedra = complex.tetCount();
  execution.step("surface", 1, 2);
  if (options.manifold)
  {
    makeManifold(result);
  }
  execution.step("surface", 2, 2);
  return result;
}

} // namespace scan
