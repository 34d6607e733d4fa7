// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/model.h"

#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

/// The only place that converts between vtkPolyData and the arrays of the kernels.
namespace scan::bridge
{

/// The points of `data`, in their order, as doubles.
/// @throws Error{limit} for more points than Index can count
std::vector<Vec3> pointsOf(vtkPolyData& data);

/// Points and faces of `data`: polygons become fans, strips become triangles, vertices and lines
/// are left out. Polygons with fewer than three corners are skipped.
/// @throws Error{limit} as pointsOf; Error{badInput} when a face names a point that is not there
/// @param cells if given, what becomes the cell of each triangle
TriMesh meshOf(vtkPolyData& data, std::vector<vtkIdType>* cells = nullptr);

/// Whether meshOf() finds triangles: a surface, else points.
bool hasTriangles(vtkPolyData& data);

/// How many triangles meshOf() makes.
/// @throws Error as meshOf()
vtkIdType triangleCountOf(vtkPolyData& data);

/// The lines of `data` as segments.
/// @throws Error{badInput} when a line names a point that is not there
std::vector<Segment> segmentsOf(vtkPolyData& data);

/// Makes `output` the mesh: double points, triangles as polygons, segments as lines. Where there
/// are neither triangles nor segments every point gets a vertex, so that a scan can be seen.
void setMesh(vtkPolyData& output, const TriMesh& mesh, std::span<const Segment> lines = {});

/// Points and faces as meshOf(), lines as curves, with the colours, normals and unit that
/// setModel() would set.
/// @throws Error as meshOf(), also for lines
Model modelOf(vtkPolyData& data);

/// Makes `output` the model: double points, triangles as polygons, curves as lines, a vertex per
/// point of a scan, and the arrays of vtkScanArrayNames.h for what it knows.
void setModel(vtkPolyData& output, const Model& model);

/// Makes `output` the part of `input` on the points that are kept: these points in their order with
/// their data and scan-point ids, and the lines, polygons and strips that have no other points,
/// with their data. Where none of these are left every point gets a vertex.
/// @param isKept per point 0 or 1
/// @throws Error{badInput} when a cell names a point that is not there
void keepPoints(vtkPolyData& input, std::span<const std::uint8_t> isKept, vtkPolyData& output);

/// Makes `output` the part of `input` on the triangles of meshOf() that are kept: these triangles
/// with the data of their cells, the points that they use in their order, with their data and
/// scan-point ids, and the lines that have no other points.
/// @param isKept per triangle 0 or 1
/// @throws Error as meshOf(), also for lines
void keepTriangles(vtkPolyData& input, std::span<const std::uint8_t> isKept, vtkPolyData& output);

/// Makes `output` what `input` is, with its cells and data, in other places.
/// @param points as many as `input` has
void movePoints(vtkPolyData& input, const std::vector<Vec3>& points, vtkPolyData& output);

/// The normals of the points of `data`; none when it has none.
std::vector<Vec3> normalsOf(vtkPolyData& data);

/// Sets the normals of the points of `output`.
void setNormals(vtkPolyData& output, const std::vector<Vec3>& normals);

/// The unit of the coordinates of `data` in millimetres; 0 when it has none.
double unitOf(vtkDataObject& data);

/// Gives `data` a unit.
void setUnit(vtkDataObject& data, double millimetres);

/// Gives `output` what `input` says about itself and points do not tell, where `output` does not
/// say it: the unit, the files that it comes from and its regions.
void passOrigin(vtkDataObject& input, vtkDataObject& output);

/// The scan-point id of every point of `data`: its ScanPointId array, else 0, 1, 2, ...
std::vector<vtkIdType> scanPointIdsOf(vtkPolyData& data);

/// A file that a model comes from.
struct ScanFile
{
  std::string name;
  std::size_t points = 0; ///< of the model that come from it
};

/// The files that make `data`; none for a model that comes from a single one.
std::vector<ScanFile> scanFilesOf(vtkPolyData& data);

/// Per point the place among scanFilesOf() of the file that it comes from; kNone for points that
/// come from none.
std::vector<Index> scanFileOfPoints(vtkPolyData& data);

/// Sets the ScanPointId array of `output`.
void setScanPointIds(vtkPolyData& output, std::span<const vtkIdType> ids);

} // namespace scan::bridge
