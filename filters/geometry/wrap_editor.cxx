// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap_editor.h"

#include <algorithm>
#include <bit>

namespace scan
{
namespace
{

constexpr std::size_t kStepsBetweenChecks = 1 << 14;

/// Calls act(edge) for the three edges of a triangle.
template <class Act>
void forEachEdge(const DelaunayComplex& complex, Facet facet, Act&& act)
{
  for (const Index apex : complex.facetVertices(facet))
  {
    act(EdgeOfTriangle{ facet, apex });
  }
}

} // namespace

WrapEditor::WrapEditor(WrapComplex& complex, std::span<const CriticalEdge> lines)
  : Kept(complex)
  , Flow(complex.flow())
  , Complex(Flow.delaunay())
  , Lines(lines)
{
}

bool WrapEditor::isLine(EdgeOfTriangle edge) const
{
  return !this->Lines.empty() &&
    std::ranges::binary_search(this->Lines, this->verticesOf(edge), {}, &CriticalEdge::vertices);
}

Segment WrapEditor::verticesOf(EdgeOfTriangle edge) const
{
  Segment ends{};
  auto end = ends.begin();
  for (const Index v : this->Complex.facetVertices(edge.triangle))
  {
    if (v != edge.apex)
    {
      *end++ = v;
    }
  }
  std::ranges::sort(ends);
  return ends;
}

void WrapEditor::removeTet(Index tet)
{
  this->Kept.dropTet(tet);
  --this->Change.tetrahedra;
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    if (this->Kept.keptSides(facet) == 0)
    {
      this->Kept.keepSheet(facet);
      this->BaredSheets.push_back(facet);
      continue;
    }
    const Facet mirror = this->Complex.mirror[tet][facet % 4];
    if (this->Flow.isAttached(mirror) && !this->Flow.hasTwoAttached(mirror / 4))
    {
      this->Tets.push_back(mirror / 4); // [facet, tetrahedron]
    }
  }
}

void WrapEditor::removeSheet(Facet facet)
{
  this->Kept.dropSheet(facet);
  --this->Change.triangles;
  forEachEdge(this->Complex, facet, [&](EdgeOfTriangle edge) { this->reviewEdge(edge); });
}

/// After the loss of a triangle at the edge: the edge goes when it was the last one; what is left
/// may form an interval with it that collapses now. Nothing else may: a state that does not follow
/// the flow has other intervals that could.
void WrapEditor::reviewEdge(EdgeOfTriangle edge)
{
  // usually another tetrahedron is kept next to the one that went with the triangle: without a
  // walk it is clear that the edge stays, and that only [edge, this tetrahedron] may collapse
  const Index tet = edge.triangle / 4;
  const Index next = this->Complex.neighbour(tet, this->Complex.localIndex(tet, edge.apex));
  if (next != kNone && this->Kept.keepsTet(next))
  {
    this->reviewInterval(edge, next);
    return;
  }
  int count = 0;
  EdgeOfTriangle last{ kNone, kNone };
  forEachTriangleAtEdge(this->Complex, edge,
    [&](Facet at, Index apex)
    {
      if (this->Kept.keepsTriangle(at))
      {
        ++count;
        last = { at, apex };
      }
      return count < 3;
    });
  if (count == 0)
  {
    this->Change.edges -= this->isLine(edge) ? 0 : 1;
  }
  else if (count == 1 && this->Flow.isFree(last.triangle) &&
    this->Flow.obtuseVertex(last.triangle) == last.apex)
  {
    this->Triangles.push_back(last.triangle);
  }
  else if (count == 2)
  {
    const Index own = last.triangle / 4;
    const Index beyond = this->Complex.neighbour(own, static_cast<int>(last.triangle % 4));
    this->reviewInterval(edge, this->Kept.keepsTet(own) || beyond == kNone ? own : beyond);
  }
}

/// Looks at the tetrahedron when [edge, tetrahedron] is an interval.
void WrapEditor::reviewInterval(EdgeOfTriangle edge, Index tet)
{
  if (!this->Flow.hasTwoAttached(tet))
  {
    return;
  }
  unsigned beside = 0; // corners that are not on the edge: the facets opposite to them meet there
  const Segment ends = this->verticesOf(edge);
  for (unsigned k = 0; k < 4; ++k)
  {
    const Index corner = this->Complex.tetrahedra[tet][k];
    beside |= static_cast<unsigned>(corner != ends[0] && corner != ends[1]) << k;
  }
  if (beside == this->Flow.attachedFacets(tet))
  {
    this->Tets.push_back(tet);
  }
}

void WrapEditor::removeVolumes(
  std::span<const Index> volumes, const Blocks& blocks, Execution& execution)
{
  for (const Index volume : volumes)
  {
    if (this->Kept.keepsTet(blocks.sink(volume)))
    {
      this->removeTet(blocks.sink(volume));
    }
  }
  this->collapse(execution);
}

Index WrapEditor::choose(
  const CollapseGraph& graph, const CriticalChoice& choice, Execution& execution)
{
  const BulkReport report = editInBulk(this->Kept, graph, choice, execution);
  this->Change += report.change;
  return report.criticalTriangles;
}

void WrapEditor::collapse(Execution& execution)
{
  std::size_t steps = 0;
  while (!this->Tets.empty() || !this->Triangles.empty())
  {
    if (++steps % kStepsBetweenChecks == 0)
    {
      execution.step("edit", 0, 1);
    }
    if (!this->Tets.empty())
    {
      const Index tet = this->Tets.back();
      this->Tets.pop_back();
      this->collapseTet(tet);
    }
    else
    {
      const Facet facet = this->Triangles.back();
      this->Triangles.pop_back();
      this->collapseTriangle(facet);
    }
  }
}

/// Removes [facet, tet] or [edge, tet] when nothing else is kept at the facet or edge.
void WrapEditor::collapseTet(Index tet)
{
  const unsigned attached = this->Flow.attachedFacets(tet);
  if (attached == 0 || !this->Kept.keepsTet(tet))
  {
    return;
  }
  for (unsigned rest = attached; rest != 0; rest &= rest - 1)
  {
    if (this->Kept.keptSides(4 * tet + static_cast<Facet>(std::countr_zero(rest))) == 2)
    {
      return;
    }
  }
  if (this->Flow.hasTwoAttached(tet) &&
    keptTrianglesAtEdge(this->Kept, sharedEdge(this->Flow, tet), 3) > 2)
  {
    return;
  }
  this->removeTet(tet);
  for (unsigned rest = attached; rest != 0; rest &= rest - 1)
  {
    this->removeSheet(4 * tet + static_cast<Facet>(std::countr_zero(rest)));
  }
}

/// Removes [edge, triangle] when nothing else is kept at the edge.
void WrapEditor::collapseTriangle(Facet facet)
{
  if (!this->Kept.isSheet(facet) || !this->Flow.isFree(facet))
  {
    return;
  }
  const Index apex = this->Flow.obtuseVertex(facet);
  if (apex != kNone && keptTrianglesAtEdge(this->Kept, { facet, apex }, 2) == 1)
  {
    this->removeSheet(facet);
  }
}

/// Counts the edge unless it is there already. Before the triangle is kept.
void WrapEditor::meetEdge(EdgeOfTriangle edge)
{
  const bool isThere = keptTrianglesAtEdge(this->Kept, edge, 1) > 0 || this->isLine(edge);
  this->Change.edges += isThere ? 0 : 1;
}

void WrapEditor::addSheet(Facet facet)
{
  if (this->Kept.keepsTriangle(facet))
  {
    return;
  }
  forEachEdge(this->Complex, facet, [&](EdgeOfTriangle edge) { this->meetEdge(edge); });
  this->Kept.keepSheet(facet);
  ++this->Change.triangles;
}

void WrapEditor::addTet(Index tet)
{
  if (this->Kept.keepsTet(tet))
  {
    return;
  }
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    this->addSheet(facet);
  }
  this->Kept.keepTet(tet);
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    this->Kept.dropSheet(facet);
  }
  ++this->Change.tetrahedra;
}

void WrapEditor::addLowerSet(Index tet, const WrapComplex* within, Execution& execution)
{
  this->addLowerSets({ tet }, {}, within, execution);
}

void WrapEditor::addLowerSetOfTriangle(Facet facet, const WrapComplex* within, Execution& execution)
{
  this->addLowerSets({}, { facet }, within, execution);
}

/// Adds each simplex of the lists, and to the lists the intervals that its faces belong to.
void WrapEditor::addLowerSets(std::vector<Index> tets, std::vector<Facet> triangles,
  const WrapComplex* within, Execution& execution)
{
  const auto listOwner = [&](EdgeOfTriangle edge)
  {
    const EdgeInterval owner = intervalOfEdge(this->Flow, edge);
    if (owner.tet != kNone)
    {
      tets.push_back(owner.tet);
    }
    if (owner.triangle != kNone)
    {
      triangles.push_back(owner.triangle);
    }
  };
  const auto listFacesOf = [&](Index tet)
  {
    for (Facet k = 0; k < 4; ++k)
    {
      const Facet mirror = this->Complex.mirror[tet][k];
      if (mirror != kNone && this->Flow.isAttached(mirror))
      {
        tets.push_back(mirror / 4);
      }
      for (Facet other = 0; other < k; ++other) // the edge that the two facets share
      {
        listOwner({ 4 * tet + k, this->Complex.tetrahedra[tet][other] });
      }
    }
  };
  std::size_t steps = 0;
  while (!tets.empty() || !triangles.empty())
  {
    if (++steps % kStepsBetweenChecks == 0)
    {
      execution.step("edit", 0, 1);
    }
    if (!tets.empty())
    {
      const Index tet = tets.back();
      tets.pop_back();
      if (!this->Kept.keepsTet(tet) && (within == nullptr || within->keepsTet(tet)))
      {
        this->addTet(tet);
        listFacesOf(tet);
      }
    }
    else
    {
      const Facet facet = triangles.back();
      triangles.pop_back();
      if (!this->Kept.keepsTriangle(facet) && (within == nullptr || within->keepsTriangle(facet)))
      {
        this->addSheet(facet);
        forEachEdge(this->Complex, facet, listOwner);
      }
    }
  }
}

} // namespace scan
