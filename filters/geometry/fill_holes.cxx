// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/fill_holes.h"

#include "filters/geometry/finite_points.h"
#include "filters/geometry/hole_choice.h"
#include "filters/geometry/hole_patch.h"
#include "filters/geometry/local_plane.h"
#include "filters/geometry/self_intersections.h"
#include "filters/geometry/surface_deviation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace scan
{
namespace
{

/// Patches in the order in which they are tried for a hole, by shape: the last is flat, too.
constexpr int kLastTry = 3;

/// A hole on the way to its patch.
struct Filling
{
  Index hole = 0; // of the result
  HolePolygon polygon;
  int tries = 0; // the next to make
  std::optional<Patch> patch = {};
  Index points = 0; // new ones of the patch, without those of the chord: where they begin
  Index firstTriangle = 0;
};

PointBlend blendOfNearest(const TriMesh& mesh, const std::vector<Index>& rim, const Vec3& at)
{
  std::array<double, 3> squared{};
  PointBlend blend;
  std::size_t count = 0;
  for (const Index point : rim)
  {
    const Vec3 d = mesh.points[point] - at;
    double distance = dot(d, d);
    Index from = point;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (k >= count || distance < squared.at(k))
      {
        std::swap(distance, squared.at(k));
        std::swap(from, blend.from.at(k));
        if (k >= count)
        {
          ++count;
          break;
        }
      }
    }
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    blend.weights.at(k) = k < count ? 1.0 / std::max(std::sqrt(squared.at(k)), 1e-150) : 0.0;
    sum += blend.weights.at(k);
  }
  std::ranges::for_each(blend.weights, [&](double& weight) { weight /= sum; });
  return blend;
}

class Filler
{
public:
  Filler(const TriMesh& mesh, const FillHolesOptions& options, FillHolesResult& result,
    std::vector<HolePolygon> polygons, Execution& execution)
    : Mesh(mesh)
    , Options(options)
    , Result(result)
    , Run(execution)
    , Surface(mesh, polygons)
  {
    Index hole = 0;
    for (HolePolygon& polygon : polygons)
    {
      if (!polygon.points.empty())
      {
        this->Fillings.push_back({ hole, std::move(polygon), kLastTry - 1 - shapeNumber() });
      }
      ++hole;
    }
  }

  void run();

private:
  int shapeNumber() const { return static_cast<int>(this->Options.shape); }
  std::optional<Patch> makePatch(const Filling& filling) const;
  bool isWithinLimit(const Filling& filling, const Patch& patch) const;
  void takeNextPatch(Filling& filling);
  void changeDiagonals(const Patch& patch, bool isAdded);
  bool giveWay(const std::vector<TrianglePair>& conflicts);
  SurfaceEdit assembled();

  const TriMesh& Mesh;
  const FillHolesOptions& Options;
  FillHolesResult& Result;
  Execution& Run;
  HoledSurface Surface;
  std::vector<Filling> Fillings;
};

/// Whether no point of a patch is farther from the flat one than allowed.
bool Filler::isWithinLimit(const Filling& filling, const Patch& patch) const
{
  const Hole& hole = this->Result.holes[filling.hole];
  for (const Vec3& p : patch.mesh.points)
  {
    if (!(length(p - hole.place) <= hole.length)) // far off: the rim was too rough to continue
    {
      return false;
    }
  }
  if (this->Options.maxDeviation == std::numeric_limits<double>::infinity())
  {
    return true;
  }
  const auto flat = this->Surface.flatPatch(filling.polygon, LoopAim::fold, this->Run);
  if (!flat)
  {
    return false;
  }
  const TriangleTree tree(flat->mesh, this->Run);
  return trianglesBeyond(patch.mesh, tree, this->Options.maxDeviation, this->Run).empty();
}

std::optional<Patch> Filler::makePatch(const Filling& filling) const
{
  const int flats = filling.tries - (kLastTry - 1);
  if (flats >= 0)
  {
    return this->Surface.flatPatch(
      filling.polygon, flats == 0 ? LoopAim::fold : LoopAim::area, this->Run);
  }
  auto patch = this->Surface.smoothPatch(
    filling.polygon, flats == -1 ? FillShape::tangent : FillShape::curved, this->Run);
  return patch && this->isWithinLimit(filling, *patch) ? std::move(patch) : std::nullopt;
}

void Filler::changeDiagonals(const Patch& patch, bool isAdded)
{
  for (const Triangle& t : patch.mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index a = t[k];
      const Index b = t[(k + 1) % 3];
      if (a < patch.rim() && b < patch.rim())
      {
        isAdded ? this->Surface.taken.add(patch.names[a], patch.names[b])
                : this->Surface.taken.remove(patch.names[a], patch.names[b]);
      }
    }
  }
}

/// Gives a hole the next patch that there is, or none.
void Filler::takeNextPatch(Filling& filling)
{
  if (filling.patch)
  {
    this->changeDiagonals(*filling.patch, false);
    filling.patch.reset();
  }
  while (!filling.patch && filling.tries <= kLastTry)
  {
    filling.patch = this->makePatch(filling);
    const int flatness = std::min(filling.tries, kLastTry - 1);
    this->Result.holes[filling.hole].shape = static_cast<FillShape>(kLastTry - 1 - flatness);
    ++filling.tries;
  }
  if (filling.patch)
  {
    this->changeDiagonals(*filling.patch, true);
  }
}

/// The input and all patches.
SurfaceEdit Filler::assembled()
{
  SurfaceEdit edit = unchanged(this->Mesh);
  for (Filling& filling : this->Fillings)
  {
    filling.firstTriangle = static_cast<Index>(edit.mesh.triangles.size());
    if (!filling.patch)
    {
      continue;
    }
    const Patch& patch = *filling.patch;
    std::vector<Index> numbers;
    for (Index i = 0; i < patch.mesh.points.size(); ++i)
    {
      if (i < patch.rim() && patch.names[i] < this->Mesh.points.size())
      {
        numbers.push_back(patch.names[i]);
        continue;
      }
      numbers.push_back(static_cast<Index>(edit.mesh.points.size()));
      edit.mesh.points.push_back(patch.mesh.points[i]);
      edit.pointOrigin.push_back(kNone);
      edit.blends.push_back(
        blendOfNearest(this->Mesh, filling.polygon.points, patch.mesh.points[i]));
    }
    for (const Triangle& t : patch.mesh.triangles)
    {
      edit.mesh.triangles.push_back({ numbers[t[0]], numbers[t[1]], numbers[t[2]] });
      edit.triangleOrigin.push_back(kNone);
    }
  }
  return edit;
}

/// Makes patches that cut something flatter. Of two that cut each other and cannot become flatter,
/// the second goes. Returns whether there were any.
bool Filler::giveWay(const std::vector<TrianglePair>& conflicts)
{
  const auto fillingOf = [&](Index triangle) -> Filling*
  {
    const auto after =
      std::ranges::upper_bound(this->Fillings, triangle, {}, &Filling::firstTriangle);
    return after == this->Fillings.begin() ? nullptr : &*std::prev(after);
  };
  std::vector<std::uint8_t> isDone(this->Fillings.size(), 0);
  const auto doneOf = [&](const Filling* filling) -> std::uint8_t&
  { return isDone[static_cast<std::size_t>(filling - this->Fillings.data())]; };
  for (const auto& [first, second] : conflicts)
  {
    std::vector<Filling*> both{ fillingOf(first), fillingOf(second) };
    std::erase(both, nullptr);
    if (both.size() == 2 && both[0] != both[1])
    {
      // who can give way does, both if both can
      const bool canFirst = both[0]->tries <= kLastTry;
      const bool canSecond = both[1]->tries <= kLastTry;
      if (canFirst != canSecond || !canFirst)
      {
        both = { canFirst ? both[0] : both[1] };
      }
    }
    if (std::ranges::none_of(both, [&](const Filling* f) { return doneOf(f) != 0; }))
    {
      for (Filling* const filling : both)
      {
        if (doneOf(filling)++ == 0)
        {
          this->takeNextPatch(*filling);
        }
      }
    }
  }
  return !conflicts.empty();
}

void Filler::run()
{
  for (std::size_t i = 0; i < this->Fillings.size(); ++i)
  {
    this->Run.step("fill", i, this->Fillings.size());
    this->takeNextPatch(this->Fillings[i]);
  }
  this->Run.step("check", 0, 1);
  std::vector<Index> fresh;
  do
  {
    this->Result.edit = this->assembled();
    const std::size_t added = this->Result.edit.mesh.triangles.size() - this->Mesh.triangles.size();
    fresh.resize(added);
    std::iota(fresh.begin(), fresh.end(), static_cast<Index>(this->Mesh.triangles.size()));
  } while (this->giveWay(selfIntersections(this->Result.edit.mesh, fresh, this->Run)));
  for (const Filling& filling : this->Fillings)
  {
    if (!filling.patch)
    {
      this->Result.holes[filling.hole].fate = HoleFate::noRoom;
    }
  }
}

} // namespace

FillHolesResult fillHoles(const TriMesh& mesh, std::span<const std::uint8_t> inRegion,
  const FillHolesOptions& options, Execution& execution)
{
  execution.step("fill", 0, 1);
  requireFinitePoints(mesh.points);
  FillHolesResult result;
  HoleChoice choice = chooseHoles(mesh, inRegion, options, execution);
  result.holes = std::move(choice.holes);
  const bool isAny = std::ranges::any_of(
    choice.polygons, [](const HolePolygon& polygon) { return !polygon.points.empty(); });
  if (isAny)
  {
    Filler(mesh, options, result, std::move(choice.polygons), execution).run();
  }
  else
  {
    result.edit = unchanged(mesh);
  }
  result.pointsAdded = static_cast<Index>(result.edit.mesh.points.size() - mesh.points.size());
  result.trianglesAdded =
    static_cast<Index>(result.edit.mesh.triangles.size() - mesh.triangles.size());
  execution.step("check", 1, 1);
  return result;
}

} // namespace scan
