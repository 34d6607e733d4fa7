// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/iges.h"

#include "filters/base/error.h"
#include "filters/base/unit.h"
#include "filters/geometry/bounding_box.h"
#include "writers/iges_file.h"
#include "writers/iges_polyline.h"
#include "writers/iges_solid.h"
#include "writers/requirements.h"
#include "writers/triangle_plane.h"
#include "writers/used_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace scan
{
namespace
{

/// A length that IGES has a flag and a name for.
struct NamedUnit
{
  double millimetres;
  std::uint64_t flag;
  std::string_view name;
};

constexpr std::array<NamedUnit, 10> kUnits = { { { 1.0, 2, "MM" }, { 10.0, 10, "CM" },
  { 1000.0, 6, "M" }, { 25.4, 1, "INCH" }, { 304.8, 4, "FT" }, { 1609344.0, 5, "MI" },
  { 1e6, 7, "KM" }, { 0.0254, 8, "MIL" }, { 1e-3, 9, "UM" }, { 25.4e-6, 11, "UIN" } } };

/// None for a unit that IGES does not know.
const NamedUnit* unitOf(const Model& model)
{
  const double millimetres = model.millimetresPerUnit == 0.0 ? 1.0 : model.millimetresPerUnit;
  const auto* const found = std::ranges::find_if(
    kUnits, [&](const NamedUnit& named) { return isSameUnit(millimetres, named.millimetres); });
  return found != kUnits.end() ? found : nullptr;
}

Model inMillimetres(Model model)
{
  for (Vec3& point : model.points)
  {
    point = point * model.millimetresPerUnit;
  }
  model.millimetresPerUnit = 1.0;
  return model;
}

bool isFinite(const Vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

void requireWritable(const Model& model, const OutputFile& file)
{
  requirePoints(model, file);
  const auto bad = std::ranges::find_if_not(model.points, isFinite);
  if (bad != model.points.end())
  {
    throw Error(ErrorCode::badInput,
      file.name() + ": point " + std::to_string(bad - model.points.begin()) +
        " has a coordinate that is not finite; remove it");
  }
}

std::string_view describe(IgesEntities entities)
{
  switch (entities)
  {
    case IgesEntities::faces:
      return "Triangles by Scanwrap: a bounded plane each (108 form 1)";
    case IgesEntities::solid:
      return "Solids by Scanwrap, bounded by triangles (186)";
    case IgesEntities::nurbs:
      return "Triangles by Scanwrap: a bilinear surface each (128)";
    case IgesEntities::wireframe:
      return "Triangles by Scanwrap: a closed polyline each (106 form 12)";
    case IgesEntities::points:
      break;
  }
  return "Points by Scanwrap (116)";
}

/// The largest coordinate, as an absolute value.
double largest(const BoundingBox& box)
{
  double most = 0.0;
  for (const Vec3& end : { box.low, box.high })
  {
    most = std::max({ most, std::abs(end.x), std::abs(end.y), std::abs(end.z) });
  }
  return most;
}

double resolutionIn(const BoundingBox& box)
{
  // finer than the triangles, coarser than the rounding of planes
  const double resolution = 1e-8 * box.diagonal() + 1e-14 * largest(box);
  return resolution > 0.0 ? resolution : 1e-8;
}

IgesHeader headerOf(const Model& model, IgesEntities entities)
{
  const NamedUnit& unit = *unitOf(model);
  const BoundingBox box(entities == IgesEntities::points ? model.points : shapePoints(model));
  return { .description = describe(entities),
    .unitFlag = unit.flag,
    .unitName = unit.name,
    .resolution = resolutionIn(box),
    .largest = largest(box) };
}

void putPoints(const TriMesh& mesh, IgesSink& sink)
{
  for (const Vec3& point : mesh.points)
  {
    sink.begin({ .type = 116 });
    sink.point(point).integer(0); // no symbol
    sink.end();
  }
}

std::uint64_t putBorder(
  const TriMesh& mesh, const Triangle& triangle, std::string_view status, IgesSink& sink)
{
  const auto& [a, b, c] = triangle;
  return putIgesPolyline(mesh, std::array{ a, b, c, a }, status, sink);
}

void putWireframe(const TriMesh& mesh, IgesSink& sink)
{
  for (const Triangle& triangle : mesh.triangles)
  {
    putBorder(mesh, triangle, IgesKind{}.status, sink);
  }
}

void putFaces(const TriMesh& mesh, IgesSink& sink, const OutputFile& file)
{
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto plane = planeOf(mesh.points[a], mesh.points[b], mesh.points[c]);
    if (!plane)
    {
      throw Error(ErrorCode::badInput,
        file.name() + ": triangle " + std::to_string(t) +
          " has no area, so no plane; remove it or write nurbs or wireframe");
    }
    const std::uint64_t border = putBorder(mesh, mesh.triangles[t], kIgesPart, sink);
    sink.begin({ .type = 108, .form = 1 });
    sink.point(plane->normal).real(plane->offset).integer(border);
    sink.point({}).real(0.0); // no symbol
    sink.end();
  }
}

void putNurbs(const TriMesh& mesh, IgesSink& sink)
{
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sink.begin({ .type = 128 });
    sink.integer(1).integer(1).integer(1).integer(1); // last control points, degrees
    // open both ways, polynomial, not periodic
    sink.integer(0).integer(0).integer(1).integer(0).integer(0);
    for (const double knot : { 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0 })
    {
      sink.real(knot);
    }
    for (int weight = 0; weight < 4; ++weight)
    {
      sink.real(1.0);
    }
    for (const Index corner : { a, b, c, c })
    {
      sink.point(mesh.points[corner]);
    }
    sink.real(0.0).real(1.0).real(0.0).real(1.0);
    sink.end();
  }
}

void putTriangles(
  const TriMesh& mesh, IgesEntities entities, IgesSink& sink, const OutputFile& file)
{
  switch (entities)
  {
    case IgesEntities::faces:
      putFaces(mesh, sink, file);
      break;
    case IgesEntities::nurbs:
      putNurbs(mesh, sink);
      break;
    default:
      putWireframe(mesh, sink);
  }
}

} // namespace

void writeIges(
  const Model& model, const IgesOptions& options, OutputFile& file, Execution& execution)
{
  requireWritable(model, file);
  if (unitOf(model) == nullptr)
  {
    writeIges(inMillimetres(model), options, file, execution);
    return;
  }
  const IgesEntities entities = model.isScan() ? IgesEntities::points : options.entities;
  const IgesHeader header = headerOf(model, entities);
  if (entities == IgesEntities::points)
  {
    const auto put = [&](IgesSink& sink) { putPoints(model, sink); };
    writeIgesFile(header, model.points.size(), put, file, execution);
  }
  else if (entities == IgesEntities::solid)
  {
    writeIgesSolid(model, header, file, execution);
  }
  else
  {
    const std::uint64_t each = entities == IgesEntities::faces ? 2 : 1;
    const auto put = [&](IgesSink& sink)
    {
      putTriangles(model, entities, sink, file);
      putIgesCurves(model, sink);
    };
    writeIgesFile(
      header, each * model.triangles.size() + model.curves.size(), put, file, execution);
  }
}

double igesResolution(const Model& model)
{
  return resolutionIn(BoundingBox(shapePoints(model)));
}

} // namespace scan
