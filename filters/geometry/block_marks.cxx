// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/block_marks.h"

#include "filters/base/error.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/delaunay_predicates.h"
#include "filters/geometry/facet_search.h"
#include "filters/geometry/wrap_editor.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace scan
{
namespace
{

/// A tetrahedron or a sheet triangle that is kept.
struct Holder
{
  Index tet = kNone;
  Facet sheet = kNone;
};

/// The widest kept coface, outside its own interval, of what is kept at an edge.
Holder widestAtEdge(const WrapComplex& kept, EdgeOfTriangle edge, Index ownTet, Facet ownTriangle)
{
  const DelaunayComplex& complex = kept.flow().delaunay();
  Holder widest;
  double radius2 = -1.0;
  const auto offer = [&](Holder holder, double candidate)
  {
    if (candidate > radius2)
    {
      radius2 = candidate;
      widest = holder;
    }
  };
  forEachTriangleAtEdge(complex, edge,
    [&](Facet at, Index)
    {
      const Facet mirror = complex.mirror[at / 4][at % 4];
      for (const Facet side : { at, mirror })
      {
        if (side != kNone && side / 4 != ownTet && kept.keepsTet(side / 4))
        {
          offer({ .tet = side / 4 }, circumradiusSquared(complex, side / 4));
        }
      }
      if (kept.isSheet(at) && complex.canonical(at) != ownTriangle)
      {
        offer({ .sheet = complex.canonical(at) },
          circumradiusSquared(complex, complex.facetVertices(at)));
      }
      return true;
    });
  return widest;
}

/// One step up the flow among what is kept; nothing at a critical simplex, or where an edit left
/// over what nothing else holds.
Holder holderOf(const WrapComplex& kept, const Holder& held)
{
  const FlowComplex& flow = kept.flow();
  const DelaunayComplex& complex = flow.delaunay();
  if (held.tet == kNone)
  {
    const Index apex = flow.isFree(held.sheet) ? flow.obtuseVertex(held.sheet) : kNone;
    return apex == kNone ? Holder{} : widestAtEdge(kept, { held.sheet, apex }, kNone, held.sheet);
  }
  const unsigned attached = flow.attachedFacets(held.tet);
  Holder widest;
  double radius2 = -1.0;
  for (unsigned rest = attached; rest != 0; rest &= rest - 1)
  {
    const Index beyond = complex.neighbour(held.tet, std::countr_zero(rest));
    if (beyond != kNone && kept.keepsTet(beyond) && circumradiusSquared(complex, beyond) > radius2)
    {
      radius2 = circumradiusSquared(complex, beyond);
      widest.tet = beyond;
    }
  }
  if (widest.tet != kNone || !flow.hasTwoAttached(held.tet))
  {
    return widest;
  }
  return widestAtEdge(kept, sharedEdge(flow, held.tet), held.tet, kNone);
}

/// The tetrahedron around a point, kNone outside the convex hull. A walk that crosses any facet
/// towards the point ends in a Delaunay complex: Edelsbrunner, "An acyclicity theorem for cell
/// complexes in d dimensions" (1990).
Index tetAround(const DelaunayComplex& complex, const Vec3& point)
{
  const auto isBeyond = [&](Facet facet)
  {
    const Triangle v = complex.facetVertices(facet);
    return orientation(complex.points[v[0]], complex.points[v[1]], complex.points[v[2]], point) > 0;
  };
  Index tet = std::isfinite(point.x + point.y + point.z) ? 0 : kNone;
  for (Index last = kNone; tet != kNone && tet != last;)
  {
    last = tet;
    for (Facet facet = 4 * last; facet < 4 * last + 4 && tet == last; ++facet)
    {
      tet = isBeyond(facet) ? complex.neighbour(last, static_cast<int>(facet % 4)) : tet;
    }
  }
  return tet;
}

/// The critical triangles that are kept in one state and no longer in a later one.
std::vector<Facet> criticalTrianglesLost(
  const WrapComplex& before, const WrapComplex& after, Execution& execution)
{
  const FlowComplex& flow = before.flow();
  return collect<Facet>(flow.delaunay().tetCount(), execution,
    [&](Index tet, auto& found)
    {
      if (before.isEqualAt(after, tet))
      {
        return;
      }
      for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
      {
        // of two tetrahedra that changed the one that names the triangle speaks for both
        const Facet name = flow.delaunay().canonical(facet);
        if ((name == facet || before.isEqualAt(after, name / 4)) && !after.keepsTriangle(name) &&
          before.keepsTriangle(name) && flow.isCriticalTriangle(name))
        {
          found.push_back(name);
        }
      }
    });
}

} // namespace

BlockName blockOfNumber(const Blocks& blocks, std::int64_t number)
{
  const FlowComplex& flow = blocks.flow();
  const std::int64_t facet = -1 - number;
  if (number >= 0 && number < blocks.outside() && blocks.isVolume(static_cast<Index>(number)))
  {
    return { .isSheet = false, .name = static_cast<Index>(number) };
  }
  if (number < 0 && facet < std::int64_t{ 4 } * flow.delaunay().tetCount() &&
    flow.isCriticalTriangle(static_cast<Facet>(facet)))
  {
    return { .isSheet = true, .name = flow.delaunay().canonical(static_cast<Facet>(facet)) };
  }
  throw Error(ErrorCode::badParameter, "there is no block " + std::to_string(number));
}

bool isKept(const WrapComplex& complex, const Blocks& blocks, const BlockName& block)
{
  return block.isSheet ? complex.keepsTriangle(block.name)
                       : blocks.isVolume(block.name) && complex.keepsTet(blocks.sink(block.name));
}

double sizeOf(const Blocks& blocks, const BlockName& block)
{
  const DelaunayComplex& complex = blocks.flow().delaunay();
  return block.isSheet ? circumradius(complex, block.name) : blocks.size(block.name);
}

Keeper keeperBehind(const WrapModel& model, const Blocks& blocks, Facet triangle)
{
  const WrapComplex& kept = *model.current;
  const DelaunayComplex& complex = kept.flow().delaunay();
  Holder top;
  if (kept.isSheet(triangle))
  {
    top.sheet = complex.canonical(triangle);
  }
  else
  {
    top.tet = kept.keptTetAt(triangle);
    const BlockName block{ .isSheet = false, .name = model.scan->basins().ofTet[top.tet] };
    if (model.isSolid || isKept(kept, blocks, block))
    {
      return { block, top.tet };
    }
  }
  for (Holder next = top; next.tet != kNone || next.sheet != kNone; next = holderOf(kept, top))
  {
    top = next;
  }
  if (top.tet == kNone)
  {
    return { .block = { .isSheet = true, .name = top.sheet } };
  }
  return { { .isSheet = false, .name = model.scan->basins().ofTet[top.tet] }, top.tet };
}

BlockName blockBehind(const WrapModel& model, const Blocks& blocks, Facet triangle)
{
  return keeperBehind(model, blocks, triangle).block;
}

BlockName removedBlockBefore(const WrapModel& model, const Blocks& blocks, Facet triangle)
{
  const DelaunayComplex& complex = model.scan->delaunay();
  BlockName before;
  for (const Facet side : { triangle, complex.mirror[triangle / 4][triangle % 4] })
  {
    if (side != kNone && !model.current->keepsTet(side / 4))
    {
      const BlockName block{ .isSheet = false, .name = blocks.ofTet(side / 4) };
      if (blocks.isVolume(block.name) && !isKept(*model.current, blocks, block) &&
        (before.name == kNone || sizeOf(blocks, block) > sizeOf(blocks, before)))
      {
        before = block;
      }
    }
  }
  return before;
}

BlockName removedBlockAt(const WrapModel& model, const Vec3& point, Execution& execution)
{
  const Blocks& blocks = model.scan->blocks(execution);
  const DelaunayComplex& complex = model.scan->delaunay();
  const Index around = tetAround(complex, point);
  if (around != kNone && blocks.isVolume(blocks.ofTet(around)) &&
    !model.current->keepsTet(blocks.sink(blocks.ofTet(around))))
  {
    return { .isSheet = false, .name = blocks.ofTet(around) };
  }
  const Facet nearest = nearestFacet(
    complex, criticalTrianglesLost(*model.start, *model.current, execution), point, execution);
  return { .isSheet = nearest != kNone, .name = nearest };
}

} // namespace scan
