// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/iges_solid.h"

#include "filters/base/error.h"
#include "filters/geometry/half_edges.h"
#include "writers/iges_polyline.h"
#include "writers/solid_bodies.h"
#include "writers/triangle_plane.h"

#include <string>
#include <string_view>
#include <vector>

namespace scan
{
namespace
{

constexpr std::string_view kDefinition = "00010200"; // a part that is no geometry
constexpr std::uint64_t kEntitiesPerFace = 6;
constexpr std::uint64_t kEntitiesPerShell = 3;

std::uint64_t entityCount(const std::vector<SolidBody>& bodies)
{
  const auto ofShell = [](const ClosedShell& shell)
  {
    const std::uint64_t faces = shell.mesh.triangles.size();
    return kEntitiesPerFace * faces + faces * 3 / 2 + kEntitiesPerShell;
  };
  std::uint64_t count = bodies.size();
  for (const SolidBody& body : bodies)
  {
    count += ofShell(body.outer);
    for (const ClosedShell& hollow : body.voids)
    {
      count += ofShell(hollow);
    }
  }
  return count;
}

/// Puts the entities of one shell.
class ShellSink
{
public:
  ShellSink(const ClosedShell& shell, const std::string& name, IgesSink& sink)
    : Shell(shell)
    , Mesh(shell.mesh)
    , Name(name)
    , Sink(sink)
  {
  }

  /// The number of the shell.
  std::uint64_t put()
  {
    this->putPoints();
    this->putEdges();
    std::vector<std::uint64_t> faces;
    for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      faces.push_back(this->putFace(t));
    }
    this->Sink.begin({ .type = 514, .form = 1, .status = kIgesPart });
    this->Sink.integer(faces.size());
    for (const std::uint64_t face : faces)
    {
      this->Sink.integer(face).integer(1); // 1: faces away from the material
    }
    return this->Sink.end();
  }

private:
  /// An edge runs like the smaller of its two half-edges.
  bool leads(Index half) const { return half < this->Shell.mate[half]; }

  void putPoints()
  {
    this->Sink.begin({ .type = 502, .form = 1, .status = kIgesPart });
    this->Sink.integer(this->Mesh.points.size());
    for (const Vec3& point : this->Mesh.points)
    {
      this->Sink.point(point);
    }
    this->Points = this->Sink.end();
  }

  void putEdges()
  {
    const auto halves = static_cast<Index>(this->Shell.mate.size());
    std::vector<std::uint64_t> lines;
    this->EdgeOf.resize(halves);
    for (Index half = 0; half < halves; ++half)
    {
      if (this->leads(half))
      {
        this->Sink.begin({ .type = 110, .status = kIgesPart });
        this->Sink.point(this->Mesh.points[originOf(this->Mesh, half)]);
        this->Sink.point(this->Mesh.points[originOf(this->Mesh, nextHalf(half))]);
        lines.push_back(this->Sink.end());
        this->EdgeOf[half] = lines.size(); // counted from 1
        this->EdgeOf[this->Shell.mate[half]] = lines.size();
      }
    }
    this->Sink.begin({ .type = 504, .form = 1, .status = kIgesPart });
    this->Sink.integer(lines.size());
    for (Index half = 0; half < halves; ++half)
    {
      if (this->leads(half))
      {
        this->Sink.integer(lines[this->EdgeOf[half] - 1]);
        for (const Index end : { half, nextHalf(half) })
        {
          const std::uint64_t number = originOf(this->Mesh, end) + std::uint64_t{ 1 };
          this->Sink.integer(this->Points).integer(number);
        }
      }
    }
    this->Edges = this->Sink.end();
  }

  std::uint64_t putFace(Index t)
  {
    const std::uint64_t plane = this->putPlane(this->Mesh.triangles[t]);
    this->Sink.begin({ .type = 508, .form = 1, .status = kIgesPart });
    this->Sink.integer(3);
    for (Index half = 3 * t; half < 3 * t + 3; ++half)
    {
      this->Sink.integer(0).integer(this->Edges).integer(this->EdgeOf[half]); // 0: an edge
      this->Sink.integer(this->leads(half) ? 1 : 0).integer(0); // no curves on the surface
    }
    const std::uint64_t loop = this->Sink.end();
    this->Sink.begin({ .type = 510, .form = 1, .status = kIgesPart });
    this->Sink.integer(plane).integer(1).integer(1).integer(loop); // one loop, the outer one
    return this->Sink.end();
  }

  std::uint64_t putPlane(const Triangle& triangle)
  {
    const Vec3& corner = this->Mesh.points[triangle[0]];
    const auto plane =
      planeOf(corner, this->Mesh.points[triangle[1]], this->Mesh.points[triangle[2]]);
    if (!plane)
    {
      throw Error(ErrorCode::badInput,
        this->Name +
          ": a triangle has no area, so no plane; remove it or write nurbs or wireframe");
    }
    this->Sink.begin({ .type = 116, .status = kIgesPart });
    this->Sink.point(corner).integer(0);
    const std::uint64_t location = this->Sink.end();
    const auto direction = [this](const Vec3& v)
    {
      this->Sink.begin({ .type = 123, .status = kDefinition });
      this->Sink.point(v);
      return this->Sink.end();
    };
    const std::uint64_t normal = direction(plane->normal);
    const std::uint64_t along = direction(plane->along);
    this->Sink.begin({ .type = 190, .form = 1, .status = kIgesPart });
    this->Sink.integer(location).integer(normal).integer(along);
    return this->Sink.end();
  }

  const ClosedShell& Shell;
  const TriMesh& Mesh;
  const std::string& Name;
  IgesSink& Sink;
  std::uint64_t Points = 0;
  std::uint64_t Edges = 0;
  std::vector<std::uint64_t> EdgeOf; // per half-edge, its number in the list of edges
};

} // namespace

void writeIgesSolid(
  const Model& model, const IgesHeader& header, OutputFile& file, Execution& execution)
{
  const std::vector<SolidBody> bodies = bodiesOf(model, file.name(), execution);
  const auto put = [&](IgesSink& sink)
  {
    for (const SolidBody& body : bodies)
    {
      const std::uint64_t outer = ShellSink(body.outer, file.name(), sink).put();
      std::vector<std::uint64_t> voids;
      for (const ClosedShell& hollow : body.voids)
      {
        voids.push_back(ShellSink(hollow, file.name(), sink).put());
      }
      sink.begin({ .type = 186 });
      sink.integer(outer).integer(1).integer(voids.size());
      for (const std::uint64_t hollow : voids)
      {
        sink.integer(hollow).integer(1); // 1: faces away from the material
      }
      sink.end();
    }
    putIgesCurves(model, sink);
  };
  writeIgesFile(header, entityCount(bodies) + model.curves.size(), put, file, execution);
}

} // namespace scan
