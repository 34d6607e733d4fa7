// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shell_union.h"

#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/intersecting.h"
#include "filters/geometry/shells.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

using Place = std::array<double, 3>;

/// From which triangles faces come, while CGAL cuts and copies them.
struct Origins
{
  std::map<const Mesh*, std::map<Mesh::Face_index, Index>> of;
  Index cut = kNone; ///< the origin of the face that is being cut
};

struct OriginVisitor : pmp::Corefinement::Default_visitor<Mesh>
{
  explicit OriginVisitor(Origins& origins)
    : All(&origins)
  {
  }

  void before_subface_creations(Mesh::Face_index face, Mesh& mesh)
  {
    this->All->cut = this->All->of[&mesh].at(face);
  }
  void after_subface_created(Mesh::Face_index face, Mesh& mesh)
  {
    this->All->of[&mesh][face] = this->All->cut;
  }
  void after_face_copy(
    Mesh::Face_index from, const Mesh& old, Mesh::Face_index face, const Mesh& mesh)
  {
    this->All->of[&mesh][face] = this->All->of[&old].at(from);
  }

  Origins* All;
};

/// A closed piece for CGAL.
struct Body
{
  Mesh mesh;
  std::vector<Index> originOf; // per face: the triangle of the surface
};

Body bodyOf(const TriMesh& mesh, const std::vector<Index>& triangles)
{
  Body body;
  std::map<Index, Mesh::Vertex_index> vertex;
  for (const Index t : triangles)
  {
    std::array<Mesh::Vertex_index, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index point = mesh.triangles[t][k];
      const auto found = vertex.find(point);
      if (found == vertex.end())
      {
        const Vec3& p = mesh.points[point];
        corners.at(k) = body.mesh.add_vertex(Kernel::Point_3(p.x, p.y, p.z));
        vertex.emplace(point, corners.at(k));
      }
      else
      {
        corners.at(k) = found->second;
      }
    }
    body.mesh.add_face(corners[0], corners[1], corners[2]);
    body.originOf.push_back(t);
  }
  return body;
}

/// The union of two bodies, none when CGAL finds no manifold.
std::optional<Body> unionOf(Body a, Body b)
{
  Origins origins;
  for (Body* const body : { &a, &b })
  {
    auto& of = origins.of[&body->mesh];
    for (const Mesh::Face_index face : body->mesh.faces())
    {
      of[face] = body->originOf.at(face);
    }
  }
  Body result;
  try
  {
    const bool isManifold = pmp::corefine_and_compute_union(a.mesh, b.mesh, result.mesh,
      CGAL::parameters::visitor(OriginVisitor(origins)).throw_on_self_intersection(true));
    if (!isManifold || result.mesh.number_of_faces() == 0)
    {
      return std::nullopt;
    }
  }
  catch (const std::exception&) // pieces that intersect themselves after all
  {
    return std::nullopt;
  }
  Body tidy;
  std::map<Mesh::Vertex_index, Mesh::Vertex_index> vertex;
  for (const Mesh::Face_index face : result.mesh.faces())
  {
    std::vector<Mesh::Vertex_index> corners;
    for (const Mesh::Vertex_index v :
      CGAL::vertices_around_face(result.mesh.halfedge(face), result.mesh))
    {
      const auto [at, isNew] = vertex.emplace(v, Mesh::Vertex_index());
      if (isNew)
      {
        at->second = tidy.mesh.add_vertex(result.mesh.point(v));
      }
      corners.push_back(at->second);
    }
    tidy.mesh.add_face(corners);
    tidy.originOf.push_back(origins.of[&result.mesh].at(face));
  }
  return tidy;
}

/// Whether a corner of one triangle is in the plane of the other: CGAL's corefinement may fail, or
/// not end, where bodies touch in faces.
bool isTouch(const TriMesh& mesh, Index s, Index t)
{
  const auto at = [&](Index point)
  {
    const Vec3& p = mesh.points[point];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const auto touches = [&](const Triangle& plane, const Triangle& other)
  {
    return std::ranges::any_of(other,
      [&](Index point)
      { return CGAL::coplanar(at(plane[0]), at(plane[1]), at(plane[2]), at(point)); });
  };
  return touches(mesh.triangles[s], mesh.triangles[t]) ||
    touches(mesh.triangles[t], mesh.triangles[s]);
}

/// Whether rounded places make a union intersect itself. CGAL must not be given such.
bool isClean(const Body& body, Execution& execution)
{
  TriMesh mesh;
  for (const Mesh::Vertex_index v : body.mesh.vertices())
  {
    const auto& p = body.mesh.point(v);
    mesh.points.push_back({ p.x(), p.y(), p.z() });
  }
  for (const Mesh::Face_index face : body.mesh.faces())
  {
    std::vector<Index> corners;
    for (const Mesh::Vertex_index v :
      CGAL::vertices_around_face(body.mesh.halfedge(face), body.mesh))
    {
      corners.push_back(v);
    }
    const Triangle t{ corners[0], corners[1], corners[2] };
    if (isFlat(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]))
    {
      return false;
    }
    mesh.triangles.push_back(t);
  }
  return selfIntersections(mesh, execution).empty();
}

class Uniter
{
public:
  Uniter(MendSurface& surface, Execution& execution)
    : Surface(surface)
    , Run(execution)
    , Mate(pairEdges(surface.mesh, execution).mate)
    , Pieces(findShells(surface.mesh, this->Mate))
  {
  }

  ShellUnions run();

private:
  std::vector<std::vector<Index>> groups();
  std::vector<Index> trianglesIn(Index shell) const;
  void replace(const std::vector<Index>& shells, const Body& body, ShellUnions& result);

  MendSurface& Surface;
  Execution& Run;
  std::vector<Index> Mate;
  Shells Pieces;
  std::set<std::pair<Index, Index>> Touches; // shells with faces or points on each other
  std::vector<std::uint8_t> IsGone;
  std::vector<std::pair<Triangle, Index>> New;
};

/// Shells that hang together by intersections, in an order in which each meets an earlier one.
std::vector<std::vector<Index>> Uniter::groups()
{
  std::set<Index> unfit;
  std::map<Index, std::set<Index>> meets;
  for (const auto& [a, b] : activeIntersections(this->Surface, this->Run))
  {
    const Index from = this->Pieces.shellOf[a];
    const Index to = this->Pieces.shellOf[b];
    if (from == to)
    {
      unfit.insert(from);
      continue;
    }
    meets[from].insert(to);
    meets[to].insert(from);
    if (isTouch(this->Surface.mesh, a, b))
    {
      this->Touches.insert(std::minmax({ from, to }));
    }
  }
  const auto isFit = [&](Index shell)
  { return this->Pieces.shells[shell].volume > 0.0 && !unfit.contains(shell); };
  std::vector<std::vector<Index>> groups;
  std::set<Index> seen;
  for (const auto& [first, others] : meets)
  {
    if (!isFit(first) || !seen.insert(first).second)
    {
      continue;
    }
    std::vector<Index> group{ first };
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      for (const Index other : meets.at(group[i]))
      {
        if (isFit(other) && seen.insert(other).second)
        {
          group.push_back(other);
        }
      }
    }
    if (group.size() > 1)
    {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::vector<Index> Uniter::trianglesIn(Index shell) const
{
  std::vector<Index> triangles;
  for (Index t = 0; t < this->Pieces.shellOf.size(); ++t)
  {
    if (this->Pieces.shellOf[t] == shell)
    {
      triangles.push_back(t);
    }
  }
  return triangles;
}

/// Puts the body in the place of shells. Triangles that it has as they were stay.
void Uniter::replace(const std::vector<Index>& shells, const Body& body, ShellUnions& result)
{
  const TriMesh before = this->Surface.mesh;
  std::map<Place, Index> known;
  std::vector<Index> old;
  for (const Index shell : shells)
  {
    for (const Index t : this->trianglesIn(shell))
    {
      old.push_back(t);
      for (const Index point : before.triangles[t])
      {
        const Vec3& p = before.points[point];
        known.emplace(Place{ p.x, p.y, p.z }, point);
      }
    }
  }
  std::set<Index> kept;
  for (const Mesh::Face_index face : body.mesh.faces())
  {
    const Index origin = body.originOf.at(face);
    Triangle corners{};
    std::size_t k = 0;
    for (const Mesh::Vertex_index v :
      CGAL::vertices_around_face(body.mesh.halfedge(face), body.mesh))
    {
      const auto& p = body.mesh.point(v);
      const auto [at, isNew] = known.emplace(
        Place{ p.x(), p.y(), p.z() }, static_cast<Index>(this->Surface.mesh.points.size()));
      if (isNew)
      {
        const Vec3 place{ p.x(), p.y(), p.z() };
        const Index input = this->Surface.triangleOrigin[origin];
        this->Surface.addPoint(
          place, input == kNone ? PointBlend{} : this->Surface.blendIn(input, place));
      }
      corners.at(k++) = at->second;
    }
    Triangle sorted = corners;
    std::ranges::sort(sorted);
    Triangle same = before.triangles[origin];
    std::ranges::sort(same);
    if (sorted == same)
    {
      kept.insert(origin);
    }
    else
    {
      this->New.emplace_back(corners, origin);
      ++result.exchange.added;
    }
  }
  for (const Index t : old)
  {
    if (!kept.contains(t))
    {
      this->IsGone[t] = 1;
      ++result.exchange.removed;
    }
  }
}

ShellUnions Uniter::run()
{
  ShellUnions result;
  this->IsGone.assign(this->Surface.mesh.triangles.size(), 0);
  for (const std::vector<Index>& group : this->groups())
  {
    Body body = bodyOf(this->Surface.mesh, this->trianglesIn(group.front()));
    std::vector<Index> joined{ group.front() };
    for (std::size_t i = 1; i < group.size(); ++i)
    {
      this->Run.step("", 0, 1); // for a cancel
      if (std::ranges::any_of(joined,
            [&](Index other) {
              return this->Touches.contains(std::minmax({ other, group[i] }));
            }))
      {
        continue;
      }
      auto next = unionOf(body, bodyOf(this->Surface.mesh, this->trianglesIn(group[i])));
      if (next)
      {
        body = std::move(*next);
        joined.push_back(group[i]);
        if (!isClean(body, this->Run))
        {
          break; // repaired first, and joined to the others in the next round
        }
      }
    }
    if (joined.size() > 1)
    {
      result.unions += joined.size() - 1;
      this->replace(joined, body, result);
    }
  }
  if (result.unions > 0)
  {
    std::vector<Index> origins;
    for (const auto& [corners, origin] : this->New)
    {
      origins.push_back(this->Surface.triangleOrigin[origin]);
    }
    this->Surface.removeTriangles(this->IsGone);
    for (std::size_t i = 0; i < this->New.size(); ++i)
    {
      this->Surface.addTriangle(this->New[i].first, origins[i]);
    }
  }
  return result;
}

} // namespace

ShellUnions uniteShells(MendSurface& surface, Execution& execution)
{
  return Uniter(surface, execution).run();
}

} // namespace scan
