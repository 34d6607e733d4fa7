// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/spacing.h"

#include "filters/geometry/finite_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <tuple>
#include <vector>

namespace scan
{
namespace
{

constexpr std::size_t kSampleSize = 16384;
constexpr std::size_t kLeafSize = 12;
constexpr double kStrayFactor = 8.0;
constexpr std::array<double Vec3::*, 3> kAxes = { &Vec3::x, &Vec3::y, &Vec3::z };

/// The finite points, each once, in lexicographic order.
std::vector<Vec3> distinctPoints(std::span<const Vec3> points)
{
  std::vector<Vec3> distinct;
  distinct.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(distinct), isFinite);
  std::sort(distinct.begin(), distinct.end(),
    [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  return distinct;
}

/// A balanced k-d tree in place: the middle of a range parts it along its widest axis.
class NearestOther
{
public:
  explicit NearestOther(std::vector<Vec3> points)
    : Points(std::move(points))
    , SplitAxis(this->Points.size())
  {
    this->build(0, this->Points.size());
  }

  /// Squared distance from `query` to the nearest point that is not `query` itself.
  double squaredDistance(const Vec3& query) const
  {
    double best = std::numeric_limits<double>::infinity();
    this->search(query, 0, this->Points.size(), best);
    return best;
  }

private:
  void build(std::size_t begin, std::size_t end);
  void search(const Vec3& query, std::size_t begin, std::size_t end, double& best) const;

  std::vector<Vec3> Points;
  std::vector<std::uint8_t> SplitAxis; // per middle
};

void NearestOther::build(std::size_t begin, std::size_t end)
{
  if (end - begin <= kLeafSize)
  {
    return;
  }
  Vec3 low = this->Points[begin];
  Vec3 high = low;
  for (std::size_t i = begin + 1; i < end; ++i)
  {
    const Vec3& p = this->Points[i];
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  const Vec3 size = high - low;
  const std::uint8_t axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2)
    : size.y >= size.z                       ? 1
                                             : 2;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i)
  { return this->Points.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
    [along = kAxes[axis]](const Vec3& a, const Vec3& b) { return a.*along < b.*along; });
  this->SplitAxis[middle] = axis;
  this->build(begin, middle);
  this->build(middle + 1, end);
}

void NearestOther::search(const Vec3& query, std::size_t begin, std::size_t end, double& best) const
{
  const auto consider = [&](const Vec3& p)
  {
    const double squared = dot(p - query, p - query);
    best = p != query ? std::min(best, squared) : best;
  };
  if (end - begin <= kLeafSize)
  {
    std::for_each_n(this->Points.data() + begin, end - begin, consider);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto along = kAxes[this->SplitAxis[middle]];
  const double offset = query.*along - this->Points[middle].*along;
  consider(this->Points[middle]);
  const auto lower = [&] { this->search(query, begin, middle, best); };
  const auto upper = [&] { this->search(query, middle + 1, end, best); };
  offset < 0.0 ? lower() : upper();
  if (offset * offset < best)
  {
    offset < 0.0 ? upper() : lower();
  }
}

} // namespace

double meanSpacing(std::span<const Vec3> points)
{
  std::vector<Vec3> distinct = distinctPoints(points);
  if (distinct.size() < 2)
  {
    return 0.0;
  }
  // spread over the sorted points, so over the model
  const std::size_t samples = std::min(distinct.size(), kSampleSize);
  std::vector<Vec3> queries(samples);
  for (std::size_t i = 0; i < samples; ++i)
  {
    queries[i] = distinct[i * distinct.size() / samples];
  }
  const NearestOther tree(std::move(distinct));
  std::vector<double> distances(samples);
  std::transform(queries.begin(), queries.end(), distances.begin(),
    [&](const Vec3& query) { return std::sqrt(tree.squaredDistance(query)); });
  std::sort(distances.begin(), distances.end());
  const auto usual = std::upper_bound(
    distances.begin(), distances.end(), kStrayFactor * distances[(samples - 1) / 2]);
  double sum = 0.0;
  std::for_each(distances.begin(), usual, [&](double distance) { sum += distance; });
  return sum / static_cast<double>(usual - distances.begin());
}

} // namespace scan
