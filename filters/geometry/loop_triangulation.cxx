// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/loop_triangulation.h"

#include "filters/geometry/local_plane.h"

#include <algorithm>
#include <limits>

namespace scan
{
namespace
{

constexpr std::size_t kWhole = 300;   // corners that are triangulated at once
constexpr std::size_t kSamples = 400; // corners that diagonals of a longer polygon are tried from
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A part of the loop: corners in order, and the normal beyond the edge behind each.
struct Part
{
  std::vector<Index> corners;
  std::vector<Vec3> normals;
};

/// The unit normal of a triangle; (0, 0, 0) where its height is next to nothing.
Vec3 normalOf(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 normal = cross(b - a, c - a);
  const double longest = std::max({ dot(b - a, b - a), dot(c - a, c - a), dot(c - b, c - b) });
  return length(normal) > 1e-9 * longest ? unitVector(normal) : Vec3{};
}

/// 0: flat, 2: folded back.
double foldOf(const Vec3& a, const Vec3& b)
{
  return a == Vec3{} || b == Vec3{} ? 0.0 : 1.0 - dot(a, b);
}

/// How good a triangulation is; less is better.
struct Weight
{
  double fold = 0.0;
  double area = 0.0;

  friend bool operator<(const Weight& a, const Weight& b)
  {
    return a.fold != b.fold ? a.fold < b.fold : a.area < b.area;
  }
};

/// Dynamic programming over the parts from corner i to corner j.
class PartTable
{
public:
  PartTable(const SpaceLoop& loop, const Part& part, LoopAim aim, const EdgeSet& taken)
    : Loop(loop)
    , P(part)
    , Aim(aim)
    , Taken(taken)
    , Count(part.corners.size())
    , Cells(this->Count * this->Count)
  {
  }

  bool fill(Execution& execution);
  void appendTriangles(std::vector<Triangle>& triangles) const;
  /// Of the triangle at the edge from the last corner to the first.
  Vec3 lastNormal() const { return this->Cells[this->Count - 1].normal; }

private:
  struct Cell
  {
    Weight best{ kInfinity, kInfinity };
    Index third = kNone;
    Vec3 normal; // of the triangle there
  };

  const Vec3& at(std::size_t i) const { return this->Loop.corners[this->P.corners[i]]; }
  Cell& cell(std::size_t i, std::size_t j) { return this->Cells[i * this->Count + j]; }
  void fillCell(std::size_t i, std::size_t j);

  const SpaceLoop& Loop;
  const Part& P;
  LoopAim Aim;
  const EdgeSet& Taken;
  std::size_t Count;
  std::vector<Cell> Cells;
};

void PartTable::fillCell(std::size_t i, std::size_t j)
{
  const bool isLast = i == 0 && j + 1 == this->Count;
  const auto nameOf = [&](std::size_t k) { return this->Loop.names[this->P.corners[k]]; };
  if (!isLast && this->Taken.contains(nameOf(i), nameOf(j)))
  {
    return;
  }
  Cell& cell = this->cell(i, j);
  for (std::size_t k = i + 1; k < j; ++k)
  {
    const Cell& left = this->cell(i, k);
    const Cell& right = this->cell(k, j);
    Weight weight{ std::max(left.best.fold, right.best.fold), left.best.area + right.best.area };
    if (weight.area == kInfinity || cell.best < weight)
    {
      continue;
    }
    const Vec3 normal = normalOf(this->at(i), this->at(k), this->at(j));
    if (normal == Vec3{})
    {
      continue;
    }
    weight.area += length(cross(this->at(k) - this->at(i), this->at(j) - this->at(i))) / 2.0;
    if (this->Aim == LoopAim::fold)
    {
      weight.fold = std::max({ weight.fold, foldOf(normal, left.normal),
        foldOf(normal, right.normal), isLast ? foldOf(normal, this->P.normals[j]) : 0.0 });
    }
    if (weight < cell.best)
    {
      cell = { weight, static_cast<Index>(k), normal };
    }
  }
}

bool PartTable::fill(Execution& execution)
{
  for (std::size_t i = 0; i + 1 < this->Count; ++i)
  {
    this->cell(i, i + 1) = { {}, kNone, this->P.normals[i] };
  }
  for (std::size_t span = 2; span < this->Count; ++span)
  {
    execution.step("", 0, 1); // for a cancel
    for (std::size_t i = 0; i + span < this->Count; ++i)
    {
      this->fillCell(i, i + span);
    }
  }
  return this->Cells[this->Count - 1].best.area < kInfinity;
}

void PartTable::appendTriangles(std::vector<Triangle>& triangles) const
{
  std::vector<std::pair<std::size_t, std::size_t>> open{ { 0, this->Count - 1 } };
  while (!open.empty())
  {
    const auto [i, j] = open.back();
    open.pop_back();
    const Index k = this->Cells[i * this->Count + j].third;
    if (k != kNone)
    {
      triangles.push_back({ this->P.corners[i], this->P.corners[k], this->P.corners[j] });
      open.emplace_back(i, k);
      open.emplace_back(k, j);
    }
  }
}

/// The two ends of the diagonal that is shortest for the length of rim that it cuts off.
std::optional<std::pair<std::size_t, std::size_t>> bestDiagonal(
  const SpaceLoop& loop, const Part& part, const EdgeSet& taken)
{
  const std::size_t count = part.corners.size();
  std::vector<double> along(count + 1, 0.0);
  const auto at = [&](std::size_t i) { return loop.corners[part.corners[i % count]]; };
  for (std::size_t i = 0; i < count; ++i)
  {
    along[i + 1] = along[i] + length(at(i + 1) - at(i));
  }
  const std::size_t stride = count / kSamples + 1;
  const std::size_t least = count / 8;
  std::optional<std::pair<std::size_t, std::size_t>> best;
  double bestRatio = kInfinity;
  for (std::size_t i = 0; i < count; i += stride)
  {
    for (std::size_t j = i + least; j < count && count - (j - i) >= least; j += stride)
    {
      const double cut = std::min(along[j] - along[i], along[count] - (along[j] - along[i]));
      const double ratio = cut > 0.0 ? length(at(j) - at(i)) / cut : kInfinity;
      if (ratio < bestRatio &&
        !taken.contains(loop.names[part.corners[i]], loop.names[part.corners[j]]))
      {
        bestRatio = ratio;
        best = std::pair(i, j);
      }
    }
  }
  return best;
}

class Triangulator
{
public:
  Triangulator(const SpaceLoop& loop, LoopAim aim, const EdgeSet& taken, Execution& execution)
    : Loop(loop)
    , Aim(aim)
    , Taken(taken)
    , Run(execution)
  {
  }

  /// Appends the triangles of a part. Returns the normal of the one at its last edge.
  std::optional<Vec3> span(const Part& part);

  std::vector<Triangle> Triangles;

private:
  const SpaceLoop& Loop;
  LoopAim Aim;
  const EdgeSet& Taken;
  Execution& Run;
};

std::optional<Vec3> Triangulator::span(const Part& part)
{
  if (part.corners.size() <= kWhole)
  {
    PartTable table(this->Loop, part, this->Aim, this->Taken);
    if (!table.fill(this->Run))
    {
      return std::nullopt;
    }
    table.appendTriangles(this->Triangles);
    return table.lastNormal();
  }
  const auto diagonal = bestDiagonal(this->Loop, part, this->Taken);
  if (!diagonal)
  {
    return std::nullopt;
  }
  const auto first = static_cast<std::ptrdiff_t>(diagonal->first);
  const auto second = static_cast<std::ptrdiff_t>(diagonal->second);
  const auto cutOff = [&](const auto& all, auto&& last) // from the first end to the second
  {
    std::vector<std::decay_t<decltype(last)>> some(all.begin() + first, all.begin() + second);
    some.push_back(last);
    return some;
  };
  const auto rest = [&](const auto& all, auto&& at) // the others, with what is at the diagonal
  {
    std::vector<std::decay_t<decltype(at)>> some(all.begin(), all.begin() + first);
    some.push_back(at);
    some.insert(some.end(), all.begin() + second, all.end());
    return some;
  };
  const auto normal = this->span(
    { cutOff(part.corners, part.corners[diagonal->second]), cutOff(part.normals, Vec3{}) });
  if (!normal)
  {
    return std::nullopt;
  }
  return this->span(
    { rest(part.corners, part.corners[diagonal->first]), rest(part.normals, *normal) });
}

} // namespace

std::optional<std::vector<Triangle>> triangulateLoop(
  const SpaceLoop& loop, LoopAim aim, const EdgeSet& taken, Execution& execution)
{
  Part all;
  for (Index i = 0; i < loop.corners.size(); ++i)
  {
    all.corners.push_back(i);
  }
  all.normals = loop.normals;
  Triangulator triangulator(loop, aim, taken, execution);
  if (all.corners.size() < 3 || !triangulator.span(all))
  {
    return std::nullopt;
  }
  return std::move(triangulator.Triangles);
}

} // namespace scan
