// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/decimate.h"

#include "filters/base/error.h"
#include "filters/geometry/box_tree.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/ordered_mesh.h"
#include "filters/geometry/quadric_decimation.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"
#include "filters/geometry/triangle_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace scan
{

namespace
{

/// The largest deviation is several times the mean one; this share lets most limits hold at once.
constexpr double kMeanOfLargest = 0.4;

/// In coordinates from `origin`, as sums of squares need small numbers.
OrderedMesh orderedFrom(const Vec3& origin, const TriMesh& mesh, Execution& execution)
{
  OrderedMesh result = orderedMesh(mesh, execution);
  for (Vec3& point : result.mesh.points)
  {
    point = point - origin;
  }
  return result;
}

/// The corners of triangles outside the region.
std::vector<std::uint8_t> fixedPoints(
  const OrderedMesh& ordered, std::span<const std::uint8_t> isInRegion)
{
  std::vector<std::uint8_t> isFixed(ordered.mesh.points.size(), 0);
  for (std::size_t t = 0; t < ordered.mesh.triangles.size() && !isInRegion.empty(); ++t)
  {
    if (isInRegion[ordered.triangleNames[t]] == 0)
    {
      for (const Index point : ordered.mesh.triangles[t])
      {
        isFixed[point] = 1;
      }
    }
  }
  return isFixed;
}

/// Per point that is left the nearest of the points contracted into it, which it stands for.
std::vector<Index> nearestOfContracted(
  QuadricDecimation& run, const OrderedMesh& ordered, std::span<const std::uint8_t> isFixed)
{
  std::vector<Index> names(ordered.mesh.points.size(), kNone);
  std::vector<double> least(names.size(), std::numeric_limits<double>::infinity());
  for (Index point = 0; point < names.size(); ++point)
  {
    const Index left = run.survivorOf(point);
    const Vec3 way = run.mesh().points[left] - ordered.mesh.points[point];
    const double distance = isFixed[point] != 0 ? -1.0 : dot(way, way); // the fixed one it is
    if (distance < least[left])
    {
      least[left] = distance;
      names[left] = point;
    }
  }
  return names;
}

/// What is left of the mesh, by the names of the input, points and triangles in their order.
/// @param names of the points, as nearestOfContracted()
SurfaceEdit editOf(const QuadricDecimation& run, const std::vector<Index>& names,
  const OrderedMesh& ordered, const TriMesh& input)
{
  const ContractionMesh& left = run.mesh();
  // per input point the surviving point that is it now
  std::vector<Index> survivor(input.points.size(), kNone);
  for (const Index point : left.corner)
  {
    survivor[ordered.pointNames[names[point]]] = point;
  }
  SurfaceEdit edit;
  std::vector<Index> number(input.points.size(), kNone); // per surviving point
  for (Index name = 0; name < survivor.size(); ++name)
  {
    if (const Index point = survivor[name]; point != kNone)
    {
      number[point] = static_cast<Index>(edit.pointOrigin.size());
      const bool stays = left.points[point] == ordered.mesh.points[names[point]];
      edit.pointOrigin.push_back(name);
      edit.mesh.points.push_back(
        stays ? input.points[name] : left.points[point] + input.points.front());
    }
  }
  std::vector<Index> triangle(input.triangles.size(), kNone);
  for (Index t = 0; t < left.corner.size() / 3; ++t)
  {
    triangle[ordered.triangleNames[run.triangleNames()[t]]] = t;
  }
  for (Index name = 0; name < triangle.size(); ++name)
  {
    if (const std::size_t first = 3 * std::size_t{ triangle[name] }; triangle[name] != kNone)
    {
      edit.triangleOrigin.push_back(name);
      edit.mesh.triangles.push_back({ number[left.corner[first]], number[left.corner[first + 1]],
        number[left.corner[first + 2]] });
    }
  }
  return edit;
}

std::vector<std::uint8_t> cornersOf(
  const TriMesh& mesh, std::span<const TrianglePair> pairs, std::size_t points)
{
  std::vector<std::uint8_t> isCorner(points, 0);
  for (const TrianglePair& pair : pairs)
  {
    for (const Index triangle : pair)
    {
      for (const Index corner : mesh.triangles[triangle])
      {
        isCorner[corner] = 1;
      }
    }
  }
  return isCorner;
}

/// trianglesBeyond() of some triangles.
std::vector<Index> beyondAmong(const TriMesh& mesh, const std::vector<Index>& triangles,
  const TriangleTree& to, double limit, Execution& execution)
{
  TriMesh part{ mesh.points, {} };
  for (const Index triangle : triangles)
  {
    part.triangles.push_back(mesh.triangles[triangle]);
  }
  std::vector<Index> beyond = trianglesBeyond(part, to, limit, execution);
  std::ranges::transform(beyond, beyond.begin(), [&](Index place) { return triangles[place]; });
  return beyond;
}

/// Runs until nothing is wrong, holding back what was.
class CheckedDecimation
{
public:
  CheckedDecimation(const TriMesh& mesh, const DecimateOptions& options, Execution& execution)
    : Input(mesh)
    , Options(options)
    , Exec(execution)
    , Ordered(orderedFrom(mesh.points.front(), mesh, execution))
    , IsFixed(fixedPoints(this->Ordered, options.isInRegion))
    , CostLimits(mesh.points.size(), std::numeric_limits<float>::infinity())
  {
    if (std::isfinite(options.maxDeviation))
    {
      this->InputTree.emplace(mesh, execution);
    }
  }

  DecimateResult run()
  {
    constexpr std::size_t kMostRounds = 16;
    DecimateResult result;
    for (result.rounds = 1; result.rounds <= kMostRounds; ++result.rounds)
    {
      QuadricDecimation run(
        this->Ordered.mesh, this->IsFixed, this->Options.creaseAngle, this->Exec);
      run.costLimits = this->CostLimits;
      run.thresholds = this->Thresholds;
      run.run(this->Options.triangles, this->Options.maxDeviation * kMeanOfLargest, this->Exec);
      this->Thresholds = std::move(run.thresholds);
      this->Names = nearestOfContracted(run, this->Ordered, this->IsFixed);
      result.edit = editOf(run, this->Names, this->Ordered, this->Input);
      this->IsWrong.assign(this->Input.points.size(), 0);
      this->CornersWrong = 0;
      result.intersections = this->markIntersections(result.edit, run);
      this->markDeviations(result.edit, run);
      if (this->CornersWrong == 0)
      {
        return result;
      }
      this->holdBack(run, result.rounds);
    }
    if (this->InputTree)
    {
      result.edit = unchanged(this->Input);
      result.intersections = 0;
    }
    return result;
  }

private:
  /// @param name an input point that is left
  void markWrong(Index name)
  {
    this->IsWrong[name] = 1;
    ++this->CornersWrong;
  }

  void markWrong(const SurfaceEdit& edit, Index triangle)
  {
    for (const Index corner : edit.mesh.triangles[triangle])
    {
      this->markWrong(edit.pointOrigin[corner]);
    }
  }

  /// Pairs are wrong but for those of triangles that both come from where the input had some.
  std::size_t markIntersections(const SurfaceEdit& edit, QuadricDecimation& run)
  {
    const std::vector<TrianglePair> pairs = selfIntersections(edit.mesh, this->Exec);
    if (pairs.empty())
    {
      return 0;
    }
    if (!this->IntersectsInInput)
    {
      this->IntersectsInInput = cornersOf(
        this->Input, selfIntersections(this->Input, this->Exec), this->Input.points.size());
    }
    std::vector<std::uint8_t> isExcused(this->Input.points.size(), 0);
    for (Index point = 0; point < this->Ordered.pointNames.size(); ++point)
    {
      if ((*this->IntersectsInInput)[this->Ordered.pointNames[point]] != 0)
      {
        isExcused[this->nameOfSurvivor(run, point)] = 1;
      }
    }
    const auto isOld = [&](Index triangle)
    {
      return std::ranges::any_of(edit.mesh.triangles[triangle],
        [&](Index corner) { return isExcused[edit.pointOrigin[corner]] != 0; });
    };
    std::size_t found = 0;
    for (const auto& [first, second] : pairs)
    {
      if (!isOld(first) || !isOld(second))
      {
        ++found;
        this->markWrong(edit, first);
        this->markWrong(edit, second);
      }
    }
    return found;
  }

  void markDeviations(const SurfaceEdit& edit, QuadricDecimation& run)
  {
    if (!this->InputTree)
    {
      return;
    }
    const double limit = this->Options.maxDeviation;
    const Changes changes = this->changesTo(edit);
    this->ResultFailed.assign(this->Input.triangles.size(), 0);
    for (const Index triangle :
      beyondAmong(edit.mesh, changes.resultTriangles, *this->InputTree, limit, this->Exec))
    {
      this->ResultFailed[edit.triangleOrigin[triangle]] = 1;
      this->markWrong(edit, triangle);
    }
    const TriangleTree tree(edit.mesh, this->Exec);
    this->InputFailed.assign(this->Input.triangles.size(), 0);
    for (const Index triangle :
      beyondAmong(this->Input, changes.inputTriangles, tree, limit, this->Exec))
    {
      this->InputFailed[triangle] = 1;
      for (const Index corner : this->Input.triangles[triangle])
      {
        this->markWrong(this->nameOfSurvivor(run, this->Ordered.numbers[corner]));
      }
    }
    this->Checked = edit;
  }

  /// What a new result has to be checked for, after the last one.
  struct Changes
  {
    std::vector<Index> resultTriangles; ///< that are new
    std::vector<Index> inputTriangles;  ///< near to those of the last result that are gone
  };

  /// What was within the limit of a triangle still is while this one is there.
  Changes changesTo(const SurfaceEdit& edit)
  {
    Changes changes;
    std::vector<Index> before(this->Input.triangles.size(), kNone); // by their names
    for (Index t = 0; t < this->Checked.mesh.triangles.size(); ++t)
    {
      before[this->Checked.triangleOrigin[t]] = t;
    }
    for (Index t = 0; t < edit.mesh.triangles.size(); ++t)
    {
      Index& old = before[edit.triangleOrigin[t]];
      if (old != kNone && this->ResultFailed[edit.triangleOrigin[t]] == 0 &&
        cornerPlaces(this->Checked.mesh, old) == cornerPlaces(edit.mesh, t))
      {
        old = kNone;
      }
      else
      {
        changes.resultTriangles.push_back(t);
      }
    }
    if (this->Checked.mesh.triangles.empty())
    {
      changes.inputTriangles.resize(this->Input.triangles.size());
      std::iota(changes.inputTriangles.begin(), changes.inputTriangles.end(), Index{ 0 });
      return changes;
    }
    TriMesh gone{ this->Checked.mesh.points, {} };
    for (const Index t : before)
    {
      if (t != kNone)
      {
        gone.triangles.push_back(this->Checked.mesh.triangles[t]);
      }
    }
    const TriangleTree goneTree(gone, this->Exec);
    const double limit = this->Options.maxDeviation;
    const Vec3 reach{ limit, limit, limit };
    changes.inputTriangles =
      collect<Index>(static_cast<Index>(this->Input.triangles.size()), this->Exec,
        [&](Index t, std::vector<Index>& found)
        {
          const Box box = boxOf(this->Input, t);
          std::vector<Index> near;
          goneTree.touching({ box.low - reach, box.high + reach }, near);
          if (!near.empty() || this->InputFailed[t] != 0)
          {
            found.push_back(t);
          }
        });
    return changes;
  }

  /// The name of the point that an ordered one was contracted into.
  Index nameOfSurvivor(QuadricDecimation& run, Index point) const
  {
    return this->Ordered.pointNames[this->Names[run.survivorOf(point)]];
  }

  /// What became part of a wrong point may do so only at a lower cost: half the distance for some
  /// rounds, then an eighth, then not at all.
  void holdBack(QuadricDecimation& run, std::size_t round)
  {
    const float share = round <= 8 ? 1.0F / 8.0F : round <= 12 ? 1.0F / 512.0F : 0.0F;
    for (Index point = 0; point < this->CostLimits.size(); ++point)
    {
      if (this->IsWrong[this->nameOfSurvivor(run, point)] != 0)
      {
        float& limit = this->CostLimits[point];
        limit = std::min(limit, share * run.costOf(run.survivorOf(point)));
      }
    }
  }

  const TriMesh& Input;
  const DecimateOptions& Options;
  Execution& Exec;
  OrderedMesh Ordered;
  std::vector<std::uint8_t> IsFixed;
  std::vector<Index> Names;      // of the points that the last run left
  std::vector<float> CostLimits; // per ordered point
  std::vector<float> Thresholds; // of the first round
  std::optional<TriangleTree> InputTree;
  SurfaceEdit Checked;                    // the last result: within the limit, but for what failed
  std::vector<std::uint8_t> ResultFailed; // per input triangle that is left
  std::vector<std::uint8_t> InputFailed;  // per input triangle
  std::optional<std::vector<std::uint8_t>> IntersectsInInput; // per input point
  std::vector<std::uint8_t> IsWrong;                          // per input point that is left
  std::size_t CornersWrong = 0;
};

} // namespace

void requireDecimation(const TriMesh& mesh, const DecimateOptions& options)
{
  if (options.triangles == 0 && !std::isfinite(options.maxDeviation))
  {
    throw Error(ErrorCode::badParameter,
      "say how far to go: a number of triangles, a share of them, or a largest deviation");
  }
  requireCorners(mesh);
  requireFinitePoints(mesh.points);
}

DecimateResult decimate(const TriMesh& mesh, const DecimateOptions& options, Execution& execution)
{
  requireDecimation(mesh, options);
  DecimateResult result;
  if (mesh.triangles.size() <= options.triangles || mesh.triangles.empty())
  {
    result.edit = unchanged(mesh);
    return result;
  }
  result = CheckedDecimation(mesh, options, execution).run();
  for (std::size_t i = 0; i < result.edit.mesh.points.size(); ++i)
  {
    if (!(result.edit.mesh.points[i] == mesh.points[result.edit.pointOrigin[i]]))
    {
      ++result.pointsMoved;
    }
  }
  execution.step("decimate", 1, 1);
  return result;
}

} // namespace scan
