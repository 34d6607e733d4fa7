// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_methods.h"

#include "filters/base/error.h"
#include "filters/geometry/spacing.h"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Scale_space_reconstruction_3/Advancing_front_mesher.h>
#include <CGAL/Scale_space_reconstruction_3/Jet_smoother.h>
#include <CGAL/Scale_space_surface_reconstruction_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_estimate_normals.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/poisson_surface_reconstruction.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace quality
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using OrientedPoint = std::pair<Point, Kernel::Vector_3>;
using PointMap = CGAL::First_of_pair_property_map<OrientedPoint>;
using NormalMap = CGAL::Second_of_pair_property_map<OrientedPoint>;
using ScaleSpace = CGAL::Scale_space_surface_reconstruction_3<Kernel>;

constexpr unsigned kNeighbours = 18;

std::vector<Point> cgalPoints(const Cloud& cloud)
{
  std::vector<Point> points;
  points.reserve(cloud.points.size());
  for (const scan::Vec3& p : cloud.points)
  {
    points.emplace_back(p.x, p.y, p.z);
  }
  return points;
}

/// The triangles that a method has chosen among the points.
template <class Facets>
scan::TriMesh trianglesOf(const Cloud& cloud, const Facets& begin, const Facets& end)
{
  scan::TriMesh mesh{ cloud.points, {} };
  for (Facets facet = begin; facet != end; ++facet)
  {
    mesh.triangles.push_back({ static_cast<scan::Index>((*facet)[0]),
      static_cast<scan::Index>((*facet)[1]), static_cast<scan::Index>((*facet)[2]) });
  }
  return mesh;
}

scan::TriMesh trianglesOf(const SurfaceMesh& surface)
{
  scan::TriMesh mesh;
  for (const auto vertex : surface.vertices()) // numbered without gaps: nothing was removed
  {
    const Point& p = surface.point(vertex);
    mesh.points.push_back({ p.x(), p.y(), p.z() });
  }
  for (const auto face : surface.faces())
  {
    scan::Triangle triangle{};
    std::size_t corner = 0;
    for (const auto vertex : vertices_around_face(surface.halfedge(face), surface))
    {
      triangle.at(corner++) = vertex;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

/// An alpha shape gives a triangle with nothing on either side twice, once from each side. One is
/// left.
scan::TriMesh withoutBacks(scan::TriMesh mesh)
{
  std::set<scan::Triangle> seen;
  std::erase_if(mesh.triangles,
    [&](scan::Triangle triangle)
    {
      std::sort(triangle.begin(), triangle.end());
      return !seen.insert(triangle).second;
    });
  return mesh;
}

std::vector<OrientedPoint> orientedPoints(const Cloud& cloud)
{
  std::vector<OrientedPoint> points;
  for (const Point& p : cgalPoints(cloud))
  {
    points.emplace_back(p, CGAL::NULL_VECTOR);
  }
  if (!cloud.normals.empty())
  {
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const scan::Vec3& n = cloud.normals[i];
      points[i].second = { n.x, n.y, n.z };
    }
    return points;
  }
  const auto maps = CGAL::parameters::point_map(PointMap()).normal_map(NormalMap());
  CGAL::jet_estimate_normals<CGAL::Sequential_tag>(points, kNeighbours, maps);
  points.erase(CGAL::mst_orient_normals(points, kNeighbours, maps), points.end());
  return points;
}

scan::TriMesh alphaWrap(const Cloud& cloud, double alpha, double offset)
{
  SurfaceMesh surface;
  CGAL::alpha_wrap_3(cgalPoints(cloud), alpha, offset, surface);
  return trianglesOf(surface);
}

} // namespace

scan::TriMesh advancingFront(const Cloud& cloud)
{
  const std::vector<Point> points = cgalPoints(cloud);
  std::vector<std::array<std::size_t, 3>> facets;
  CGAL::advancing_front_surface_reconstruction(
    points.begin(), points.end(), std::back_inserter(facets));
  return trianglesOf(cloud, facets.begin(), facets.end());
}

scan::TriMesh scaleSpace(const Cloud& cloud)
{
  const std::vector<Point> points = cgalPoints(cloud);
  ScaleSpace reconstruction(points.begin(), points.end());
  reconstruction.increase_scale(4);
  reconstruction.reconstruct_surface();
  return withoutBacks(
    trianglesOf(cloud, reconstruction.facets_begin(), reconstruction.facets_end()));
}

scan::TriMesh scaleSpaceFront(const Cloud& cloud)
{
  namespace steps = CGAL::Scale_space_reconstruction_3;
  const std::vector<Point> points = cgalPoints(cloud);
  ScaleSpace reconstruction(points.begin(), points.end());
  reconstruction.increase_scale<steps::Jet_smoother<Kernel>>(4);
  reconstruction.reconstruct_surface(steps::Advancing_front_mesher<Kernel>());
  return trianglesOf(cloud, reconstruction.facets_begin(), reconstruction.facets_end());
}

scan::TriMesh poisson(const Cloud& cloud)
{
  std::vector<OrientedPoint> points = orientedPoints(cloud);
  const double spacing = CGAL::compute_average_spacing<CGAL::Sequential_tag>(
    points, 6, CGAL::parameters::point_map(PointMap()));
  SurfaceMesh surface;
  if (!CGAL::poisson_surface_reconstruction_delaunay(
        points.begin(), points.end(), PointMap(), NormalMap(), surface, spacing))
  {
    throw scan::Error(scan::ErrorCode::badInput, "no Poisson surface");
  }
  return trianglesOf(surface);
}

scan::TriMesh fineAlphaWrap(const Cloud& cloud)
{
  const double spacing = scan::meanSpacing(cloud.points);
  return alphaWrap(cloud, 3.0 * spacing, 0.5 * spacing);
}

scan::TriMesh coarseAlphaWrap(const Cloud& cloud)
{
  const std::vector<Point> points = cgalPoints(cloud);
  const Kernel::Iso_cuboid_3 box = CGAL::bounding_box(points.begin(), points.end());
  const double diagonal = std::sqrt(CGAL::squared_distance((box.min)(), (box.max)()));
  return alphaWrap(cloud, diagonal / 10.0, diagonal / 300.0);
}

} // namespace quality
