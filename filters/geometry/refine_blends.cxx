// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/refine_blends.h"

#include <algorithm>
#include <iterator>

namespace scan
{

/// Points of the input and their parts in two blends: six at most.
struct RefineBlends::Shares
{
  struct Share
  {
    Index point = 0;
    double weight = 0.0;
  };
  std::array<Share, 6> all;
  std::size_t count = 0;

  double* weightOf(Index point)
  {
    for (std::size_t i = 0; i < this->count; ++i)
    {
      if (this->all.at(i).point == point)
      {
        return &this->all.at(i).weight;
      }
    }
    return nullptr;
  }

  void addHalf(const PointBlend& blend)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const double weight = 0.5 * blend.weights.at(i);
      if (double* const own = this->weightOf(blend.from.at(i)))
      {
        *own += weight;
      }
      else if (weight > 0.0)
      {
        this->all.at(this->count++) = { blend.from.at(i), weight };
      }
    }
  }

  void dropZeros()
  {
    const auto end = std::remove_if(this->all.begin(),
      this->all.begin() + static_cast<std::ptrdiff_t>(this->count),
      [](const Share& share) { return !(share.weight > 0.0); });
    this->count = static_cast<std::size_t>(end - this->all.begin());
  }

  /// Of the three largest.
  PointBlend blend()
  {
    while (this->count > 3)
    {
      const auto end = this->all.begin() + static_cast<std::ptrdiff_t>(this->count--);
      *std::min_element(this->all.begin(), end,
        [](const Share& a, const Share& b) { return a.weight < b.weight; }) = *(end - 1);
    }
    PointBlend blend;
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const bool isThere = i < this->count;
      blend.from.at(i) = this->all.at(isThere ? i : 0).point;
      blend.weights.at(i) = isThere ? this->all.at(i).weight : 0.0;
      sum += blend.weights.at(i);
    }
    std::ranges::for_each(blend.weights, [sum](double& weight) { weight /= sum; });
    return blend;
  }
};

void RefineBlends::addJoins(std::span<const Join> joins)
{
  std::ranges::copy_if(joins, std::back_inserter(this->Joins),
    [this](const Join& join) { return std::ranges::max(join) < this->Points; });
  std::ranges::sort(this->Joins);
}

PointBlend RefineBlends::of(Index point) const
{
  return point < this->Points ? PointBlend{ { point, point, point } }
                              : this->Blends[point - this->Points];
}

/// A triangle that was put together has four points of the input: its corners and the middle of an
/// edge. As both ends of that edge together are the middle twice, three of them do.
void RefineBlends::reduce(Shares& shares) const
{
  for (std::size_t i = 0; i < shares.count; ++i)
  {
    const Index m = shares.all.at(i).point;
    for (auto join = std::ranges::lower_bound(this->Joins, Join{ m, 0, 0 });
         join != this->Joins.end() && (*join)[0] == m; ++join)
    {
      double* const a = shares.weightOf((*join)[1]);
      double* const b = shares.weightOf((*join)[2]);
      if (a != nullptr && b != nullptr)
      {
        const double both = std::min(*a, *b);
        *a -= both;
        *b -= both;
        shares.all.at(i).weight += 2.0 * both;
      }
    }
  }
  shares.dropZeros();
}

PointBlend RefineBlends::middleOf(const PointBlend& first, const PointBlend& second) const
{
  Shares shares;
  shares.addHalf(first);
  shares.addHalf(second);
  if (shares.count > 3)
  {
    this->reduce(shares);
  }
  return shares.blend();
}

void RefineBlends::setMiddle(Index point, Index a, Index b)
{
  this->Blends[point - this->Points] = a < this->Points && b < this->Points
    ? PointBlend{ { a, b, b }, { 0.5, 0.5, 0.0 } }
    : this->middleOf(this->of(a), this->of(b));
}

} // namespace scan
