// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cad_tessellation.h"

#include <BRepGProp.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Message_ProgressScope.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace scan
{
namespace
{

/// OpenCASCADE's meshes exceed its deflection, those of spheres twofold.
constexpr double kMargins[] = { 0.7, 0.4, 0.2 };

/// Six times the volume below the triangles from `first` on.
double signedVolume(const TriMesh& mesh, std::size_t first)
{
  double volume = 0.0;
  for (std::size_t i = first; i < mesh.triangles.size(); ++i)
  {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vec3& origin = mesh.points[mesh.triangles[first][0]];
    volume += dot(mesh.points[a] - origin, cross(mesh.points[b] - origin, mesh.points[c] - origin));
  }
  return volume;
}

/// The triangles of faces, put together along their edges.
class FaceJoiner
{
public:
  /// What follows shares no points with what was there.
  void startBody()
  {
    this->EdgeLines.Clear();
    this->Lines.clear();
    this->Vertices.Clear();
  }

  void addFaces(const TopoDS_Shape& shape)
  {
    for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
    {
      this->addFace(TopoDS::Face(at.Current()));
    }
  }

  /// Adds the faces of a shape that encloses a volume.
  void addClosed(const TopoDS_Shape& shape)
  {
    const std::size_t first = this->Mesh.triangles.size();
    this->addFaces(shape);
    if (signedVolume(this->Mesh, first) < 0.0)
    {
      for (std::size_t i = first; i < this->Mesh.triangles.size(); ++i)
      {
        std::swap(this->Mesh.triangles[i][1], this->Mesh.triangles[i][2]);
      }
    }
  }

  void addFace(const TopoDS_Face& face)
  {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) faceMesh = BRep_Tool::Triangulation(face, place);
    if (faceMesh.IsNull() || faceMesh->NbTriangles() == 0)
    {
      this->Missing.push_back(face);
      return;
    }
    const auto first = static_cast<Index>(this->Mesh.points.size());
    for (int i = 1; i <= faceMesh->NbNodes(); ++i)
    {
      const gp_Pnt point = faceMesh->Node(i).Transformed(place.Transformation());
      this->Mesh.points.push_back({ point.X(), point.Y(), point.Z() });
      this->Same.push_back(static_cast<Index>(this->Same.size()));
    }
    for (TopExp_Explorer at(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); at.More(); at.Next())
    {
      this->joinEdge(TopoDS::Edge(at.Current()), faceMesh, place, first);
    }
    const bool isMirrored = place.Transformation().IsNegative();
    const bool isTurned = (face.Orientation() == TopAbs_REVERSED) != isMirrored;
    for (int i = 1; i <= faceMesh->NbTriangles(); ++i)
    {
      int a = 0;
      int b = 0;
      int c = 0;
      faceMesh->Triangle(i).Get(a, b, c);
      const Index base = first - 1; // nodes count from 1
      this->Mesh.triangles.push_back({ base + static_cast<Index>(a),
        base + static_cast<Index>(isTurned ? c : b), base + static_cast<Index>(isTurned ? b : c) });
    }
  }

  const std::vector<TopoDS_Face>& missing() const { return this->Missing; }

  /// The mesh with one point for those that are the same, without triangles that have vanished.
  TriMesh take()
  {
    std::vector<Index> numbers(this->Mesh.points.size(), kNone);
    TriMesh joined;
    for (Triangle triangle : this->Mesh.triangles)
    {
      for (Index& corner : triangle)
      {
        corner = this->representative(corner);
      }
      if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      {
        continue;
      }
      for (Index& corner : triangle)
      {
        Index& number = numbers[corner];
        if (number == kNone)
        {
          number = static_cast<Index>(joined.points.size());
          joined.points.push_back(this->Mesh.points[corner]);
        }
        corner = number;
      }
      joined.triangles.push_back(triangle);
    }
    return joined;
  }

private:
  void joinEdge(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & faceMesh,
    const TopLoc_Location& place, Index first)
  {
    const Handle(Poly_PolygonOnTriangulation) polygon =
      BRep_Tool::PolygonOnTriangulation(edge, faceMesh, place);
    if (polygon.IsNull())
    {
      return;
    }
    std::vector<Index> line;
    for (int i = 1; i <= polygon->NbNodes(); ++i)
    {
      line.push_back(first + static_cast<Index>(polygon->Node(i)) - 1);
    }
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    this->joinVertex(TopExp::FirstVertex(forward), line.front());
    this->joinVertex(TopExp::LastVertex(forward), line.back());
    if (BRep_Tool::Degenerated(edge)) // a pole
    {
      for (const Index node : line)
      {
        this->join(line.front(), node);
      }
      return;
    }
    if (!this->EdgeLines.IsBound(edge))
    {
      this->EdgeLines.Bind(edge, static_cast<int>(this->Lines.size()));
      this->Lines.push_back(std::move(line));
      return;
    }
    const std::vector<Index>& other =
      this->Lines[static_cast<std::size_t>(this->EdgeLines.Find(edge))];
    for (std::size_t i = 0; i < line.size() && line.size() == other.size(); ++i)
    {
      this->join(other[i], line[i]);
    }
  }

  void joinVertex(const TopoDS_Vertex& vertex, Index node)
  {
    if (vertex.IsNull())
    {
      return;
    }
    if (!this->Vertices.IsBound(vertex))
    {
      this->Vertices.Bind(vertex, static_cast<int>(node));
    }
    this->join(static_cast<Index>(this->Vertices.Find(vertex)), node);
  }

  Index representative(Index node)
  {
    while (this->Same[node] != node)
    {
      this->Same[node] = this->Same[this->Same[node]];
      node = this->Same[node];
    }
    return node;
  }

  void join(Index a, Index b)
  {
    a = this->representative(a);
    b = this->representative(b);
    this->Same[std::max(a, b)] = std::min(a, b);
  }

  TriMesh Mesh;
  std::vector<Index> Same; // a union-find structure over the points
  std::vector<TopoDS_Face> Missing;
  TopTools_DataMapOfShapeInteger EdgeLines; // index into Lines
  std::vector<std::vector<Index>> Lines;    // the points along an edge
  TopTools_DataMapOfShapeInteger Vertices;
};

/// How far the surface is from the triangle, along its normal, in its centre and in the middle of
/// its longest edge.
double heightOver(
  const Poly_Triangulation& mesh, const Poly_Triangle& triangle, const GeomAdaptor_Surface& surface)
{
  std::array<gp_XYZ, 3> corners;
  std::array<gp_XY, 3> parameters;
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = mesh.Node(triangle.Value(static_cast<int>(i) + 1)).XYZ();
    parameters[i] = mesh.UVNode(triangle.Value(static_cast<int>(i) + 1)).XY();
  }
  gp_XYZ normal = (corners[1] - corners[0]).Crossed(corners[2] - corners[0]);
  if (normal.Modulus() < gp::Resolution())
  {
    return 0.0;
  }
  normal.Normalize();
  const auto height = [&](const gp_XY& at)
  { return std::abs((surface.Value(at.X(), at.Y()).XYZ() - corners[0]).Dot(normal)); };
  const auto length = [&](std::size_t i)
  { return (corners[i] - corners[(i + 1) % 3]).SquareModulus(); };
  const std::size_t longest =
    length(0) > length(1) ? (length(0) > length(2) ? 0 : 2) : (length(1) > length(2) ? 1 : 2);
  return std::max(height((parameters[0] + parameters[1] + parameters[2]) / 3.0),
    height((parameters[longest] + parameters[(longest + 1) % 3]) / 2.0));
}

/// Whether all triangles are within the deflection, as far as samples tell.
bool isWithin(double deflection, const TopoDS_Shape& shape)
{
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next())
  {
    TopLoc_Location place;
    const TopoDS_Face& face = TopoDS::Face(at.Current());
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
    const GeomAdaptor_Surface surface(BRep_Tool::Surface(face, place));
    if (mesh.IsNull() || !mesh->HasUVNodes() || surface.GetType() == GeomAbs_Plane)
    {
      continue;
    }
    for (int i = 1; i <= mesh->NbTriangles(); ++i)
    {
      if (heightOver(*mesh, mesh->Triangle(i), surface) > deflection)
      {
        return false;
      }
    }
  }
  return true;
}

void triangulate(
  const TopoDS_Shape& shape, double deflection, double angle, const Message_ProgressRange& progress)
{
  Message_ProgressScope scope(progress, "", 3);
  IMeshTools_Parameters parameters;
  parameters.Angle = angle;
  for (const double margin : kMargins)
  {
    BRepTools::Clean(shape);
    parameters.Deflection = margin * deflection;
    const BRepMesh_IncrementalMesh mesher(shape, parameters, scope.Next());
    if (isWithin(deflection, shape))
    {
      return;
    }
  }
}

void failOnMissingFaces(
  const std::vector<TopoDS_Face>& faces, double deflection, const Source& source)
{
  std::size_t count = 0;
  for (const TopoDS_Face& face : faces)
  {
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    count += std::abs(area.Mass()) > deflection * deflection ? 1 : 0;
  }
  if (count > 0)
  {
    source.fail(std::to_string(count) +
      " faces cannot become triangles; repair the model in the program that made it");
  }
}

} // namespace

TriMesh tessellate(const TopoDS_Shape& shape, double deflection, double angle, const Source& source,
  const Message_ProgressRange& progress)
{
  triangulate(shape, deflection, angle, progress);
  FaceJoiner joiner;
  for (TopExp_Explorer at(shape, TopAbs_SOLID); at.More(); at.Next())
  {
    joiner.startBody();
    joiner.addClosed(at.Current());
  }
  joiner.startBody();
  for (TopExp_Explorer at(shape, TopAbs_SHELL, TopAbs_SOLID); at.More(); at.Next())
  {
    if (BRep_Tool::IsClosed(at.Current()))
    {
      joiner.addClosed(at.Current());
    }
    else
    {
      joiner.addFaces(at.Current());
    }
  }
  for (TopExp_Explorer at(shape, TopAbs_FACE, TopAbs_SHELL); at.More(); at.Next())
  {
    joiner.addFace(TopoDS::Face(at.Current()));
  }
  failOnMissingFaces(joiner.missing(), deflection, source);
  return joiner.take();
}

} // namespace scan
