// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/openmesh_decimate.h"

#include "filters/base/error.h"
#include "filters/geometry/mesh_split.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/vector_cast.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/Observer.hh>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scan
{

namespace
{

struct DoubleTraits : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
  FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
};

using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<DoubleTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<HalfEdgeMesh>;

HalfEdgeMesh halfEdgeMeshOf(const TriMesh& mesh)
{
  HalfEdgeMesh result;
  result.reserve(mesh.points.size(), 3 * mesh.triangles.size() / 2, mesh.triangles.size());
  for (const Vec3& p : mesh.points)
  {
    result.add_vertex({ p.x, p.y, p.z });
  }
  const auto handle = [](Index point) { return OpenMesh::VertexHandle(static_cast<int>(point)); };
  for (const auto& [a, b, c] : mesh.triangles)
  {
    if (!result.add_face(handle(a), handle(b), handle(c)).is_valid())
    {
      throw Error(ErrorCode::badInput,
        "a triangle names a point twice or does not fit its neighbours; mend the surface first");
    }
  }
  result.update_face_normals();
  return result;
}

/// Ends a run when it is cancelled.
class CancelObserver : public OpenMesh::Decimater::Observer
{
public:
  explicit CancelObserver(const Execution& execution)
    : Observer(1024)
    , Exec(execution)
  {
  }
  void notify(std::size_t) override {}
  bool abort() const override { return this->Exec.cancelled(); }

private:
  const Execution& Exec;
};

/// Forbids contractions that make an edge too long.
template <class MeshT>
class ModLongestEdgeT : public OpenMesh::Decimater::ModBaseT<MeshT>
{
public:
  DECIMATING_MODULE(ModLongestEdgeT, MeshT, LongestEdge);

  explicit ModLongestEdgeT(MeshT& mesh)
    : Base(mesh, true)
  {
  }

  void setLimit(double limit) { this->Limit = limit; }

  float collapse_priority(const CollapseInfo& contraction) override
  {
    for (auto ring = contraction.mesh.cvv_iter(contraction.v0); ring.is_valid(); ++ring)
    {
      if ((contraction.mesh.point(*ring) - contraction.p1).norm() > this->Limit)
      {
        return Base::ILLEGAL_COLLAPSE;
      }
    }
    return Base::LEGAL_COLLAPSE;
  }

private:
  double Limit = 0.0;
};

template <class Module>
Module& add(Decimater& decimater)
{
  typename OpenMesh::Decimater::ModHandleT<Module> handle;
  decimater.add(handle);
  return decimater.module(handle);
}

/// Contracts what the conditions allow.
void contract(HalfEdgeMesh& mesh, const DecimateOptions& options,
  const OpenMeshConditions& conditions, double tolerance, Execution& execution)
{
  using namespace OpenMesh::Decimater;
  Decimater decimater(mesh);
  add<ModQuadricT<HalfEdgeMesh>>(decimater).unset_max_err();
  add<ModNormalFlippingT<HalfEdgeMesh>>(decimater);
  if (std::isfinite(tolerance))
  {
    add<ModHausdorffT<HalfEdgeMesh>>(decimater).set_tolerance(tolerance);
  }
  if (conditions.maxNormalDeviation < 180.0)
  {
    add<ModNormalDeviationT<HalfEdgeMesh>>(decimater).set_normal_deviation(
      static_cast<float>(conditions.maxNormalDeviation));
  }
  if (std::isfinite(conditions.longestEdge))
  {
    add<ModLongestEdgeT<HalfEdgeMesh>>(decimater).setLimit(conditions.longestEdge);
  }
  if (conditions.maxAspectRatio > 0.0)
  {
    add<ModAspectRatioT<HalfEdgeMesh>>(decimater).set_aspect_ratio(
      static_cast<float>(conditions.maxAspectRatio));
  }
  CancelObserver observer(execution);
  decimater.set_observer(&observer);
  if (!decimater.initialize())
  {
    throw Error(ErrorCode::internal, "OpenMesh: the modules do not fit together");
  }
  decimater.decimate_to_faces(0, options.triangles);
}

/// What is left, where the points of the split input come from.
SurfaceEdit editOf(const HalfEdgeMesh& mesh, const std::vector<Index>& pointOrigin)
{
  SurfaceEdit edit;
  std::vector<Index> number(mesh.n_vertices(), kNone);
  for (std::size_t i = 0; i < mesh.n_faces(); ++i)
  {
    const OpenMesh::FaceHandle face(static_cast<int>(i));
    if (mesh.status(face).deleted())
    {
      continue;
    }
    Triangle triangle{};
    auto corner = triangle.begin();
    for (auto vertex = mesh.cfv_iter(face); vertex.is_valid(); ++vertex)
    {
      const auto point = static_cast<std::size_t>(vertex->idx());
      if (number[point] == kNone)
      {
        number[point] = static_cast<Index>(edit.mesh.points.size());
        const auto& p = mesh.point(*vertex);
        edit.mesh.points.push_back({ p[0], p[1], p[2] });
        edit.pointOrigin.push_back(pointOrigin[point]);
      }
      *corner++ = number[point];
    }
    edit.mesh.triangles.push_back(triangle);
    edit.triangleOrigin.push_back(static_cast<Index>(i));
  }
  return edit;
}

bool isWithin(const TriMesh& before, const TriMesh& after, double limit, Execution& execution)
{
  const TriangleTree beforeTree(before, execution);
  const TriangleTree afterTree(after, execution);
  return trianglesBeyond(after, beforeTree, limit, execution).empty() &&
    trianglesBeyond(before, afterTree, limit, execution).empty();
}

/// Points in a region's complement and copies of points stay.
void lockPoints(HalfEdgeMesh& mesh, const SplitResult& split, const DecimateOptions& options)
{
  const auto lock = [&](Index point)
  { mesh.status(OpenMesh::VertexHandle(static_cast<int>(point))).set_locked(true); };
  for (std::size_t t = 0; t < options.isInRegion.size(); ++t)
  {
    if (options.isInRegion[t] == 0)
    {
      std::ranges::for_each(split.mesh.triangles[t], lock);
    }
  }
  for (Index copy = 0; copy < split.pointOrigin.size(); ++copy)
  {
    if (split.pointOrigin[copy] != copy)
    {
      lock(copy);
      lock(split.pointOrigin[copy]);
    }
  }
}

} // namespace

DecimateResult decimateByOpenMesh(const TriMesh& mesh, const DecimateOptions& options,
  const OpenMeshConditions& conditions, Execution& execution)
{
  requireDecimation(mesh, options);
  DecimateResult result;
  result.edit = unchanged(mesh);
  if (mesh.triangles.size() <= options.triangles)
  {
    return result;
  }
  const SplitResult split = splitNonManifold(mesh, execution);
  const HalfEdgeMesh whole = halfEdgeMeshOf(split.mesh);
  constexpr std::size_t kMostRounds = 8;
  double tolerance = options.maxDeviation;
  for (result.rounds = 1; result.rounds <= kMostRounds; ++result.rounds, tolerance *= 0.7)
  {
    execution.step("decimate", result.rounds - 1, kMostRounds);
    HalfEdgeMesh working = whole;
    lockPoints(working, split, options);
    contract(working, options, conditions, tolerance, execution);
    execution.step("decimate", result.rounds - 1, kMostRounds);
    SurfaceEdit edit = editOf(working, split.pointOrigin);
    if (!std::isfinite(options.maxDeviation) ||
      isWithin(mesh, edit.mesh, options.maxDeviation, execution))
    {
      result.intersections = selfIntersections(edit.mesh, execution).size();
      result.edit = std::move(edit);
      break;
    }
  }
  execution.step("decimate", 1, 1);
  return result;
}

} // namespace scan
