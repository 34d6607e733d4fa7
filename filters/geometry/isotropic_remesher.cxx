// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL asks for short edges where they are fixed, but copes with long ones
#define CGAL_NO_PRECONDITIONS 1

#include "filters/geometry/isotropic_remesher.h"

#include "filters/geometry/dihedral_angle.h"
#include "filters/geometry/local_plane.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scan
{
namespace
{

namespace processing = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Edge = Surface::Edge_index;
using HalfEdge = Surface::Halfedge_index;

constexpr double kLongest = 4.0 / 3.0; // times the edge length aimed at
constexpr double kCornerCosine = 0.7;  // a line of edges that turns by 45 degrees keeps the point

Vec3 vectorOf(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

} // namespace

struct IsotropicRemesher::State
{
  State(const Options& options, const TriangleTree& tree)
    : Wanted(options)
    , Tree(tree)
  {
  }

  void build(const TriMesh& mesh);
  void markFeatures();
  void markCorners();
  void splitFixedEdges(const std::vector<std::uint8_t>& maySplit, const TriMesh& mesh);
  Vec3 at(Vertex v) const { return vectorOf(this->Mesh.point(v)); }
  bool isLine(Edge e) const { return this->Mesh.is_border(e) || this->IsFeature[e]; }

  Options Wanted;
  const TriangleTree& Tree;
  Surface Mesh;
  Surface::Property_map<Vertex, Index> Origin;
  Surface::Property_map<Vertex, Index> Near; // a triangle of the tree
  Surface::Property_map<Vertex, bool> IsCorner;
  Surface::Property_map<Edge, bool> IsFeature;
};

void IsotropicRemesher::State::build(const TriMesh& mesh)
{
  this->Origin = this->Mesh.add_property_map<Vertex, Index>("v:origin", kNone).first;
  this->Near = this->Mesh.add_property_map<Vertex, Index>("v:near", kNone).first;
  this->IsCorner = this->Mesh.add_property_map<Vertex, bool>("v:corner", false).first;
  this->IsFeature = this->Mesh.add_property_map<Edge, bool>("e:feature", false).first;
  for (Index i = 0; i < mesh.points.size(); ++i)
  {
    const Vec3& p = mesh.points[i];
    this->Origin[this->Mesh.add_vertex({ p.x, p.y, p.z })] = i;
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    this->Mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  }
}

void IsotropicRemesher::State::markFeatures()
{
  const double limit = this->Wanted.featureAngle * std::numbers::pi / 180.0;
  for (const Edge e : this->Mesh.edges())
  {
    if (limit < std::numbers::pi && !this->Mesh.is_border(e))
    {
      const HalfEdge h = this->Mesh.halfedge(e);
      const Vec3 u = this->at(this->Mesh.source(h));
      const Vec3 v = this->at(this->Mesh.target(h));
      const Vec3 a = this->at(this->Mesh.target(this->Mesh.next(h)));
      const Vec3 b = this->at(this->Mesh.target(this->Mesh.next(this->Mesh.opposite(h))));
      this->IsFeature[e] = std::numbers::pi - dihedralAngle(u, v, a, b) > limit;
    }
  }
}

/// Points where lines of features and of the boundary end, meet or turn.
void IsotropicRemesher::State::markCorners()
{
  for (const Vertex v : this->Mesh.vertices())
  {
    std::vector<Vec3> along;
    if (!this->Mesh.is_isolated(v))
    {
      for (const HalfEdge h : CGAL::halfedges_around_target(v, this->Mesh))
      {
        if (this->isLine(this->Mesh.edge(h)))
        {
          along.push_back(unitVector(this->at(this->Mesh.source(h)) - this->at(v)));
        }
      }
    }
    this->IsCorner[v] =
      !along.empty() && (along.size() != 2 || dot(along[0], along[1]) > -kCornerCosine);
  }
}

/// Lines that CGAL must not touch as a whole are made short enough here, where that is allowed.
void IsotropicRemesher::State::splitFixedEdges(
  const std::vector<std::uint8_t>& maySplit, const TriMesh& mesh)
{
  std::vector<Edge> edges;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Vertex from(mesh.triangles[t][k]);
      const Vertex to(mesh.triangles[t][(k + 1) % 3]);
      const Edge e = this->Mesh.edge(this->Mesh.halfedge(from, to));
      if ((this->Mesh.is_border(e) && maySplit[3 * t + k] != 0) ||
        (this->IsFeature[e] && from < to))
      {
        edges.push_back(e);
      }
    }
  }
  processing::split_long_edges(edges, kLongest * this->Wanted.edgeLength, this->Mesh,
    CGAL::parameters::edge_is_constrained_map(this->IsFeature));
}

IsotropicRemesher::IsotropicRemesher(const TriMesh& mesh, const std::vector<std::uint8_t>& maySplit,
  const Options& options, const TriangleTree& surface)
  : S(std::make_unique<State>(options, surface))
{
  this->S->build(mesh);
  this->S->markFeatures();
  this->S->markCorners();
  if (options.isBoundaryFixed)
  {
    this->S->splitFixedEdges(maySplit, mesh);
  }
}

IsotropicRemesher::~IsotropicRemesher() = default;

void IsotropicRemesher::iterate()
{
  State& s = *this->S;
  const auto onSurface = [&s](Vertex v)
  {
    const SurfacePlace place = s.Tree.nearest(s.at(v), s.Near[v]);
    s.Near[v] = place.triangle;
    return Kernel::Point_3(place.point.x, place.point.y, place.point.z);
  };
  processing::isotropic_remeshing(s.Mesh.faces(), s.Wanted.edgeLength, s.Mesh,
    CGAL::parameters::number_of_iterations(1)
      .edge_is_constrained_map(s.IsFeature)
      .vertex_is_constrained_map(s.IsCorner)
      .protect_constraints(s.Wanted.isBoundaryFixed)
      .projection_functor(onSurface));
  s.Mesh.collect_garbage();
}

TriMesh IsotropicRemesher::mesh(std::vector<Index>& origins) const
{
  const Surface& from = this->S->Mesh;
  TriMesh mesh;
  origins.clear();
  for (const Vertex v : from.vertices())
  {
    mesh.points.push_back(this->S->at(v));
    origins.push_back(this->S->Origin[v]);
  }
  for (const auto f : from.faces())
  {
    const HalfEdge h = from.halfedge(f);
    mesh.triangles.push_back({ from.source(h), from.target(h), from.target(from.next(h)) });
  }
  return mesh;
}

} // namespace scan
