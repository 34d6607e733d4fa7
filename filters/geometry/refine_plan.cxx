// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/refine_plan.h"

#include <algorithm>

namespace scan
{
namespace
{

constexpr Index kUnnumbered = kNone - 1; // of a new point

/// Cuts triangles, and what must be cut then, until no point is inside an edge.
class Planner
{
public:
  Planner(const TriMesh& mesh, const EdgeFans& fans, std::span<const std::uint8_t> halves,
    RefinePlan& plan)
    : Mesh(mesh)
    , Fans(fans)
    , Halves(halves)
    , Plan(plan)
  {
  }

  void refine(Index triangle)
  {
    this->cut(triangle);
    while (!this->Touched.empty())
    {
      const Index touched = this->Touched.back();
      this->Touched.pop_back();
      if (this->isHalf(touched) || this->cutEdgesOf(touched) > 1)
      {
        this->cut(touched);
      }
    }
  }

  int cutEdgesOf(Index triangle) const
  {
    int count = 0;
    for (Index k = 0; k < 3; ++k)
    {
      count += this->Plan.middles[3 * triangle + k] != kNone ? 1 : 0;
    }
    return count;
  }

private:
  bool isHalf(Index triangle) const { return !this->Halves.empty() && this->Halves[triangle] != 0; }

  void cut(Index triangle)
  {
    if (this->Plan.cuts[triangle] != RefinePlan::Cut::none ||
      isCollapsed(this->Mesh.triangles[triangle]))
    {
      return;
    }
    if (this->isHalf(triangle))
    {
      const Index seam = seamOf(triangle, this->Halves[triangle]);
      const Index twin = this->Fans.mate(seam) / 3;
      for (const Index half : { triangle, twin })
      {
        this->Plan.cuts[half] = RefinePlan::Cut::join;
        this->cutEdge(3 * half + (middleOf(this->Halves[half]) + 1) % 3);
      }
      return;
    }
    this->Plan.cuts[triangle] = RefinePlan::Cut::four;
    for (Index k = 0; k < 3; ++k)
    {
      this->cutEdge(3 * triangle + k);
    }
  }

  void cutEdge(Index half)
  {
    while (this->Plan.middles[half] == kNone)
    {
      this->Plan.middles[half] = kUnnumbered;
      this->Touched.push_back(half / 3);
      half = this->Fans.next(half);
    }
  }

  const TriMesh& Mesh;
  const EdgeFans& Fans;
  std::span<const std::uint8_t> Halves;
  RefinePlan& Plan;
  std::vector<Index> Touched; // triangles with an edge that was cut
};

/// Numbers the new points in the order of their half-edges.
void numberMiddles(const EdgeFans& fans, RefinePlan& plan)
{
  plan.cutHalf.reserve(plan.middles.size() / 2);
  for (Index half = 0; half < plan.middles.size(); ++half)
  {
    if (plan.middles[half] == kUnnumbered)
    {
      const auto number = static_cast<Index>(plan.cutHalf.size());
      plan.cutHalf.push_back(half);
      for (Index same = half; plan.middles[same] == kUnnumbered; same = fans.next(same))
      {
        plan.middles[same] = number;
      }
    }
  }
}

/// Everything is chosen and there are no halves.
void cutAll(const TriMesh& mesh, RefinePlan& plan)
{
  for (Index t = 0; t < plan.cuts.size(); ++t)
  {
    const bool stays = isCollapsed(mesh.triangles[t]);
    plan.cuts[t] = stays ? RefinePlan::Cut::none : RefinePlan::Cut::four;
    std::fill_n(plan.middles.begin() + 3 * std::ptrdiff_t{ t }, 3, stays ? kNone : kUnnumbered);
  }
}

void count(RefinePlan& plan)
{
  const auto number = [&](RefinePlan::Cut cut)
  { return static_cast<std::size_t>(std::ranges::count(plan.cuts, cut)); };
  plan.joined = number(RefinePlan::Cut::join) / 2;
  plan.cutInFour = number(RefinePlan::Cut::four) + plan.joined;
  plan.cutInTwo += number(RefinePlan::Cut::two);
}

} // namespace

EdgeFans::EdgeFans(const TriMesh& mesh, Execution& execution)
  : Pairs(pairEdges(mesh, execution))
{
  const auto& crowded = this->Pairs.crowded;
  const auto& begins = this->Pairs.crowdedBegin;
  if (crowded.empty())
  {
    return;
  }
  this->Crowded.resize(this->Pairs.mate.size());
  for (Index half = 0; half < this->Crowded.size(); ++half)
  {
    this->Crowded[half] = half;
  }
  for (std::size_t edge = 0; edge + 1 < begins.size(); ++edge)
  {
    for (Index i = begins[edge]; i < begins[edge + 1]; ++i)
    {
      this->Crowded[crowded[i]] = crowded[i + 1 < begins[edge + 1] ? i + 1 : begins[edge]];
    }
  }
}

RefinePlan planRefinement(const TriMesh& mesh, const EdgeFans& fans,
  std::span<const std::uint8_t> isChosen, std::span<const std::uint8_t> halves)
{
  RefinePlan plan;
  plan.cuts.resize(mesh.triangles.size(), RefinePlan::Cut::none);
  plan.middles.resize(3 * mesh.triangles.size());
  if (halves.empty() && std::ranges::find(isChosen, 0) == isChosen.end())
  {
    cutAll(mesh, plan);
  }
  else
  {
    std::ranges::fill(plan.middles, kNone);
    Planner planner(mesh, fans, halves, plan);
    for (Index t = 0; t < plan.cuts.size(); ++t)
    {
      if (isChosen[t] != 0)
      {
        planner.refine(t);
      }
    }
    for (Index t = 0; t < plan.cuts.size(); ++t)
    {
      if (plan.cuts[t] == RefinePlan::Cut::none && planner.cutEdgesOf(t) == 1)
      {
        plan.cuts[t] = RefinePlan::Cut::two;
      }
      // a half of the edge that the whole was cut at may be cut, and a quarter with it
      plan.cutInTwo += plan.cuts[t] == RefinePlan::Cut::join ? planner.cutEdgesOf(t) - 1 : 0;
    }
  }
  numberMiddles(fans, plan);
  count(plan);
  return plan;
}

RefinedParts::RefinedParts(const TriMesh& mesh, const EdgeFans& fans, const RefinePlan& plan,
  std::span<const std::uint8_t> halves, std::span<const std::uint8_t> creases)
  : Mesh(mesh)
  , Fans(fans)
  , Plan(plan)
  , Halves(halves)
  , Creases(creases)
{
}

namespace
{

/// Bit `to` of the result is bit `from` of the creases.
std::uint8_t moved(std::uint8_t creases, Index from, Index to)
{
  return static_cast<std::uint8_t>(((creases >> from) & 1U) << to);
}

/// Writes the halves of a triangle that is cut at the middle of its edge from corner k.
RefinedPart* writeHalves(
  const Triangle& corners, std::uint8_t creases, Index k, Index middle, RefinedPart* parts)
{
  const Index b = (k + 1) % 3;
  const Index c = (k + 2) % 3;
  RefinedPart& first = *parts++;
  first = { corners, halfMark(b, false),
    static_cast<std::uint8_t>(moved(creases, k, k) | moved(creases, c, c)) };
  first.corners[b] = middle;
  RefinedPart& second = *parts++;
  second = { corners, halfMark(k, true),
    static_cast<std::uint8_t>(moved(creases, k, k) | moved(creases, b, b)) };
  second.corners[k] = middle;
  return parts;
}

} // namespace

unsigned RefinedParts::count(Index triangle) const
{
  switch (this->Plan.cuts[triangle])
  {
    case RefinePlan::Cut::none:
      return 1;
    case RefinePlan::Cut::two:
      return 2;
    case RefinePlan::Cut::four:
      return 4;
    case RefinePlan::Cut::join:
      break;
  }
  const Index k = middleOf(this->halfOf(triangle)) + (isSecondHalf(this->halfOf(triangle)) ? 0 : 2);
  return this->Plan.middles[3 * triangle + k % 3] == kNone ? 2 : 3;
}

RefinedPart* RefinedParts::write(Index triangle, RefinedPart* parts) const
{
  switch (this->Plan.cuts[triangle])
  {
    case RefinePlan::Cut::four:
      return this->writeFour(triangle, parts);
    case RefinePlan::Cut::two:
      return this->writeTwo(triangle, parts);
    case RefinePlan::Cut::join:
      return this->writeJoined(triangle, parts);
    case RefinePlan::Cut::none:
      break;
  }
  *parts++ = { this->Mesh.triangles[triangle], this->halfOf(triangle), this->creasesOf(triangle) };
  return parts;
}

RefinedPart* RefinedParts::writeFour(Index triangle, RefinedPart* parts) const
{
  const auto& [a, b, c] = this->Mesh.triangles[triangle];
  const Index ab = this->middle(3 * triangle);
  const Index bc = this->middle(3 * triangle + 1);
  const Index ca = this->middle(3 * triangle + 2);
  const unsigned creases = this->creasesOf(triangle);
  *parts++ = { { a, ab, ca }, 0, static_cast<std::uint8_t>(creases & 5U) };
  *parts++ = { { ab, b, bc }, 0, static_cast<std::uint8_t>(creases & 3U) };
  *parts++ = { { ca, bc, c }, 0, static_cast<std::uint8_t>(creases & 6U) };
  *parts++ = { { ab, bc, ca }, 0, 0 };
  return parts;
}

RefinedPart* RefinedParts::writeTwo(Index triangle, RefinedPart* parts) const
{
  Index k = 0;
  while (this->Plan.middles[3 * triangle + k] == kNone)
  {
    ++k;
  }
  return writeHalves(this->Mesh.triangles[triangle], this->creasesOf(triangle), k,
    this->middle(3 * triangle + k), parts);
}

/// Of the four parts of the whole (a, b, c) the first half writes those at a and c, the second
/// those at b and in the middle. The part at a, or b, may be cut in two.
RefinedPart* RefinedParts::writeJoined(Index triangle, RefinedPart* parts) const
{
  const std::uint8_t mark = this->halfOf(triangle);
  const Triangle& corners = this->Mesh.triangles[triangle];
  const Index k = middleOf(mark);
  const Index next = (k + 1) % 3;
  const Index last = (k + 2) % 3;
  const Index middle = corners[k];
  const std::uint8_t creases = this->creasesOf(triangle);
  const Index own = this->middle(3 * triangle + next);
  const Index seam = this->Fans.mate(seamOf(triangle, mark));
  const Index twin = seam / 3;
  const Index other = this->middle(3 * twin + (middleOf(this->halfOf(twin)) + 1) % 3);
  // (a, middle, own) or (middle, b, own), beginning with the middle
  const bool isSecond = isSecondHalf(mark);
  const Index outer = isSecond ? k : last; // the edge that may be cut, and its place in the part
  const Triangle quarter =
    isSecond ? Triangle{ middle, corners[next], own } : Triangle{ middle, own, corners[last] };
  const Index place = isSecond ? 0 : 2;
  const auto quarterCreases =
    static_cast<std::uint8_t>(moved(creases, outer, place) | moved(creases, next, 1));
  if (this->Plan.middles[3 * triangle + outer] == kNone)
  {
    *parts++ = { quarter, 0, quarterCreases };
  }
  else
  {
    parts = writeHalves(quarter, quarterCreases, place, this->middle(3 * triangle + outer), parts);
  }
  if (isSecond)
  {
    *parts++ = { { middle, own, other }, 0, 0 };
  }
  else
  {
    const Index c = corners[next];
    const std::uint8_t twinCreases = this->creasesOf(twin);
    const Index twinEdge = (middleOf(this->halfOf(twin)) + 1) % 3;
    *parts++ = { { c, own, other }, 0,
      static_cast<std::uint8_t>(moved(creases, next, 0) | moved(twinCreases, twinEdge, 2)) };
  }
  return parts;
}

} // namespace scan
