// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/point_normals.h"

#include "filters/geometry/local_plane.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace scan
{
namespace
{

constexpr std::size_t kLinks = 10; // neighbours that a place is oriented with, itself included
constexpr std::size_t kRanks = 1U << 16U;
constexpr std::size_t kCheck = 1U << 16U; // steps between checks for cancel

/// A plane of a place, with the area that the place stands for.
struct Place
{
  Vec3 normal;
  double area = 0.0;
};

/// Two places that are to agree.
struct Link
{
  Index a = 0;
  Index b = 0;
  bool isTurned = false; // whether the normals agree when one is turned
};

/// How two normals agree.
struct Agreement
{
  double cosine; // between one and the mirror image of the other
  double doubt;  // 0 to 1
};

Agreement agreement(const Vec3& normalA, const Vec3& normalB, const Vec3& between)
{
  const Vec3 way = unitVector(between);
  const double alongA = dot(normalA, way);
  const double alongB = dot(normalB, way);
  const double cosine = dot(normalA, normalB) - 2.0 * alongA * alongB;
  // noise makes ways that leave the surface: those along it are surer
  const double steepness = 0.5 * (std::abs(alongA) + std::abs(alongB));
  return { cosine, std::clamp(0.5 * (1.0 - std::abs(cosine) + steepness), 0.0, 1.0) };
}

/// Normals that agree with each other, part by part.
class Orientation
{
public:
  Orientation(const Neighbours& all, std::vector<Place>& planes, Execution& execution)
    : Places(all)
    , Planes(planes)
    , Run(execution)
    , Parent(all.size())
    , IsTurned(all.size(), 0)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), Index{ 0 });
  }

  void agree();
  void turnOutward(PointNormalResult& result);

private:
  std::vector<Link> linksSurestFirst();

  /// The root of the place, and whether the place is turned against it.
  std::pair<Index, bool> find(Index place)
  {
    Index root = place;
    bool isTurned = false;
    while (this->Parent[root] != root)
    {
      isTurned ^= this->IsTurned[root] != 0;
      root = this->Parent[root];
    }
    bool rest = isTurned;
    while (this->Parent[place] != root && place != root)
    {
      const bool own = this->IsTurned[place] != 0;
      const Index next = this->Parent[place];
      this->Parent[place] = root;
      this->IsTurned[place] = rest ? 1 : 0;
      rest ^= own;
      place = next;
    }
    return { root, isTurned };
  }

  const Neighbours& Places;
  std::vector<Place>& Planes;
  Execution& Run;
  std::vector<Index> Parent;
  std::vector<std::uint8_t> IsTurned; // against the parent
};

std::vector<Link> Orientation::linksSurestFirst()
{
  const std::size_t count = this->Places.size();
  std::vector<Link> links(count * kLinks);
  std::vector<std::uint16_t> ranks(links.size());
  parallelSteps(this->Run, { "orient", 0, 2 }, count,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto place = static_cast<Index>(i);
        this->Places.nearest(this->Places[place], kLinks, found);
        for (std::size_t n = 0; n < found.size(); ++n)
        {
          const Index other = found[n].place;
          const Vec3& normal = this->Planes[i].normal;
          if (other == place || normal == Vec3{} || this->Planes[other].normal == Vec3{})
          {
            continue;
          }
          const auto [cosine, doubt] = agreement(
            normal, this->Planes[other].normal, this->Places[other] - this->Places[place]);
          links[i * kLinks + n] = { place, other, cosine < 0.0 };
          ranks[i * kLinks + n] =
            static_cast<std::uint16_t>(doubt * static_cast<double>(kRanks - 1));
        }
      }
    });
  // a counting sort keeps links of the same rank in the order of the places
  std::vector<std::size_t> ends(kRanks + 1, 0);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    ends[ranks[i] + 1U] += links[i].a != links[i].b ? 1 : 0;
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Link> sorted(ends.back());
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    if (links[i].a != links[i].b)
    {
      sorted[ends[ranks[i]]++] = links[i];
    }
  }
  return sorted;
}

void Orientation::agree()
{
  const std::vector<Link> links = this->linksSurestFirst();
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    if (i % kCheck == 0)
    {
      this->Run.step("orient", links.size() + i, 2 * links.size());
    }
    const auto [rootA, isTurnedA] = this->find(links[i].a);
    const auto [rootB, isTurnedB] = this->find(links[i].b);
    if (rootA != rootB)
    {
      const Index child = std::max(rootA, rootB);
      this->Parent[child] = std::min(rootA, rootB);
      this->IsTurned[child] = (isTurnedA ^ isTurnedB ^ links[i].isTurned) ? 1 : 0;
    }
  }
  for (Index place = 0; place < this->Places.size(); ++place)
  {
    if (this->find(place).second)
    {
      this->Planes[place].normal = this->Planes[place].normal * -1.0;
    }
  }
}

void Orientation::turnOutward(PointNormalResult& result)
{
  constexpr double kThin = 0.1; // volume by area and size: below it there may be no inside
  constexpr double kOpen = 0.3; // of the area faces one way: there is none
  struct Part
  {
    double area = 0.0;
    Vec3 middle; // times area
    Vec3 facing; // the sum of normals times area, 0 for a closed surface
    double volume = 0.0;
    double extent = 0.0; // the sum of distances to the middle times area
    bool isTurned = false;
  };
  std::vector<Part> parts(this->Places.size());
  for (Index place = 0; place < this->Places.size(); ++place)
  {
    Part& part = parts[this->find(place).first];
    const double area = this->Planes[place].area;
    part.area += area;
    part.middle = part.middle + this->Places[place] * area;
    part.facing = part.facing + this->Planes[place].normal * area;
  }
  for (Index place = 0; place < this->Places.size(); ++place)
  {
    Part& part = parts[this->find(place).first];
    const Vec3 d = this->Places[place] - part.middle * (1.0 / part.area);
    part.volume += dot(d, this->Planes[place].normal) * this->Planes[place].area;
    part.extent += length(d) * this->Planes[place].area;
  }
  for (Part& part : parts)
  {
    if (part.facing == Vec3{} && part.volume == 0.0)
    {
      continue;
    }
    const bool isOpen =
      length(part.facing) > kOpen * part.area && std::abs(part.volume) < kThin * part.extent;
    const Vec3& f = part.facing;
    const bool isDown = std::tie(f.z, f.y, f.x) < std::make_tuple(0.0, 0.0, 0.0);
    part.isTurned = isOpen ? isDown : part.volume < 0.0;
    ++result.parts;
    result.openParts += isOpen ? 1 : 0;
  }
  for (Index place = 0; place < this->Places.size(); ++place)
  {
    if (parts[this->find(place).first].isTurned)
    {
      this->Planes[place].normal = this->Planes[place].normal * -1.0;
    }
  }
}

} // namespace

PointNormalResult pointNormals(
  std::span<const Vec3> points, const PointNormalOptions& options, Execution& execution)
{
  const Neighbours places(points, execution);
  std::vector<Place> planes(places.size());
  parallelSteps(execution, { "normals" }, places.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        places.nearest(places[static_cast<Index>(i)], options.neighbours + 1, found);
        planes[i] = { fitPlane(places, found).normal, found.back().squaredDistance };
      }
    });
  PointNormalResult result;
  if (options.orient == PointNormalOptions::Orient::outward)
  {
    Orientation orientation(places, planes, execution);
    orientation.agree();
    orientation.turnOutward(result);
  }
  result.normals.resize(points.size());
  for (Index place = 0; place < places.size(); ++place)
  {
    Vec3 normal = planes[place].normal;
    if (options.orient == PointNormalOptions::Orient::toward &&
      dot(normal, options.viewpoint - places[place]) < 0.0)
    {
      normal = normal * -1.0;
    }
    for (const Index point : places.pointsAt(place))
    {
      result.normals[point] = normal;
      result.undecided += normal == Vec3{} ? 1 : 0;
    }
  }
  execution.step("orient", 1, 1);
  return result;
}

} // namespace scan
