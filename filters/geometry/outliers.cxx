// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/outliers.h"

#include "filters/geometry/local_plane.h"
#include "filters/geometry/union_find.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

namespace scan
{
namespace
{

constexpr double kDeviations = 4.0; // of the usual ratios, robustly measured
constexpr std::size_t kLonelySize = 2;
constexpr double kLonely = 0.6;             // of the limit: for points that are nobody's neighbours
constexpr double kOff = 0.5;                // of the distance to the nearest: off its surface
constexpr double kGap = 8.0;                // spacings around a clump
constexpr std::size_t kClumpNeighbours = 4; // largest clump, in numbers of neighbours
constexpr std::size_t kClumpShare = 50;     // of all places, the inverse
constexpr std::size_t kCloudShare = 4;      // largest cloud of strays, of all places, the inverse
constexpr double kJump = 1.6; // of the spacing between neighbours that hang together, at most
constexpr double kThin = 2.0; // spacings of the scan nearby: that of a cloud, at least
constexpr double kFull = 0.1; // surface variation of a cloud, at least

double quantile(std::vector<double>& values, double share)
{
  const auto at =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Places and their neighbours.
struct Crowd
{
  const Neighbours& places;
  std::size_t count;                // of neighbours
  std::vector<Index> near;          // count per place, nearest first
  std::vector<double> spacing;      // mean distance of these
  std::vector<double> ratio;        // of the spacing to the median of those of the neighbours
  std::vector<std::uint8_t> isFull; // whether the neighbours fill space rather than a surface

  Crowd(const Neighbours& all, std::size_t neighbours, Execution& execution);

  std::span<const Index> nearOf(Index place) const
  {
    return { this->near.data() + place * this->count, this->count };
  }
};

Crowd::Crowd(const Neighbours& all, std::size_t neighbours, Execution& execution)
  : places(all)
  , count(neighbours)
  , near(all.size() * neighbours)
  , spacing(all.size())
  , ratio(all.size())
  , isFull(all.size())
{
  parallelSteps(execution, { "outliers" }, all.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        all.nearest(all[static_cast<Index>(i)], neighbours + 1, found);
        double sum = 0.0;
        for (std::size_t n = 0; n < neighbours; ++n) // the first is the place itself
        {
          this->near[i * neighbours + n] = found[n + 1].place;
          sum += std::sqrt(found[n + 1].squaredDistance);
        }
        this->spacing[i] = sum / static_cast<double>(neighbours);
        this->isFull[i] = fitPlane(all, found).variation() > kFull ? 1 : 0;
      }
    });
  execution.parallelFor(all.size(), 1U << 12U,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<double> around(neighbours);
      for (std::size_t i = begin; i < end; ++i)
      {
        std::ranges::transform(this->nearOf(static_cast<Index>(i)), around.begin(),
          [&](Index neighbour) { return this->spacing[neighbour]; });
        this->ratio[i] = this->spacing[i] / quantile(around, 0.5);
      }
    });
}

/// From where on a ratio is no chance.
double limitOf(const std::vector<double>& ratios, double factor)
{
  std::vector<double> logarithms(ratios.size());
  std::ranges::transform(ratios, logarithms.begin(), [](double ratio) { return std::log(ratio); });
  const double middle = quantile(logarithms, 0.5);
  std::ranges::for_each(logarithms, [&](double& value) { value = std::abs(value - middle); });
  constexpr double kNormal = 1.4826; // median absolute deviation to standard deviation
  return std::max(factor, std::exp(middle + kDeviations * kNormal * quantile(logarithms, 0.5)));
}

using Part = std::vector<Index>;

/// The places that hang together by links between neighbours.
/// @param areLinked (place, its neighbour)
template <class Condition>
std::vector<Part> partsOf(
  const Crowd& crowd, const std::vector<std::uint8_t>& isStray, const Condition& areLinked)
{
  const auto all = static_cast<Index>(crowd.places.size());
  UnionFind sets(all);
  for (Index place = 0; place < all; ++place)
  {
    for (const Index other : crowd.nearOf(place))
    {
      if (isStray[place] == 0 && isStray[other] == 0 && areLinked(place, other))
      {
        sets.unite(place, other);
      }
    }
  }
  std::vector<Part> parts(all);
  for (Index place = 0; place < all; ++place)
  {
    if (isStray[place] == 0)
    {
      parts[sets.root(place)].push_back(place);
    }
  }
  std::erase_if(parts, [](const Part& part) { return part.empty(); });
  return parts;
}

/// What is alike and hangs together because each is among the nearest of the other. A stray point
/// has neighbours on the scan, but those have nearer ones.
std::vector<Part> mutualParts(const Crowd& crowd, const std::vector<std::uint8_t>& isStray)
{
  const std::size_t close = crowd.count / 2;
  const auto isNear = [&](Index place, Index other)
  {
    const auto near = crowd.nearOf(place).first(close);
    return std::ranges::find(near, other) != near.end();
  };
  return partsOf(crowd, isStray,
    [&](Index a, Index b)
    {
      const auto [low, high] = std::minmax(crowd.spacing[a], crowd.spacing[b]);
      return crowd.isFull[a] == crowd.isFull[b] && high < kJump * low && isNear(a, b) &&
        isNear(b, a);
    });
}

/// The distance to the second neighbour: one may be a twin.
double closeSpacing(const Crowd& crowd, Index place)
{
  return length(crowd.places[crowd.nearOf(place)[1]] - crowd.places[place]);
}

/// What hangs together over gaps of less than kGap spacings.
std::vector<Part> gapParts(const Crowd& crowd, const std::vector<std::uint8_t>& isStray)
{
  return partsOf(crowd, isStray,
    [&](Index a, Index b)
    {
      const double gap = kGap * std::min(closeSpacing(crowd, a), closeSpacing(crowd, b));
      return length(crowd.places[a] - crowd.places[b]) < gap;
    });
}

template <class Measure>
double quantileOf(const Part& part, double share, const Measure& measure)
{
  std::vector<double> values(part.size());
  std::ranges::transform(part, values.begin(), measure);
  return quantile(values, share);
}

/// Whether only strays are near the part.
bool isFarFromOthers(const Crowd& crowd, const Part& part, const std::vector<std::uint8_t>& isStray)
{
  const double own = quantileOf(part, 0.5, [&](Index place) { return closeSpacing(crowd, place); });
  std::vector<Neighbour> found;
  return std::ranges::all_of(part,
    [&](Index place)
    {
      crowd.places.nearest(crowd.places[place], part.size() + 1, found, isStray);
      return std::ranges::all_of(found,
        [&](const Neighbour& other)
        {
          const double gap = kGap * std::max(own, closeSpacing(crowd, other.place));
          return other.squaredDistance > gap * gap || std::ranges::binary_search(part, other.place);
        });
    });
}

/// The scan beyond doubt: large parts that are a surface.
class Ground
{
public:
  Ground(
    const Crowd& crowd, const std::vector<Part>& parts, std::size_t least, Execution& execution)
  {
    std::vector<Vec3> points;
    for (const Part& part : parts)
    {
      if (part.size() >= least && crowd.isFull[part.front()] == 0)
      {
        for (const Index place : part)
        {
          points.push_back(crowd.places[place]);
          this->Spacings.push_back(crowd.spacing[place]);
        }
      }
    }
    this->Places.emplace(points, execution);
  }

  /// At the nearest place; infinite without ground.
  double spacingNear(const Vec3& at) const
  {
    std::vector<Neighbour> found;
    this->Places->nearest(at, 1, found);
    return found.empty() ? std::numeric_limits<double>::infinity()
                         : this->Spacings[this->Places->pointsAt(found.front().place).front()];
  }

private:
  std::vector<double> Spacings;
  std::optional<Neighbours> Places;
};

/// Whether the part is no surface, or too small to tell, and thin beside the ground.
bool isCloud(const Crowd& crowd, const Part& part, const Ground& ground)
{
  const auto thinness = [&](Index place)
  { return crowd.spacing[place] / ground.spacingNear(crowd.places[place]); };
  return (part.size() < crowd.count || crowd.isFull[part.front()] != 0) &&
    quantileOf(part, 0.5, thinness) > kThin;
}

/// Whether the place is off the plane of its neighbours, rather than at an end of the scan.
bool isOffSurface(const Crowd& crowd, Index place)
{
  std::vector<Neighbour> others;
  std::ranges::transform(crowd.nearOf(place), std::back_inserter(others),
    [](Index other) {
      return Neighbour{ other, 0.0 };
    });
  const LocalPlane plane = fitPlane(crowd.places, others);
  const Vec3 toNearest = crowd.places[crowd.nearOf(place).front()] - crowd.places[place];
  const double height = std::abs(dot(crowd.places[place] - plane.middle, plane.normal));
  return height > kOff * length(toNearest);
}

/// Marks stray places that are neighbours of each other.
std::vector<std::uint8_t> strayParts(
  const Crowd& crowd, const std::vector<std::uint8_t>& isStray, double limit, Execution& execution)
{
  const std::size_t all = crowd.places.size();
  const std::size_t largestClump = std::min(kClumpNeighbours * crowd.count, all / kClumpShare);
  std::vector<std::uint8_t> isMarked(all, 0);
  const auto mark = [&](const std::vector<Part>& parts, std::size_t largest, const auto& isTold)
  {
    for (const Part& part : parts)
    {
      if (part.size() <= largest && isTold(part))
      {
        std::ranges::for_each(part, [&](Index place) { isMarked[place] = 1; });
      }
      execution.step("parts", 0, 1); // only checks for cancel
    }
  };
  const std::vector<Part> mutual = mutualParts(crowd, isStray);
  const Ground ground(crowd, mutual, largestClump + 1, execution);
  mark(mutual, all / kCloudShare, [&](const Part& part) { return isCloud(crowd, part, ground); });
  mark(mutual, kLonelySize,
    [&](const Part& part)
    {
      return std::ranges::all_of(part,
        [&](Index place)
        { return crowd.ratio[place] > kLonely * limit && isOffSurface(crowd, place); });
    });
  mark(gapParts(crowd, isStray), largestClump,
    [&](const Part& part) { return isFarFromOthers(crowd, part, isStray); });
  return isMarked;
}

} // namespace

OutlierResult findOutliers(std::span<const Vec3> points, std::span<const std::uint8_t> inRegion,
  const OutlierOptions& options, Execution& execution)
{
  OutlierResult result;
  result.isStray.resize(points.size(), 0);
  const Neighbours places(points, execution);
  if (places.size() <= options.neighbours)
  {
    return result;
  }
  const Crowd crowd(places, options.neighbours, execution);
  const double limit = limitOf(crowd.ratio, options.factor);
  std::vector<std::uint8_t> isSingle(places.size());
  std::ranges::transform(
    crowd.ratio, isSingle.begin(), [&](double ratio) { return ratio > limit ? 1 : 0; });
  const std::vector<std::uint8_t> isTogether = strayParts(crowd, isSingle, limit, execution);
  for (Index place = 0; place < places.size(); ++place)
  {
    for (const Index point : places.pointsAt(place))
    {
      if (inRegion[point] != 0 && (isSingle[place] != 0 || isTogether[place] != 0))
      {
        result.isStray[point] = 1;
        ++(isSingle[place] != 0 ? result.single : result.together);
      }
    }
  }
  return result;
}

} // namespace scan
