// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/refine.h"

#include "filters/base/error.h"
#include "filters/geometry/huge_pages.h"
#include "filters/geometry/limited_move.h"
#include "filters/geometry/loop_rules.h"
#include "filters/geometry/refine_blends.h"
#include "filters/geometry/refine_plan.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <unistd.h>

namespace scan
{
namespace
{

constexpr std::size_t kGrain = 4096;

/// Throws where the result cannot be counted or is too large for the machine, with the data that
/// come with it.
void requireRoom(std::size_t triangles, std::size_t chosen, int times)
{
  constexpr double kBytesPerTriangle = 150.0;
  const double last =
    static_cast<double>(triangles - chosen) + std::ldexp(static_cast<double>(chosen), 2 * times);
  const double memory =
    static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  const bool isTooMany = last >= kNone / 3.0;
  if (isTooMany || (memory > 0.0 && last * kBytesPerTriangle > memory))
  {
    throw Error(ErrorCode::limit,
      "that would make " + std::to_string(static_cast<long long>(last)) + " triangles, more than " +
        (isTooMany ? "can be counted" : "the memory of this machine holds") +
        "; refine fewer times or a smaller region");
  }
}

/// The surface between two rounds.
struct Surface
{
  TriMesh mesh;
  std::vector<std::uint8_t> isChosen; ///< per triangle
  std::vector<std::uint8_t> halves;   ///< per triangle; or empty
  std::vector<std::uint8_t> creases;  ///< per triangle a bit for each edge; or empty
  std::vector<Index> origin;          ///< per triangle that of the input
  std::vector<Vec3> flat;             ///< per point its place in the input; empty: all are there
};

class Refiner
{
public:
  Refiner(const TriMesh& mesh, const RefineOptions& options, Execution& execution)
    : Options(options)
    , Run(execution)
    , Blends(static_cast<Index>(mesh.points.size()))
    , IsHeld(mesh.points.size(), 0)
  {
    double largest = 0.0;
    for (const Vec3& p : mesh.points)
    {
      largest = std::max({ largest, std::abs(p.x), std::abs(p.y), std::abs(p.z) });
    }
    // less the rounding of coordinates
    this->Limit = std::max(0.0, options.maxDeviation - 0x1p-50 * largest);
    this->SafeSquare = this->Limit * this->Limit * (1.0 - 0x1p-50);
  }

  /// Refines the chosen triangles once; false where none of them can be.
  bool refineOnce(const TriMesh& mesh, Surface& surface, bool isLast);

  RefineResult take(const TriMesh& input, Surface& surface);

private:
  bool isLoop() const { return this->Options.mode == RefineOptions::Mode::loop; }
  void recordJoins(const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan,
    std::span<const std::uint8_t> halves);
  std::vector<Vec3> flatPlaces(
    const TriMesh& mesh, const RefinePlan& plan, std::span<const Vec3> flat);
  std::vector<Vec3> loopPlaces(
    const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan, const Surface& surface);
  void blendMiddles(const TriMesh& mesh, const RefinePlan& plan);
  Vec3 held(Index point, const Vec3& flat, const Vec3& to, double& largest);
  void cutTriangles(
    const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan, Surface& surface);

  const RefineOptions& Options;
  Execution& Run;
  RefineBlends Blends;
  double Limit = 0.0;
  double SafeSquare = 0.0;          // surely within the limit
  std::vector<std::uint8_t> IsHeld; // per point
  RefineResult Result;
};

double squaredLength(const Vec3& v)
{
  return dot(v, v);
}

/// Sets the number to the value where that is larger.
void raise(std::atomic<double>& number, double value)
{
  double before = number.load(std::memory_order_relaxed);
  while (before < value && !number.compare_exchange_weak(before, value, std::memory_order_relaxed))
  {
  }
}

/// Calls grow(size) and then fill(begin, end), in parallel, block after block: what is new in
/// memory is filled while it is near.
template <class Grow, class Fill>
void inBlocks(Execution& execution, std::size_t count, Grow&& grow, Fill&& fill)
{
  constexpr std::size_t kBlock = 8 * kGrain;
  for (std::size_t first = 0; first < count; first += kBlock)
  {
    const std::size_t last = std::min(count, first + kBlock);
    grow(last);
    execution.parallelFor(last - first, kGrain,
      [&](std::size_t begin, std::size_t end) { fill(first + begin, first + end); });
  }
}

void Refiner::recordJoins(const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan,
  std::span<const std::uint8_t> halves)
{
  std::vector<RefineBlends::Join> joins;
  for (Index t = 0; t < halves.size(); ++t)
  {
    if (plan.cuts[t] == RefinePlan::Cut::join && !isSecondHalf(halves[t]))
    {
      const Index seam = seamOf(t, halves[t]);
      joins.push_back({ originOf(mesh, seam), originOf(mesh, previousHalf(seam)),
        originOf(mesh, previousHalf(fans.mate(seam))) });
    }
  }
  this->Blends.addJoins(joins);
}

void Refiner::blendMiddles(const TriMesh& mesh, const RefinePlan& plan)
{
  const auto first = static_cast<Index>(mesh.points.size());
  this->Blends.reserve(first + plan.cutHalf.size());
  inBlocks(
    this->Run, plan.cutHalf.size(), [&](std::size_t size) { this->Blends.grow(first + size); },
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const HalfCorners ends = cornersOf(mesh, plan.cutHalf[i]);
        this->Blends.setMiddle(first + static_cast<Index>(i), ends.from, ends.to);
      }
    });
}

/// Whether the middle of the edge cuts a part of a triangle that is put together: such a half must
/// stay flat, so that it can be put together with the other.
bool cutsQuarter(const RefinePlan& plan, std::span<const std::uint8_t> halves, Index half)
{
  const Index t = half / 3;
  return plan.cuts[t] == RefinePlan::Cut::join && half != 3 * t + (middleOf(halves[t]) + 1) % 3;
}

/// The middles of the edges behind the points.
std::vector<Vec3> Refiner::flatPlaces(
  const TriMesh& mesh, const RefinePlan& plan, std::span<const Vec3> flat)
{
  std::vector<Vec3> places;
  reserveLarge(places, flat.size() + plan.cutHalf.size());
  places.assign(flat.begin(), flat.end());
  inBlocks(
    this->Run, plan.cutHalf.size(), [&](std::size_t size) { places.resize(flat.size() + size); },
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const HalfCorners ends = cornersOf(mesh, plan.cutHalf[i]);
        places[flat.size() + i] = (flat[ends.from] + flat[ends.to]) * 0.5;
      }
    });
  return places;
}

/// `to`, or what is allowed of the way there.
/// @param largest the square of the longest way so far
Vec3 Refiner::held(Index point, const Vec3& flat, const Vec3& to, double& largest)
{
  const double square = squaredLength(to - flat);
  if (square <= this->SafeSquare)
  {
    largest = std::max(largest, square);
    return to;
  }
  const Vec3 place = limitedMove(flat, to, this->Limit);
  this->IsHeld[point] = place != to ? 1 : this->IsHeld[point];
  largest = std::max(largest, squaredLength(place - flat));
  return place;
}

/// Where the old and the new points go by the rules of Loop.
std::vector<Vec3> Refiner::loopPlaces(
  const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan, const Surface& surface)
{
  const std::size_t old = mesh.points.size();
  const LoopRules rules(mesh, fans, surface.isChosen, surface.creases);
  const std::vector<Vec3>& flat = surface.flat.empty() ? mesh.points : surface.flat;
  const std::span<const std::uint8_t> halves = surface.halves;
  this->IsHeld.resize(old + plan.cutHalf.size(), 0);
  const auto isStraight = [&](Index half)
  {
    return !halves.empty() &&
      (cutsQuarter(plan, halves, half) || cutsQuarter(plan, halves, fans.next(half)));
  };
  std::atomic<double> largest = 0.0; // squared
  std::vector<Vec3> places;
  reserveLarge(places, this->IsHeld.size());
  const auto make = [&](std::size_t count, auto&& placeOf)
  {
    const std::size_t first = places.size();
    inBlocks(
      this->Run, count, [&](std::size_t size) { places.resize(first + size); },
      [&](std::size_t begin, std::size_t end)
      {
        double most = 0.0;
        for (std::size_t i = begin; i < end; ++i)
        {
          places[first + i] = placeOf(static_cast<Index>(i), most);
        }
        raise(largest, most);
      });
  };
  make(old,
    [&](Index point, double& most)
    { return this->held(point, flat[point], rules.pointAt(point), most); });
  make(plan.cutHalf.size(),
    [&](Index i, double& most)
    {
      const Index half = plan.cutHalf[i];
      const HalfCorners ends = cornersOf(mesh, half);
      const Vec3 to =
        isStraight(half) ? (places[ends.from] + places[ends.to]) * 0.5 : rules.middleAt(half);
      return this->held(
        static_cast<Index>(old) + i, (flat[ends.from] + flat[ends.to]) * 0.5, to, most);
    });
  this->Result.largestShift = std::sqrt(largest.load());
  return places;
}

void Refiner::cutTriangles(
  const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan, Surface& surface)
{
  const RefinedParts parts(mesh, fans, plan, surface.halves, surface.creases);
  LargeArray<Index> begins(mesh.triangles.size() + 1);
  begins[0] = 0;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    begins[t + 1] = begins[t] + parts.count(t);
  }
  const std::size_t count = begins.back();
  const bool hasHalves = !surface.halves.empty() || plan.cutInTwo > 0;
  const bool hasCreases = !surface.creases.empty();
  Surface cut;
  reserveLarge(cut.mesh.triangles, count);
  cut.isChosen.reserve(count);
  reserveLarge(cut.origin, count);
  cut.halves.reserve(hasHalves ? count : 0);
  cut.creases.reserve(hasCreases ? count : 0);
  const auto grow = [&](std::size_t triangles)
  {
    const Index size = begins[triangles];
    cut.mesh.triangles.resize(size);
    cut.isChosen.resize(size);
    cut.origin.resize(size);
    cut.halves.resize(hasHalves ? size : 0);
    cut.creases.resize(hasCreases ? size : 0);
  };
  inBlocks(this->Run, mesh.triangles.size(), grow,
    [&](std::size_t begin, std::size_t end)
    {
      // pointers of its own, which the compiler knows that writing bytes cannot change
      Triangle* const triangles = cut.mesh.triangles.data();
      Index* const origins = cut.origin.data();
      std::uint8_t* const isChosen = cut.isChosen.data();
      std::uint8_t* const halves = hasHalves ? cut.halves.data() : nullptr;
      std::uint8_t* const creases = hasCreases ? cut.creases.data() : nullptr;
      const Index* const origin = surface.origin.empty() ? nullptr : surface.origin.data();
      std::array<RefinedPart, RefinedParts::kMost> all;
      for (auto t = static_cast<Index>(begin); t < end; ++t)
      {
        const RefinedPart* const last = parts.write(t, all.data());
        Index place = begins[t];
        for (const RefinedPart* part = all.data(); part != last; ++part, ++place)
        {
          triangles[place] = part->corners;
          origins[place] = origin != nullptr ? origin[t] : t;
          isChosen[place] = surface.isChosen[t];
          if (halves != nullptr)
          {
            halves[place] = part->half;
          }
          if (creases != nullptr)
          {
            creases[place] = part->creases;
          }
        }
      }
    });
  cut.flat = std::move(surface.flat);
  surface = std::move(cut);
}

bool Refiner::refineOnce(const TriMesh& mesh, Surface& surface, bool isLast)
{
  const EdgeFans fans(mesh, this->Run);
  surface.halves = trustedHalves(mesh, surface.halves, fans.mates());
  if (surface.origin.empty() && this->isLoop()) // the first time
  {
    surface.creases = creasesOf(mesh, fans, this->Options.creaseAngle, this->Run);
  }
  const RefinePlan plan = planRefinement(mesh, fans, surface.isChosen, surface.halves);
  if (plan.cutHalf.empty())
  {
    return false;
  }
  this->Result.cutInFour += plan.cutInFour;
  this->Result.cutInTwo += plan.cutInTwo;
  this->Result.joined += plan.joined;
  this->recordJoins(mesh, fans, plan, surface.halves);
  this->blendMiddles(mesh, plan);
  std::vector<Vec3> points = this->isLoop() ? this->loopPlaces(mesh, fans, plan, surface)
                                            : this->flatPlaces(mesh, plan, mesh.points);
  if (this->isLoop() && !isLast)
  {
    surface.flat = this->flatPlaces(mesh, plan, surface.flat.empty() ? mesh.points : surface.flat);
  }
  this->cutTriangles(mesh, fans, plan, surface);
  surface.mesh.points = std::move(points);
  return true;
}

RefineResult Refiner::take(const TriMesh& input, Surface& surface)
{
  RefineResult& result = this->Result;
  SurfaceEdit& edit = result.edit;
  if (surface.origin.empty())
  {
    edit = unchanged(input);
  }
  else
  {
    edit.mesh = std::move(surface.mesh);
    edit.triangleOrigin = std::move(surface.origin);
    reserveLarge(edit.pointOrigin, edit.mesh.points.size());
    edit.pointOrigin.assign(edit.mesh.points.size(), kNone);
    std::iota(edit.pointOrigin.begin(),
      edit.pointOrigin.begin() + static_cast<std::ptrdiff_t>(input.points.size()), Index{ 0 });
    edit.blends = this->Blends.take();
  }
  result.halves = std::move(surface.halves);
  result.heldBack = static_cast<std::size_t>(std::ranges::count(this->IsHeld, 1));
  return std::move(result);
}

} // namespace

RefineResult refine(const TriMesh& mesh, std::span<const std::uint8_t> isChosen,
  std::span<const std::uint8_t> halves, const RefineOptions& options, Execution& execution)
{
  const auto times = static_cast<std::size_t>(options.times);
  execution.step("refine", 0, times);
  const auto chosen = static_cast<std::size_t>(std::ranges::count(isChosen, 1));
  requireRoom(mesh.triangles.size(), chosen, options.times);
  Refiner refiner(mesh, options, execution);
  Surface surface;
  surface.isChosen.assign(isChosen.begin(), isChosen.end());
  surface.halves.assign(halves.begin(), halves.end());
  for (std::size_t time = 0; time < times; ++time)
  {
    const TriMesh before = std::exchange(surface.mesh, {});
    if (!refiner.refineOnce(time == 0 ? mesh : before, surface, time + 1 == times))
    {
      break; // the first time: later, there is always something to refine
    }
    execution.step("refine", time + 1, times);
  }
  RefineResult result = refiner.take(mesh, surface);
  execution.step("refine", times, times);
  return result;
}

} // namespace scan
