// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/quadric_decimation.h"

#include "filters/geometry/local_plane.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace scan
{

namespace
{

/// Of all edges, how many a sweep reaches: the square of the share that has to go, within these.
/// The last sweeps decide how large the largest error is; fine ones cost little there.
constexpr double kLeastSweep = 0.01;
constexpr double kLargestSweep = 0.08;

/// Of planes across boundaries, by the squared length of the edge: a line has less weight than the
/// surface beside it, but is seen as clearly.
constexpr double kBoundaryWeight = 2.0;

/// How far the best place may be from the middle of an edge, squared, as a multiple of its length.
constexpr double kFarthest = 1.0;

/// How much the length of an edge adds to its cost, so that planes are thinned evenly.
constexpr double kLengthShare = 1e-7;

/// How far surfaces may be apart, as a multiple of the mean distance.
constexpr double kLoss = 3.0;

/// Normals of triangles turn by 78 degrees at most.
constexpr double kLeastCosine = 0.2;

/// Triangles lower than that share of their longest side do not get worse.
constexpr double kLeastHeight = 0.02;

} // namespace

QuadricDecimation::QuadricDecimation(const TriMesh& mesh, std::span<const std::uint8_t> isFixed,
  double creaseAngle, Execution& execution)
  : costLimits(mesh.points.size(), kNever)
  , Mesh(mesh, execution)
  , IsFixed(isFixed.begin(), isFixed.end())
  , Quadrics(mesh.points.size())
  , EdgeCosts(3 * mesh.triangles.size(), kNever)
  , Costs(mesh.points.size(), 0.0F)
  , Into(mesh.points.size())
  , TriangleNames(mesh.triangles.size())
{
  std::iota(this->Into.begin(), this->Into.end(), Index{ 0 });
  std::iota(this->TriangleNames.begin(), this->TriangleNames.end(), Index{ 0 });
  for (std::size_t point = 0; point < this->IsFixed.size(); ++point)
  {
    this->IsFixed[point] |= this->Mesh.isSingular[point];
  }
  this->addPlanes(creaseAngle);
}

void QuadricDecimation::addPlanes(double creaseAngle)
{
  const double creaseCosine = std::cos(creaseAngle * std::numbers::pi / 180.0);
  const auto& corner = this->Mesh.corner;
  for (Index half = 0; half < corner.size(); half += 3)
  {
    const Vec3& a = this->Mesh.points[corner[half]];
    const Vec3& b = this->Mesh.points[corner[half + 1]];
    const Vec3& c = this->Mesh.points[corner[half + 2]];
    const Vec3 normal = cross(b - a, c - a);
    const double doubleArea = length(normal);
    if (!(doubleArea > 0.0))
    {
      continue;
    }
    const Vec3 unit = normal * (1.0 / doubleArea);
    const Quadric plane = Quadric::plane(unit, a, doubleArea / 2.0);
    for (Index k = 0; k < 3; ++k)
    {
      this->Quadrics[corner[half + k]] += plane;
      this->addPlanesAcross(half + k, unit, creaseCosine);
    }
  }
}

/// At a boundary or crease, the plane through the edge that stands on its triangle.
void QuadricDecimation::addPlanesAcross(Index half, const Vec3& normal, double creaseCosine)
{
  const Vec3& a = this->Mesh.points[this->Mesh.from(half)];
  const Vec3& b = this->Mesh.points[this->Mesh.to(half)];
  const Index other = this->Mesh.mate[half];
  const double weight = other == kNone ? kBoundaryWeight : 1.0;
  if (other != kNone)
  {
    const Vec3& apex = this->Mesh.points[this->Mesh.from(previousHalf(other))];
    const Vec3 otherNormal = cross(a - b, apex - b);
    if (!(dot(normal, otherNormal) < creaseCosine * length(otherNormal)))
    {
      return;
    }
  }
  const Vec3 edge = b - a;
  const Vec3 across = cross(edge, normal);
  if (const double size = length(across); size > 0.0)
  {
    const Quadric plane = Quadric::plane(across * (1.0 / size), a, weight * dot(edge, edge));
    this->Quadrics[this->Mesh.from(half)] += plane;
    this->Quadrics[this->Mesh.to(half)] += plane;
  }
}

Vec3 QuadricDecimation::bestPlace(
  const Quadric& sum, const Vec3& a, const Vec3& b, Quadric::Precision precision) const
{
  const Vec3 middle = (a + b) * 0.5;
  const Vec3 best = sum.least(middle, precision);
  const Vec3 edge = b - a;
  const Vec3 away = best - middle;
  if (dot(away, away) <= kFarthest * dot(edge, edge))
  {
    return best;
  }
  return std::min({ middle, a, b },
    [&](const Vec3& left, const Vec3& right) { return sum.at(left) < sum.at(right); });
}

QuadricDecimation::Contraction QuadricDecimation::contraction(
  Index half, Quadric::Precision precision) const
{
  const Index u = this->Mesh.from(half);
  const Index v = this->Mesh.to(half);
  if (this->IsFixed[u] != 0 && this->IsFixed[v] != 0)
  {
    return {};
  }
  if (this->Mesh.isSingular[u] != 0 || this->Mesh.isSingular[v] != 0)
  {
    return {};
  }
  const Vec3& a = this->Mesh.points[u];
  const Vec3& b = this->Mesh.points[v];
  const bool isAtU = this->Mesh.isBoundary(u) && !this->Mesh.isBoundary(v);
  const bool isAtV = this->Mesh.isBoundary(v) && !this->Mesh.isBoundary(u);
  if ((isAtU && this->IsFixed[v] != 0) || (isAtV && this->IsFixed[u] != 0))
  {
    return {};
  }
  Quadric sum = this->Quadrics[u];
  sum += this->Quadrics[v];
  Contraction result;
  result.weight = sum.weight();
  result.place = isAtU || this->IsFixed[u] != 0 ? a
    : isAtV || this->IsFixed[v] != 0            ? b
                                                : this->bestPlace(sum, a, b, precision);
  const Vec3 edge = b - a;
  const double fromPlanes = std::max(sum.at(result.place), 0.0);
  const double squares = fromPlanes + kLengthShare * result.weight * dot(edge, edge);
  const double squaredDistance = result.weight > 0.0 ? squares / result.weight : 0.0;
  const auto cost = static_cast<float>(squares * std::sqrt(squaredDistance));
  if (cost <= std::min(this->costLimits[u], this->costLimits[v]) &&
    fromPlanes <= this->MeanDistance * this->MeanDistance * result.weight)
  {
    result.cost = cost;
  }
  return result;
}

bool QuadricDecimation::keepsShapes(Index half, const Vec3& place) const
{
  const Index u = this->Mesh.from(half);
  const Index v = this->Mesh.to(half);
  const auto longest = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::max({ dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c) });
  };
  bool isFine = true;
  for (const Index end : { u, v })
  {
    this->Mesh.forEachOut(end,
      [&](Index out)
      {
        const Index first = this->Mesh.to(out);
        const Index second = this->Mesh.from(previousHalf(out));
        if (!isFine || first == u || first == v || second == u || second == v)
        {
          return;
        }
        __builtin_prefetch(&this->Quadrics[first]); // for updateCosts()
        const Vec3& a = this->Mesh.points[first];
        const Vec3& b = this->Mesh.points[second];
        const Vec3& old = this->Mesh.points[end];
        const Vec3 before = cross(a - old, b - old);
        const Vec3 after = cross(a - place, b - place);
        const double both = dot(before, after);
        const double beforeSquared = dot(before, before);
        const double afterSquared = dot(after, after);
        isFine =
          both > 0.0 && both * both > kLeastCosine * kLeastCosine * beforeSquared * afterSquared;
        const double side = longest(place, a, b);
        if (isFine && afterSquared < kLeastHeight * kLeastHeight * side * side)
        {
          const double oldSide = longest(old, a, b);
          isFine = afterSquared * oldSide * oldSide >= beforeSquared * side * side;
        }
      });
  }
  return isFine;
}

/// How far the ends of an edge are from the triangles that its contraction leaves around them, or
/// the place from the planes of those that it moves, the largest squared; an answer up to `enough`
/// may be too large. The mean over planes does not tell that one is far: the new edge beside it
/// would cut across.
double QuadricDecimation::squaredLoss(Index half, const Vec3& place, double enough) const
{
  const Index u = this->Mesh.from(half);
  const Index v = this->Mesh.to(half);
  double loss = 0.0;
  for (const Index end : { u, v })
  {
    const Vec3& p = this->Mesh.points[end];
    double least = dot(p - place, p - place);
    for (const Index near : { end, end == u ? v : u })
    {
      if (least <= enough)
      {
        break;
      }
      this->Mesh.forEachOut(near,
        [&](Index out)
        {
          const Index a = this->Mesh.to(out);
          const Index b = this->Mesh.from(previousHalf(out));
          if (least > enough && a != u && a != v && b != u && b != v)
          {
            least = std::min(
              least, squaredDistance(p, place, this->Mesh.points[a], this->Mesh.points[b]));
          }
        });
    }
    loss = std::max(loss, least);
    this->Mesh.forEachOut(end,
      [&](Index out)
      {
        const Index a = this->Mesh.to(out);
        const Index b = this->Mesh.from(previousHalf(out));
        const Vec3 normal = cross(this->Mesh.points[a] - p, this->Mesh.points[b] - p);
        const double height = dot(normal, place - p);
        if (a != u && a != v && b != u && b != v && dot(normal, normal) > 0.0)
        {
          loss = std::max(loss, height * height / dot(normal, normal));
        }
      });
  }
  return loss;
}

/// Contracts an edge if it may; else says what it costs from now on.
float QuadricDecimation::tryContraction(Index half, float threshold)
{
  const Contraction found = this->contraction(half, Quadric::Precision::fine);
  if (found.cost == kNever || !this->Mesh.keepsTopology(half) ||
    !this->keepsShapes(half, found.place))
  {
    return kNever;
  }
  // w d^3 = threshold: the distance that belongs to it
  const double distance = kLoss * std::cbrt(double{ threshold } / found.weight);
  const double enough = found.weight > 0.0 ? distance * distance : 0.0;
  if (const double loss = this->squaredLoss(half, found.place, enough); loss > enough)
  {
    const double mean = std::sqrt(loss) / kLoss;
    return std::max(
      static_cast<float>(found.weight * mean * mean * mean), std::nextafter(threshold, kNever));
  }
  this->contract(half, found);
  return 0.0F;
}

void QuadricDecimation::contract(Index half, const Contraction& contraction)
{
  const Index u = this->Mesh.from(half);
  const Index v = this->Mesh.to(half);
  for (const Index side : { half, this->Mesh.mate[half] })
  {
    if (side != kNone)
    {
      std::fill_n(this->EdgeCosts.begin() + (side - side % 3), 3, kNever);
    }
  }
  this->Mesh.contract(half);
  this->Mesh.points[v] = contraction.place;
  this->Quadrics[v] += this->Quadrics[u];
  this->IsFixed[v] |= this->IsFixed[u];
  this->costLimits[v] = std::min(this->costLimits[u], this->costLimits[v]);
  this->Costs[v] = std::max({ this->Costs[u], this->Costs[v], contraction.cost });
  this->Into[u] = v;
  this->updateCosts(v);
}

void QuadricDecimation::updateCosts(Index point)
{
  const auto update = [&](Index half)
  {
    const Index other = this->Mesh.mate[half];
    const Index first = std::min(half, other); // kNone is the largest number
    this->EdgeCosts[first] = this->contraction(first, Quadric::Precision::rough).cost;
    if (other != kNone)
    {
      this->EdgeCosts[std::max(half, other)] = kNever;
    }
  };
  Index last = kNone;
  this->Mesh.forEachOut(point,
    [&](Index out)
    {
      update(out);
      last = out;
    });
  if (const Index closing = previousHalf(last); this->Mesh.mate[closing] == kNone)
  {
    update(closing);
  }
}

/// The cost up to which the next sweep contracts: few edges, and not more than are needed.
/// kNever when there is no edge left.
float QuadricDecimation::threshold(std::size_t triangles)
{
  constexpr std::size_t kSampleSize = 1 << 16;
  const std::size_t stride = std::max<std::size_t>(1, this->EdgeCosts.size() / kSampleSize);
  const auto take = [&](std::size_t every)
  {
    this->Sample.clear();
    for (std::size_t i = 0; i < this->EdgeCosts.size(); i += every)
    {
      if (this->EdgeCosts[i] < kNever)
      {
        this->Sample.push_back(this->EdgeCosts[i]);
      }
    }
  };
  take(stride);
  double edges = static_cast<double>(this->Sample.size() * stride);
  if (this->Sample.empty())
  {
    take(1);
    edges = static_cast<double>(this->Sample.size());
  }
  if (this->Sample.empty())
  {
    return kNever;
  }
  const double needed = static_cast<double>(this->Mesh.triangles - triangles + 1) / 2.0;
  const double toGo = needed / edges;
  const double share = std::min(toGo, std::clamp(toGo * toGo, kLeastSweep, kLargestSweep));
  const auto place = this->Sample.begin() +
    static_cast<std::ptrdiff_t>(share * static_cast<double>(this->Sample.size() - 1));
  std::nth_element(this->Sample.begin(), place, this->Sample.end());
  return *place;
}

void QuadricDecimation::sweep(float threshold, std::size_t triangles, Execution& execution)
{
  constexpr std::size_t kHalvesToPoll = 1 << 16;
  // edges wait a little until what they need is fetched
  std::array<Index, 8> waiting;
  waiting.fill(kNone);
  std::size_t found = 0;
  const auto contractOne = [&](Index half)
  {
    if (half != kNone && this->EdgeCosts[half] <= threshold && this->Mesh.triangles > triangles)
    {
      if (const float cost = this->tryContraction(half, threshold); cost > 0.0F)
      {
        this->EdgeCosts[half] = cost;
      }
    }
  };
  for (Index half = 0; half < this->EdgeCosts.size() && this->Mesh.triangles > triangles; ++half)
  {
    if (half % kHalvesToPoll == 0 && execution.cancelled())
    {
      break;
    }
    if (this->EdgeCosts[half] <= threshold)
    {
      this->fetch(half);
      contractOne(std::exchange(waiting[found++ % waiting.size()], half));
    }
  }
  for (std::size_t i = 0; i < waiting.size(); ++i)
  {
    contractOne(waiting[(found + i) % waiting.size()]);
  }
}

/// Has memory bring what the contraction of an edge begins with.
void QuadricDecimation::fetch(Index half) const
{
  __builtin_prefetch(&this->Mesh.mate[half]);
  for (const Index end : { this->Mesh.from(half), this->Mesh.to(half) })
  {
    __builtin_prefetch(&this->Quadrics[end]);
    __builtin_prefetch(&this->Mesh.points[end]);
    __builtin_prefetch(&this->Mesh.out[end]);
  }
}

void QuadricDecimation::run(std::size_t triangles, double meanDistance, Execution& execution)
{
  this->MeanDistance = meanDistance;
  execution.parallelFor(this->EdgeCosts.size(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto half = static_cast<Index>(begin); half < end; ++half)
      {
        if (half < this->Mesh.mate[half])
        {
          this->EdgeCosts[half] = this->contraction(half, Quadric::Precision::rough).cost;
        }
      }
    });
  const std::size_t all = this->Mesh.triangles;
  const std::size_t given = this->thresholds.size();
  for (std::size_t i = 0; this->Mesh.triangles > triangles; ++i)
  {
    execution.step("decimate", all - this->Mesh.triangles, all - triangles);
    if (given == 0)
    {
      const float next = this->threshold(triangles);
      if (next == kNever)
      {
        break;
      }
      this->thresholds.push_back(next);
    }
    const std::size_t before = this->Mesh.triangles;
    this->sweep(this->thresholds[std::min(i, this->thresholds.size() - 1)], triangles, execution);
    if (given > 0 && i >= given && this->Mesh.triangles == before)
    {
      break;
    }
    if (this->Mesh.triangles * 2 < this->Mesh.corner.size() / 3)
    {
      this->compact();
    }
  }
  this->compact();
}

void QuadricDecimation::compact()
{
  this->Mesh.compact(
    [&](Index from, Index to)
    {
      std::copy_n(this->EdgeCosts.begin() + 3 * std::ptrdiff_t{ from }, 3,
        this->EdgeCosts.begin() + 3 * std::ptrdiff_t{ to });
      this->TriangleNames[to] = this->TriangleNames[from];
    });
  this->EdgeCosts.resize(this->Mesh.corner.size());
  this->TriangleNames.resize(this->Mesh.corner.size() / 3);
}

Index QuadricDecimation::survivorOf(Index point)
{
  while (this->Into[point] != point)
  {
    this->Into[point] = this->Into[this->Into[point]];
    point = this->Into[point];
  }
  return point;
}

} // namespace scan
