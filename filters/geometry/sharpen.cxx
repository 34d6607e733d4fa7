// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/sharpen.h"

#include "filters/geometry/chamfers.h"
#include "filters/geometry/half_edges.h"
#include "filters/geometry/limited_move.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/triangle_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace scan
{
namespace
{

constexpr double kReach = 1.0;    // widths of a chamfer, or longest edges of a corner
constexpr double kLeastDet = 0.1; // of three unit normals that meet in a corner

/// A mesh, its chamfers and the edges that are to be cut.
class Sharpener
{
public:
  Sharpener(const TriMesh& mesh, Chamfers chamfers, const SharpenOptions& options)
    : Mesh(mesh)
    , Found(std::move(chamfers))
    , Limit(options.maxDeviation)
    , LeastTurn(std::cos(options.angle * std::numbers::pi / 180.0))
    , Tip(mesh.triangles.size() * 3)
  {
    for (Index half = 0; half < this->Found.isAcross.size(); ++half)
    {
      const Index mate = this->Found.mate[half];
      if (this->Found.isAcross[half] != 0 && (mate == kNone || half < mate))
      {
        this->Tip[half] = this->tipOf(half);
        if (mate != kNone)
        {
          this->Tip[mate] = this->Tip[half];
        }
        this->LeftOut += this->Tip[half] ? 0 : 1;
      }
    }
  }

  /// Cuts the edges that are left.
  SharpenResult cut();

  /// Edges of these triangles of the input stay. Returns whether there were any to cut.
  bool leave(const std::vector<Index>& triangles)
  {
    const Index before = this->LeftOut;
    for (const Index t : triangles)
    {
      for (Index half = 3 * t; half < 3 * t + 3; ++half)
      {
        if (this->Tip[half])
        {
          ++this->LeftOut;
          this->Tip[half].reset();
          if (this->Found.mate[half] != kNone)
          {
            this->Tip[this->Found.mate[half]].reset();
          }
        }
      }
    }
    return this->LeftOut > before;
  }

  bool isCut(Index t) const
  {
    return this->Tip[3 * t] || this->Tip[3 * t + 1] || this->Tip[3 * t + 2];
  }

private:
  const Vec3& from(Index half) const { return this->Mesh.points[originOf(this->Mesh, half)]; }
  const Vec3& normalAt(Index half) const { return this->Found.normals[originOf(this->Mesh, half)]; }

  std::optional<Vec3> tipOf(Index half) const;
  std::optional<Vec3> cornerOf(Index t) const;
  Vec3 held(const Vec3& from, const Vec3& to, SharpenResult& result) const
  {
    const Vec3 place = limitedMove(from, to, this->Limit);
    result.heldBack += place != to ? 1 : 0;
    return place;
  }
  std::vector<Index> addTips(SharpenResult& result) const;
  void addPieces(Index t, const std::vector<Index>& tips, SharpenResult& result) const;
  void addCorner(Index t, const std::array<Index, 6>& ring, SharpenResult& result) const;

  const TriMesh& Mesh;
  Chamfers Found;
  double Limit;
  double LeastTurn; // cosine
  Index LeftOut = 0;
  std::vector<std::optional<Vec3>> Tip; // per half-edge that is to be cut
};

/// The point of both planes that is nearest to the middle of the edge.
std::optional<Vec3> Sharpener::tipOf(Index half) const
{
  const Index next = nextHalf(half);
  const Vec3 way = this->from(next) - this->from(half);
  const Vec3& first = this->normalAt(half);
  const Vec3& second = this->normalAt(next);
  const double cosine = dot(first, second);
  const double rise = -0.5 * dot(first, way); // of the planes over the middle
  const double otherRise = 0.5 * dot(second, way);
  if (!(cosine < this->LeastTurn) || !(1.0 - cosine * cosine > 1e-6) || !(rise * otherRise > 0.0))
  {
    return std::nullopt;
  }
  const double scale = 1.0 / (1.0 - cosine * cosine);
  const Vec3 shift =
    first * (scale * (rise - cosine * otherRise)) + second * (scale * (otherRise - cosine * rise));
  const Vec3 edge = unitVector(cross(first, second));
  const Vec3 width = way - edge * dot(edge, way); // of the chamfer
  if (!(length(shift) <= kReach * length(width)))
  {
    return std::nullopt;
  }
  return (this->from(half) + this->from(next)) * 0.5 + shift;
}

/// Where the planes at the corners of a triangle meet.
std::optional<Vec3> Sharpener::cornerOf(Index t) const
{
  const Index half = 3 * t;
  const std::array<Vec3, 3> n{ this->normalAt(half), this->normalAt(half + 1),
    this->normalAt(half + 2) };
  const std::array<Vec3, 3> p{ this->from(half), this->from(half + 1), this->from(half + 2) };
  const Vec3 middle = (p[0] + p[1] + p[2]) * (1.0 / 3.0);
  const double det = dot(n[0], cross(n[1], n[2]));
  if (!(std::abs(det) > kLeastDet))
  {
    return std::nullopt;
  }
  Vec3 shift;
  double longest = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t next = (k + 1) % 3;
    shift = shift + cross(n[next], n[(k + 2) % 3]) * (dot(n[k], p[k] - middle) / det);
    longest = std::max(longest, length(p[next] - p[k]));
  }
  if (!(length(shift) <= kReach * longest))
  {
    return std::nullopt;
  }
  return middle + shift;
}

/// Adds the points on edges. Returns their numbers by half-edge.
std::vector<Index> Sharpener::addTips(SharpenResult& result) const
{
  std::vector<Index> tips(this->Tip.size(), kNone);
  for (Index half = 0; half < tips.size(); ++half)
  {
    if (!this->Tip[half] || tips[half] != kNone)
    {
      continue;
    }
    const Index a = originOf(this->Mesh, half);
    const Index b = originOf(this->Mesh, nextHalf(half));
    const Vec3 middle = (this->Mesh.points[a] + this->Mesh.points[b]) * 0.5;
    tips[half] = static_cast<Index>(result.edit.mesh.points.size());
    result.edit.mesh.points.push_back(this->held(middle, *this->Tip[half], result));
    result.edit.pointOrigin.push_back(kNone);
    result.edit.blends.push_back({ { a, b, b }, { 0.5, 0.5, 0.0 } });
    if (this->Found.mate[half] != kNone)
    {
      tips[this->Found.mate[half]] = tips[half];
    }
    ++result.edges;
  }
  return tips;
}

/// Of a triangle with all edges cut.
/// @param ring corners and points on edges by turns
void Sharpener::addCorner(Index t, const std::array<Index, 6>& ring, SharpenResult& result) const
{
  TriMesh& mesh = result.edit.mesh;
  const std::optional<Vec3> corner = this->cornerOf(t);
  if (!corner)
  {
    mesh.triangles.insert(mesh.triangles.end(),
      { { ring[0], ring[1], ring[5] }, { ring[2], ring[3], ring[1] }, { ring[4], ring[5], ring[3] },
        { ring[1], ring[3], ring[5] } });
    return;
  }
  const auto& [a, b, c] = this->Mesh.triangles[t];
  const Vec3 middle = (mesh.points[a] + mesh.points[b] + mesh.points[c]) * (1.0 / 3.0);
  const auto tip = static_cast<Index>(mesh.points.size());
  mesh.points.push_back(this->held(middle, *corner, result));
  result.edit.pointOrigin.push_back(kNone);
  result.edit.blends.push_back({ { a, b, c }, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } });
  for (std::size_t k = 0; k < 6; ++k)
  {
    mesh.triangles.push_back({ ring[k], ring[(k + 1) % 6], tip });
  }
  ++result.corners;
}

void Sharpener::addPieces(Index t, const std::vector<Index>& tips, SharpenResult& result) const
{
  TriMesh& mesh = result.edit.mesh;
  std::vector<Triangle>& triangles = mesh.triangles;
  // the edge that is cut, or the one that is not, comes first
  std::array<Index, 3> half{ 3 * t, 3 * t + 1, 3 * t + 2 };
  const auto count = std::ranges::count_if(half, [&](Index h) { return tips[h] != kNone; });
  const auto isOdd = [&](Index h) { return (tips[h] != kNone) == (count == 1); };
  if (count == 1 || count == 2)
  {
    std::ranges::rotate(half, std::ranges::find_if(half, isOdd));
  }
  const auto corner = [&](std::size_t k) { return originOf(this->Mesh, half.at(k)); };
  const auto tip = [&](std::size_t k) { return tips[half.at(k)]; };
  if (count == 0)
  {
    triangles.push_back(this->Mesh.triangles[t]);
  }
  else if (count == 1)
  {
    triangles.insert(
      triangles.end(), { { corner(0), tip(0), corner(2) }, { tip(0), corner(1), corner(2) } });
  }
  else if (count == 2)
  {
    const auto distance = [&](Index a, Index b) { return length(mesh.points[a] - mesh.points[b]); };
    triangles.push_back({ tip(1), corner(2), tip(2) });
    if (distance(corner(0), tip(1)) <= distance(corner(1), tip(2)))
    {
      triangles.insert(
        triangles.end(), { { corner(0), corner(1), tip(1) }, { corner(0), tip(1), tip(2) } });
    }
    else
    {
      triangles.insert(
        triangles.end(), { { corner(0), corner(1), tip(2) }, { corner(1), tip(1), tip(2) } });
    }
  }
  else
  {
    this->addCorner(t, { corner(0), tip(0), corner(1), tip(1), corner(2), tip(2) }, result);
  }
  result.edit.triangleOrigin.resize(triangles.size(), t);
}

SharpenResult Sharpener::cut()
{
  SharpenResult result;
  result.edit = unchanged({ this->Mesh.points, {} });
  const std::vector<Index> tips = this->addTips(result);
  for (Index t = 0; t < this->Mesh.triangles.size(); ++t)
  {
    this->addPieces(t, tips, result);
  }
  result.leftOut = this->LeftOut;
  return result;
}

/// The triangles of the input whose parts turn over or cross others.
std::vector<Index> failures(const TriMesh& mesh, const SharpenResult& result,
  const Sharpener& sharpener, Execution& execution)
{
  std::vector<Index> failed;
  const std::vector<Index>& origin = result.edit.triangleOrigin;
  for (std::size_t i = 0; i < origin.size(); ++i)
  {
    const Vec3 before = areaVector(mesh.points, mesh.triangles[origin[i]]);
    const Vec3 piece = areaVector(result.edit.mesh.points, result.edit.mesh.triangles[i]);
    if (sharpener.isCut(origin[i]) && !(dot(before, piece) > 0.0))
    {
      failed.push_back(origin[i]);
    }
  }
  if (failed.empty() && result.edges > 0)
  {
    for (const TrianglePair& pair : selfIntersections(result.edit.mesh, execution))
    {
      for (const Index piece : pair)
      {
        if (sharpener.isCut(origin[piece]))
        {
          failed.push_back(origin[piece]);
        }
      }
    }
  }
  return failed;
}

} // namespace

SharpenResult sharpen(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const SharpenOptions& options, Execution& execution)
{
  execution.step("sharpen", 0, 1);
  const double angle = options.angle * std::numbers::pi / 180.0;
  Sharpener sharpener(mesh, findChamfers(mesh, inRegion, angle, execution), options);
  SharpenResult result = sharpener.cut();
  execution.step("sharpen", 1, 1);
  execution.step("check", 0, 1);
  while (sharpener.leave(failures(mesh, result, sharpener, execution)))
  {
    result = sharpener.cut();
    execution.step("check", 0, 1);
  }
  execution.step("check", 1, 1);
  return result;
}

} // namespace scan
