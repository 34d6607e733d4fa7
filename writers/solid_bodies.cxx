// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/solid_bodies.h"

#include "filters/base/error.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/shells.h"

#include <utility>

namespace scan
{
namespace
{

void requireSolid(const TriMesh& mesh, const std::string& name)
{
  const MeshReport report = describeMesh(mesh);
  std::string faults;
  const auto count = [&](Index number, const char* what)
  {
    if (number > 0)
    {
      faults += (faults.empty() ? "" : ", ") + std::to_string(number) + " " + what;
    }
  };
  count(report.boundaryEdges, "boundary edges");
  count(report.nonManifoldEdges, "non-manifold edges");
  count(report.nonManifoldVertices, "non-manifold points");
  count(report.misorientedEdges, "misoriented edges");
  count(report.collapsedTriangles + report.flatTriangles, "triangles without area");
  if (!faults.empty())
  {
    throw Error(ErrorCode::badInput,
      name + ": not the surface of a solid: " + faults + "; mend it or write it as faces");
  }
}

/// Each shell as a mesh of its own.
std::vector<TriMesh> meshesOf(const TriMesh& mesh, const Shells& shells)
{
  std::vector<TriMesh> pieces(shells.shells.size());
  std::vector<Index> local(mesh.points.size(), kNone); // a manifold's point is in one shell only
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    TriMesh& piece = pieces[shells.shellOf[t]];
    Triangle triangle = mesh.triangles[t];
    for (Index& corner : triangle)
    {
      if (local[corner] == kNone)
      {
        local[corner] = static_cast<Index>(piece.points.size());
        piece.points.push_back(mesh.points[corner]);
      }
      corner = local[corner];
    }
    piece.triangles.push_back(triangle);
  }
  return pieces;
}

ClosedShell shellOf(TriMesh&& mesh)
{
  EdgePairs pairs = pairEdges(mesh);
  return { std::move(mesh), std::move(pairs.mate) };
}

void turn(TriMesh& mesh)
{
  for (Triangle& triangle : mesh.triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

/// The shell of whose body a shell that faces inwards is a void; kNone for all others.
Index bodyAround(const Shells& shells, Index shell)
{
  if (shells.shells[shell].volume >= 0.0)
  {
    return kNone;
  }
  do
  {
    shell = shells.shells[shell].container;
  } while (shell != kNone && shells.shells[shell].volume < 0.0);
  return shell;
}

} // namespace

std::vector<SolidBody> bodiesOf(const TriMesh& mesh, const std::string& name, Execution& execution)
{
  requireSolid(mesh, name);
  Shells shells = findShells(mesh, pairEdges(mesh, execution).mate);
  findContainers(mesh, shells, execution);
  std::vector<TriMesh> meshes = meshesOf(mesh, shells);
  std::vector<SolidBody> bodies;
  std::vector<std::size_t> bodyOf(meshes.size());
  for (Index i = 0; i < meshes.size(); ++i)
  {
    if (bodyAround(shells, i) == kNone)
    {
      if (shells.shells[i].volume < 0.0)
      {
        turn(meshes[i]);
      }
      bodyOf[i] = bodies.size();
      bodies.push_back({ .outer = shellOf(std::move(meshes[i])), .voids = {} });
    }
  }
  for (Index i = 0; i < meshes.size(); ++i)
  {
    if (const Index body = bodyAround(shells, i); body != kNone)
    {
      bodies[bodyOf[body]].voids.push_back(shellOf(std::move(meshes[i])));
    }
  }
  return bodies;
}

} // namespace scan
