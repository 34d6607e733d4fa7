// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/hilbert_order.h"

#include "filters/geometry/large_array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace scan
{
namespace
{

constexpr int kBits = 16; // an axis: 48 in a code
constexpr int kBucketBits = 12;

/// A point and its place on the curve.
struct Place
{
  std::uint64_t code;
  Index point;
};

/// Of four points, side by side.
using Four __attribute__((vector_size(16))) = std::uint32_t;

/// The bits of a 16-bit number, two zeros after each.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 16) & 0xff00'00ffULL;
  bits = (bits | bits << 8) & 0xf0'0f00'f00fULL;
  bits = (bits | bits << 4) & 0xc30'c30c'30c3ULL;
  return (bits | bits << 2) & 0x2492'4924'9249ULL;
}

/// Skilling, "Programming the Hilbert curve" (2004), without branches.
std::array<std::uint64_t, 4> hilbertCodes(std::array<Four, 3> cells)
{
  auto& [x, y, z] = cells;
  for (int bit = kBits - 1; bit > 0; --bit)
  {
    const std::uint32_t lower = (1U << bit) - 1;
    for (Four& axis : cells)
    {
      const Four set = 0U - (axis >> bit & 1U);
      const Four swapped = (x ^ axis) & lower & ~set;
      x ^= (lower & set) | swapped;
      axis ^= swapped;
    }
  }
  y ^= x;
  z ^= y;
  Four flips{};
  for (int bit = kBits - 1; bit > 0; --bit)
  {
    flips ^= ((1U << bit) - 1) & (0U - (z >> bit & 1U));
  }
  std::array<std::uint64_t, 4> codes;
  for (int i = 0; i < 4; ++i)
  {
    codes[static_cast<std::size_t>(i)] =
      spread(x[i] ^ flips[i]) << 2 | spread(y[i] ^ flips[i]) << 1 | spread(z[i] ^ flips[i]);
  }
  return codes;
}

/// Cells of equal size that fill a box.
class Grid
{
public:
  Grid(std::span<const Vec3> points, std::span<const Place> places)
    : Low(points[places[0].point])
  {
    Vec3 high = this->Low;
    for (const Place& place : places)
    {
      const Vec3& p = points[place.point];
      this->Low = { std::min(this->Low.x, p.x), std::min(this->Low.y, p.y),
        std::min(this->Low.z, p.z) };
      high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
    }
    const Vec3 size = high - this->Low;
    constexpr double kSmallest = 1e-290; // its inverse is a double
    this->CellsPerUnit = 65535.0 / std::max({ size.x, size.y, size.z, kSmallest });
  }

  void setCodes(std::span<const Vec3> points, std::span<Place> places) const
  {
    for (std::size_t first = 0; first < places.size(); first += 4)
    {
      const std::span<Place> four =
        places.subspan(first, std::min<std::size_t>(4, places.size() - first));
      std::array<Four, 3> cells{};
      for (std::size_t i = 0; i < four.size(); ++i)
      {
        const Vec3 at = (points[four[i].point] - this->Low) * this->CellsPerUnit;
        cells[0][i] = static_cast<std::uint32_t>(at.x);
        cells[1][i] = static_cast<std::uint32_t>(at.y);
        cells[2][i] = static_cast<std::uint32_t>(at.z);
      }
      const std::array<std::uint64_t, 4> codes = hilbertCodes(cells);
      for (std::size_t i = 0; i < four.size(); ++i)
      {
        four[i].code = codes[i];
      }
    }
  }

private:
  Vec3 Low;
  double CellsPerUnit = 0.0;
};

void sortByCoordinates(std::span<const Vec3> points, std::span<Place> places)
{
  const auto key = [&](const Place& place)
  {
    const Vec3& p = points[place.point];
    return std::tuple(p.x, p.y, p.z, place.point);
  };
  std::sort(
    places.begin(), places.end(), [&](const Place& a, const Place& b) { return key(a) < key(b); });
}

void sortByCode(std::span<const Vec3> points, std::span<Place> places);

/// Sorts points of one cell along a curve in their own, smaller box.
void sortWithinCell(std::span<const Vec3> points, std::span<Place> places)
{
  constexpr std::size_t kFew = 16;
  if (places.size() <= kFew)
  {
    sortByCoordinates(points, places);
    return;
  }
  const Grid grid(points, places);
  grid.setCodes(points, places);
  const auto alike = [&](const Place& place) { return place.code == places[0].code; };
  if (std::all_of(places.begin(), places.end(), alike)) // equal points
  {
    sortByCoordinates(points, places);
  }
  else
  {
    sortByCode(points, places);
  }
}

void sortByCode(std::span<const Vec3> points, std::span<Place> places)
{
  std::sort(
    places.begin(), places.end(), [](const Place& a, const Place& b) { return a.code < b.code; });
  for (auto first = places.begin(); first != places.end();)
  {
    const auto last = std::find_if(
      first, places.end(), [&](const Place& place) { return place.code != first->code; });
    if (last - first > 1)
    {
      sortWithinCell(points, std::span(first, last));
    }
    first = last;
  }
}

/// Moves places with the same leading bits together; returns where each such bucket begins.
std::vector<std::size_t> bucket(LargeArray<Place>& places)
{
  const auto bucketOf = [](const Place& place) { return place.code >> (3 * kBits - kBucketBits); };
  std::vector<std::size_t> begin((1U << kBucketBits) + 2, 0);
  for (const Place& place : places)
  {
    ++begin[bucketOf(place) + 2];
  }
  for (std::size_t i = 2; i < begin.size(); ++i)
  {
    begin[i] += begin[i - 1];
  }
  LargeArray<Place> sorted(places.size());
  for (const Place& place : places)
  {
    sorted[begin[bucketOf(place) + 1]++] = place;
  }
  begin.pop_back();
  places.swap(sorted);
  return begin;
}

} // namespace

std::vector<Index> hilbertOrder(std::span<const Vec3> points, Execution& execution)
{
  if (points.empty())
  {
    return {};
  }
  constexpr std::size_t kGrain = 1 << 14;
  LargeArray<Place> places(points.size());
  for (Index i = 0; i < points.size(); ++i)
  {
    places[i].point = i;
  }
  const Grid grid(points, places);
  execution.parallelFor(places.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    { grid.setCodes(points, std::span(places).subspan(begin, end - begin)); });
  const std::vector<std::size_t> buckets = bucket(places);
  std::vector<Index> order(points.size());
  execution.parallelFor(buckets.size() - 1, 16,
    [&](std::size_t begin, std::size_t end)
    {
      const std::span part(places.begin() + static_cast<std::ptrdiff_t>(buckets[begin]),
        buckets[end] - buckets[begin]);
      sortByCode(points, part);
      std::transform(part.begin(), part.end(),
        order.begin() + static_cast<std::ptrdiff_t>(buckets[begin]),
        [](const Place& place) { return place.point; });
    });
  return order;
}

} // namespace scan
