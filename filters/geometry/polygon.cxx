// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/polygon.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace scan
{
namespace
{

enum class Side
{
  unknown,
  inside,
  outside
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel,
  CGAL::Triangulation_face_base_with_info_2<Side, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;

using Corners = std::span<const Index>;
using Points = std::span<const Vec3>;

void appendFan(std::vector<Triangle>& triangles, Corners corners)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    triangles.push_back({ corners[0], corners[i - 1], corners[i] });
  }
}

Vec3 fanNormal(Points points, Corners corners, std::size_t i)
{
  const Vec3& first = points[corners[0]];
  return cross(points[corners[i - 1]] - first, points[corners[i]] - first);
}

/// Twice the area vector of the polygon.
Vec3 areaOf(Points points, Corners corners)
{
  Vec3 area;
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    area = area + fanNormal(points, corners, i);
  }
  return area;
}

bool isFan(Points points, Corners corners, const Vec3& area)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    if (dot(fanNormal(points, corners, i), area) <= 0.0)
    {
      return false;
    }
  }
  return true;
}

/// The point without the coordinate in which the area is largest, counter-clockwise.
Kernel::Point_2 flattened(const Vec3& p, const Vec3& area)
{
  const double x = std::abs(area.x);
  const double y = std::abs(area.y);
  const double z = std::abs(area.z);
  const auto turned = [](double u, double v, bool isPositive)
  { return isPositive ? Kernel::Point_2(u, v) : Kernel::Point_2(v, u); };
  return x >= y && x >= z ? turned(p.y, p.z, area.x > 0.0)
    : y >= z              ? turned(p.z, p.x, area.y > 0.0)
                          : turned(p.x, p.y, area.z > 0.0);
}

/// The order of points in which each is near the one before.
std::vector<std::size_t> spatialOrder(const std::vector<Kernel::Point_2>& points)
{
  using Map = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_2<Kernel, Map>(CGAL::make_property_map(points)));
  return order;
}

/// The triangulation of a polygon and which of its triangles are inside.
class Filling
{
public:
  /// Throws Triangulation::Intersection_of_constraints_exception when edges cross.
  Filling(Points points, Corners corners, const Vec3& area)
    : Border(corners)
  {
    this->insertCorners(points, area);
    if (this->IsFlat && this->Cdt.dimension() == 2)
    {
      this->insertBorder();
      this->markSides();
      this->IsFilled = true;
    }
  }

  void append(std::vector<Triangle>& triangles) const
  {
    for (const Face face : this->Cdt.finite_face_handles())
    {
      if (this->IsFilled && face->info() == Side::inside)
      {
        triangles.push_back(
          { this->cornerOf(face, 0), this->cornerOf(face, 1), this->cornerOf(face, 2) });
      }
    }
  }

private:
  using Edge = Triangulation::Edge;
  using Face = Triangulation::Face_handle;
  using Vertex = Triangulation::Vertex_handle;

  Index cornerOf(Face face, int i) const { return this->Border[face->vertex(i)->info()]; }

  /// Corners at the same place become one vertex, that of the first of them in spatial order.
  void insertCorners(Points points, const Vec3& area)
  {
    std::vector<Kernel::Point_2> places;
    for (const Index corner : this->Border)
    {
      places.push_back(flattened(points[corner], area));
    }
    this->Vertices.resize(places.size());
    Face near;
    for (const std::size_t i : spatialOrder(places))
    {
      const std::size_t known = this->Cdt.number_of_vertices();
      const Vertex vertex = this->Cdt.insert(places[i], near);
      if (this->Cdt.number_of_vertices() > known)
      {
        vertex->info() = static_cast<Index>(i);
      }
      else if (points[this->Border[vertex->info()]] != points[this->Border[i]])
      {
        this->IsFlat = false; // one above the other
      }
      near = vertex->face();
      this->Vertices[i] = vertex;
    }
  }

  void insertBorder()
  {
    const auto forEachEdge = [&](const auto& visit)
    {
      for (std::size_t i = 0; i < this->Vertices.size(); ++i)
      {
        const Vertex next = this->Vertices[(i + 1) % this->Vertices.size()];
        if (this->Vertices[i] != next)
        {
          visit(this->Vertices[i], next);
        }
      }
    };
    forEachEdge([&](Vertex from, Vertex to) { this->Cdt.insert_constraint(from, to); });
    forEachEdge(
      [&](Vertex from, Vertex to)
      {
        // other corners may lie on an edge of the border and divide it
        Face face;
        int i = 0;
        for (Vertex next; from != to && this->Cdt.includes_edge(from, to, next, face, i);
             from = next)
        {
          ++this->Walks[std::minmax(from->info(), next->info())];
        }
      });
  }

  /// From the infinite face inwards; each border is a change of sides.
  void markSides()
  {
    for (const Face face : this->Cdt.all_face_handles())
    {
      face->info() = Side::unknown;
    }
    std::vector<Face> open = { this->Cdt.infinite_face() };
    open.back()->info() = Side::outside;
    while (!open.empty())
    {
      const Face face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i)
      {
        const Face next = face->neighbor(i);
        if (next->info() == Side::unknown)
        {
          const bool isInside = (face->info() == Side::inside) != this->isBorder({ face, i });
          next->info() = isInside ? Side::inside : Side::outside;
          open.push_back(next);
        }
      }
    }
  }

  /// An edge that is walked both ways leads to a hole and back.
  bool isBorder(const Edge& edge) const
  {
    if (!this->Cdt.is_constrained(edge))
    {
      return false;
    }
    const Index a = edge.first->vertex(Triangulation::cw(edge.second))->info();
    const Index b = edge.first->vertex(Triangulation::ccw(edge.second))->info();
    const auto walks = this->Walks.find(std::minmax(a, b));
    return walks == this->Walks.end() || walks->second % 2 == 1;
  }

  Corners Border;
  Triangulation Cdt;
  bool IsFilled = false;
  bool IsFlat = true;                           // no corner lies above another
  std::vector<Vertex> Vertices;                 // of the corners; their info is a place in Border
  std::map<std::pair<Index, Index>, int> Walks; // how often the border takes an edge
};

} // namespace

void appendPolygon(
  std::vector<Triangle>& triangles, std::span<const Vec3> points, std::span<const Index> corners)
{
  const bool isKnown =
    std::ranges::all_of(corners, [&](Index corner) { return corner < points.size(); });
  const Vec3 area = isKnown && corners.size() > 3 ? areaOf(points, corners) : Vec3{};
  const double size = std::hypot(area.x, area.y, area.z);
  const bool hasArea = size > 0.0 && std::isfinite(size);
  const std::size_t before = triangles.size();
  if (hasArea && !isFan(points, corners, area))
  {
    try
    {
      Filling(points, corners, area).append(triangles);
    }
    catch (const Triangulation::Intersection_of_constraints_exception&)
    {
      triangles.resize(before);
    }
  }
  if (triangles.size() == before)
  {
    appendFan(triangles, corners);
  }
}

void appendPolygons(
  std::vector<Triangle>& triangles, std::span<const Vec3> points, const Polylines& polygons)
{
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    appendPolygon(triangles, points, polygons[i]);
  }
}

void appendStrip(std::vector<Triangle>& triangles, std::span<const Index> corners)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
  {
    const std::size_t turn = i % 2;
    triangles.push_back({ corners[i - 2 + turn], corners[i - 1 - turn], corners[i] });
  }
}

} // namespace scan
