// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/solid_bodies.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <numbers>
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

/// The pieces of a mesh, ordered by their first triangles.
std::vector<TriMesh> piecesOf(const TriMesh& mesh, const std::vector<Index>& mate)
{
  UnionFind sets(mesh.triangles.size());
  for (Index half = 0; half < mate.size(); ++half)
  {
    const Index here = sets.root(half / 3);
    const Index there = sets.root(mate[half] / 3);
    if (here != there)
    {
      sets.join(std::min(here, there), std::max(here, there));
    }
  }
  std::vector<TriMesh> pieces;
  std::vector<Index> pieceOf(mesh.triangles.size());
  std::vector<Index> local(mesh.points.size(), kNone); // a manifold's point is in one piece only
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const Index root = sets.root(t);
    if (root == t)
    {
      pieceOf[t] = static_cast<Index>(pieces.size());
      pieces.emplace_back();
    }
    TriMesh& piece = pieces[pieceOf[root]];
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

double volumeOf(const TriMesh& mesh)
{
  const Vec3 origin = mesh.points.front();
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    sum += dot(mesh.points[a] - origin, cross(mesh.points[b] - origin, mesh.points[c] - origin));
  }
  return sum / 6.0;
}

/// Whether a point, not on the mesh, is inside: adds the solid angles of the triangles.
bool isInside(const Vec3& point, const TriMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [i, j, k] : mesh.triangles)
  {
    const Vec3 a = mesh.points[i] - point;
    const Vec3 b = mesh.points[j] - point;
    const Vec3 c = mesh.points[k] - point;
    const auto length = [](const Vec3& v) { return std::sqrt(dot(v, v)); };
    sum += std::atan2(dot(a, cross(b, c)),
      length(a) * length(b) * length(c) + dot(a, b) * length(c) + dot(b, c) * length(a) +
        dot(c, a) * length(b));
  }
  return sum > std::numbers::pi; // half of the whole, of which atan2 gives halves
}

/// Inside a triangle: where shells touch, it is at corners and edges.
Vec3 somePointOn(const TriMesh& mesh)
{
  const auto& [a, b, c] = mesh.triangles.front();
  return (mesh.points[a] + mesh.points[b] + mesh.points[c]) * (1.0 / 3.0);
}

/// A piece on its way into a body.
struct Piece
{
  TriMesh mesh;
  double volume;
  BoundingBox box;
  std::size_t body = 0;

  explicit Piece(TriMesh&& piece)
    : mesh(std::move(piece))
    , volume(volumeOf(this->mesh))
    , box(this->mesh.points)
  {
  }

  bool isAround(const Piece& other) const
  {
    const Vec3 point = somePointOn(other.mesh);
    return this->volume >= 0.0 && this->box.squaredDistance(point) == 0.0 &&
      isInside(point, this->mesh);
  }
};

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

/// The smallest outer piece around a void, or null.
const Piece* containerOf(const Piece& hollow, const std::vector<Piece>& pieces)
{
  const Piece* smallest = nullptr;
  for (const Piece& piece : pieces)
  {
    if ((smallest == nullptr || piece.volume < smallest->volume) && piece.isAround(hollow))
    {
      smallest = &piece;
    }
  }
  return smallest;
}

/// Per piece the number of the outer piece that it belongs to: its own when it is one, or a
/// hollow that is in nothing.
std::vector<std::size_t> ownersOf(const std::vector<Piece>& pieces, Execution& execution)
{
  std::vector<std::size_t> owners(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    owners[i] = i;
    if (pieces[i].volume < 0.0)
    {
      execution.step("write", 0, 1);
      const Piece* const container = containerOf(pieces[i], pieces);
      owners[i] = container == nullptr ? i : static_cast<std::size_t>(container - pieces.data());
    }
  }
  return owners;
}

} // namespace

std::vector<SolidBody> bodiesOf(const TriMesh& mesh, const std::string& name, Execution& execution)
{
  requireSolid(mesh, name);
  std::vector<Piece> pieces;
  for (TriMesh& piece : piecesOf(mesh, pairEdges(mesh, execution).mate))
  {
    pieces.emplace_back(std::move(piece));
  }
  const std::vector<std::size_t> owners = ownersOf(pieces, execution);
  std::vector<SolidBody> bodies;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (owners[i] == i)
    {
      if (pieces[i].volume < 0.0)
      {
        turn(pieces[i].mesh);
      }
      pieces[i].body = bodies.size();
      bodies.push_back({ .outer = shellOf(std::move(pieces[i].mesh)), .voids = {} });
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (owners[i] != i)
    {
      bodies[pieces[owners[i]].body].voids.push_back(shellOf(std::move(pieces[i].mesh)));
    }
  }
  return bodies;
}

} // namespace scan
