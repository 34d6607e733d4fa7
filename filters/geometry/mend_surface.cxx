// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/mend_surface.h"

#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scan
{

MendSurface::MendSurface(const TriMesh& input, std::vector<std::uint8_t> active)
  : mesh(input)
  , pointOrigin(input.points.size())
  , triangleOrigin(input.triangles.size())
  , isActive(std::move(active))
  , Input(&input)
{
  std::iota(this->pointOrigin.begin(), this->pointOrigin.end(), Index{ 0 });
  std::iota(this->triangleOrigin.begin(), this->triangleOrigin.end(), Index{ 0 });
}

void MendSurface::addTriangle(const Triangle& corners, Index origin)
{
  this->mesh.triangles.push_back(corners);
  this->triangleOrigin.push_back(origin);
  this->isActive.push_back(1);
}

void MendSurface::addPoint(const Vec3& at, const PointBlend& blend)
{
  this->mesh.points.push_back(at);
  this->pointOrigin.push_back(kNone);
  this->blends.push_back(blend);
}

void MendSurface::removeTriangles(const std::vector<std::uint8_t>& isGone)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < isGone.size(); ++t)
  {
    if (isGone[t] == 0)
    {
      this->mesh.triangles[kept] = this->mesh.triangles[t];
      this->triangleOrigin[kept] = this->triangleOrigin[t];
      this->isActive[kept] = this->isActive[t];
      ++kept;
    }
  }
  this->mesh.triangles.resize(kept);
  this->triangleOrigin.resize(kept);
  this->isActive.resize(kept);
}

void MendSurface::become(ConsistentSurface&& surface)
{
  const std::size_t inputs = this->Input->points.size();
  for (std::size_t p = this->pointOrigin.size(); p < surface.pointOrigin.size(); ++p)
  {
    const Index from = surface.pointOrigin[p];
    this->pointOrigin.push_back(this->pointOrigin[from]);
    this->blends.push_back(from < inputs ? PointBlend{} : this->blends[from - inputs]);
  }
  const auto composed = [&](const auto& values)
  {
    auto result = values;
    result.clear();
    for (const Index from : surface.triangleOrigin)
    {
      result.push_back(values[from]);
    }
    return result;
  };
  this->triangleOrigin = composed(this->triangleOrigin);
  this->isActive = composed(this->isActive);
  this->mesh = std::move(surface.mesh);
}

double MendSurface::shiftOf(Index point) const
{
  const Index origin = this->pointOrigin[point];
  return origin == kNone ? 0.0 : length(this->mesh.points[point] - this->Input->points[origin]);
}

SurfaceEdit MendSurface::finish() const
{
  const auto mark = [](const TriMesh& of, std::size_t count)
  {
    std::vector<std::uint8_t> isUsed(count, 0);
    for (const Triangle& t : of.triangles)
    {
      std::ranges::for_each(t, [&](Index point) { isUsed[point] = 1; });
    }
    return isUsed;
  };
  const std::vector<std::uint8_t> wasUsed = mark(*this->Input, this->Input->points.size());
  const std::vector<std::uint8_t> isUsed = mark(this->mesh, this->mesh.points.size());
  SurfaceEdit edit;
  std::vector<Index> number(this->mesh.points.size(), kNone);
  for (std::size_t p = 0; p < number.size(); ++p)
  {
    const bool wasIdle = p < wasUsed.size() && wasUsed[p] == 0;
    if (isUsed[p] == 0 && !wasIdle)
    {
      continue;
    }
    number[p] = static_cast<Index>(edit.mesh.points.size());
    edit.mesh.points.push_back(this->mesh.points[p]);
    edit.pointOrigin.push_back(this->pointOrigin[p]);
    if (this->pointOrigin[p] == kNone)
    {
      edit.blends.push_back(this->blends[p - wasUsed.size()]);
    }
  }
  edit.mesh.triangles = this->mesh.triangles;
  for (Triangle& t : edit.mesh.triangles)
  {
    std::ranges::for_each(t, [&](Index& point) { point = number[point]; });
  }
  edit.triangleOrigin = this->triangleOrigin;
  return edit;
}

PointBlend MendSurface::blendIn(Index triangle, const Vec3& at) const
{
  const std::vector<Vec3>& points = this->Input->points;
  const Triangle& t = this->Input->triangles[triangle];
  const Vec3& a = points[t[0]];
  const Vec3& b = points[t[1]];
  const Vec3& c = points[t[2]];
  const Vec3 p = nearestPointOnTriangle(at, a, b, c);
  const Vec3 normal = cross(b - a, c - a);
  const double whole = dot(normal, normal);
  if (!(whole > 0.0))
  {
    return { t, { 1.0, 0.0, 0.0 } };
  }
  const double first = std::clamp(dot(cross(b - p, c - p), normal) / whole, 0.0, 1.0);
  const double second = std::clamp(dot(cross(c - p, a - p), normal) / whole, 0.0, 1.0 - first);
  return { t, { first, second, 1.0 - first - second } };
}

} // namespace scan
