// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/size_scale.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/parallel_sort.h"
#include "filters/geometry/scan_complex.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace scan
{
namespace
{

/// The entries with to < radius <= from.
template <class Entry>
std::span<const Entry> between(const std::vector<Entry>& entries, double from, double to)
{
  const auto first =
    std::ranges::partition_point(entries, [&](const Entry& entry) { return entry.radius > from; });
  const auto last =
    std::ranges::partition_point(entries, [&](const Entry& entry) { return entry.radius > to; });
  return first < last ? std::span<const Entry>(first, last) : std::span<const Entry>();
}

} // namespace

SizeScale::SizeScale(const ScanComplex& scan, const Blocks& blocks, Execution& execution)
  : Scan(scan)
  , TheBlocks(blocks)
{
  const FlowComplex& flow = blocks.flow();
  const DelaunayComplex& complex = flow.delaunay();
  for (Index block = 0; block < blocks.outside(); ++block)
  {
    if (blocks.isVolume(block))
    {
      this->Openings.push_back({ blocks.opening(block), block });
    }
  }
  this->Triangles = collect<Entry>(4 * complex.tetCount(), execution,
    [&](Facet facet, auto& found)
    {
      if (complex.canonical(facet) == facet && flow.isCriticalTriangle(facet))
      {
        found.push_back({ circumradius(complex, facet), facet });
      }
    });
  const auto wideFirst = [](const Entry& a, const Entry& b)
  { return a.radius != b.radius ? a.radius > b.radius : a.name < b.name; };
  std::ranges::sort(this->Openings, wideFirst);
  sortInParallel(this->Triangles, execution, wideFirst);
}

void SizeScale::resize(WrapEditor& editor, const WrapComplex& complex, double from, double to,
  Execution& execution) const
{
  std::int64_t tets = 0;
  for (const Entry& entry : between(this->Openings, std::max(from, to), std::min(from, to)))
  {
    tets += this->TheBlocks.tetCount(entry.name);
  }
  // a triangle costs as much as so many tetrahedra, with what collapses after it
  constexpr std::int64_t kTetsATriangle = 16;
  const auto triangles = between(this->Triangles, std::max(from, to), std::min(from, to));
  tets += kTetsATriangle * static_cast<std::int64_t>(triangles.size());
  const CollapseGraph* graph = this->Scan.graphFor(complex, tets, execution);
  if (graph != nullptr)
  {
    editor.choose(*graph, this->choiceOf(*graph, complex, from, to), execution);
    return;
  }
  if (to < from)
  {
    this->open(editor, complex, from, to, execution);
    return;
  }
  for (const Entry& entry : between(this->Openings, to, from))
  {
    editor.addLowerSet(this->TheBlocks.sink(entry.name), nullptr, execution);
  }
  for (const Entry& entry : between(this->Triangles, to, from))
  {
    editor.addLowerSetOfTriangle(entry.name, nullptr, execution);
  }
}

/// Between the two sizes everything changes; what is wider than both stays as it is.
CriticalChoice SizeScale::choiceOf(
  const CollapseGraph& graph, const WrapComplex& complex, double from, double to) const
{
  CriticalChoice choice = criticalChoiceOf(complex, this->TheBlocks.basins());
  for (const Entry& entry : between(this->Openings, std::max(from, to), std::min(from, to)))
  {
    choice.holdsBasin[entry.name] = to > from ? 1 : 0;
  }
  if (to > from)
  {
    choice.keepsTriangle = [&graph, from, to](Index i, bool was)
    { return was || (graph.radiusOf(i) > from && graph.radiusOf(i) <= to); };
  }
  else
  {
    choice.keepsTriangle = [&graph, &complex, from, to](Index i, bool was)
    {
      const double radius = graph.radiusOf(i);
      return was &&
        (radius <= to || (radius > from && complex.isSheetNamed(graph.criticalTriangles()[i])));
    };
  }
  return choice;
}

void SizeScale::open(WrapEditor& editor, const WrapComplex& complex, double from, double to,
  Execution& execution) const
{
  std::vector<Index> opened;
  for (const Entry& entry : between(this->Openings, from, to))
  {
    opened.push_back(entry.name);
  }
  editor.removeVolumes(opened, this->TheBlocks, execution);
  const auto removeIfBare = [&](Facet triangle)
  {
    if (complex.isSheet(triangle))
    {
      editor.removeSheet(triangle);
    }
  };
  for (const Entry& entry : between(this->Triangles, from, to))
  {
    removeIfBare(entry.name);
  }
  editor.collapse(execution);
  // wider ones stood as long as there was a solid beside them, and each that goes may bare others
  const FlowComplex& flow = this->TheBlocks.flow();
  for (std::size_t i = 0; i < editor.baredSheets().size(); ++i)
  {
    const Facet triangle = editor.baredSheets()[i];
    if (flow.isCriticalTriangle(triangle) && circumradius(flow.delaunay(), triangle) > to)
    {
      removeIfBare(triangle);
      editor.collapse(execution);
    }
  }
}

} // namespace scan
