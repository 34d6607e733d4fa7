// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/representatives.h"

#include "filters/geometry/relaxed.h"

#include <algorithm>
#include <vector>

namespace scan
{
namespace
{

constexpr Representatives::Code kNothing = kNone;
constexpr Representatives::Code kUnknown = kNone - 1;

} // namespace

/// Depth first on an explicit stack: the relation is acyclic. Whoever works one out gets the same,
/// so it does no harm when two threads do.
class Representatives::Search
{
public:
  Search(const FlowComplex& flow, Representatives& found)
    : Flow(flow)
    , Found(found)
  {
  }

  void find(Upper upper)
  {
    this->Pending.assign(1, upper);
    while (!this->Pending.empty())
    {
      const Upper top = this->Pending.back();
      if (this->Found.of(top) == kUnknown)
      {
        const std::size_t before = this->Pending.size();
        const Code code = this->work(top);
        if (this->Pending.size() > before)
        {
          continue; // first things first
        }
        this->Found.remember(top, code);
      }
      this->Pending.pop_back();
    }
  }

private:
  /// The answer, once all that it hangs on is known; adds to Pending what is not.
  Code work(Upper upper)
  {
    const Code self = this->Found.codeOf(upper);
    if (upper.isTet && this->Flow.isSink(upper.name))
    {
      return self;
    }
    this->Holders.clear();
    this->forEachHolder(upper,
      [&](Code code)
      {
        if (code != kNothing && std::ranges::find(this->Holders, code) == this->Holders.end())
        {
          this->Holders.push_back(code);
        }
        return this->Holders.size() <= kMost;
      });
    if (this->Holders.empty())
    {
      return kNothing;
    }
    if (this->Holders.size() > kMost)
    {
      return self;
    }
    if (this->Holders.size() > 1)
    {
      this->dropImplied();
    }
    return this->Holders.size() == 1 ? this->Holders.front() : self;
  }

  /// Leaves those that hold none of the others.
  void dropImplied()
  {
    this->Implied.clear();
    for (const Code held : this->Holders)
    {
      this->forEachHolder(this->Found.at(held),
        [&](Code code)
        {
          this->Implied.push_back(code);
          return true;
        });
    }
    std::erase_if(this->Holders,
      [&](Code code) { return std::ranges::find(this->Implied, code) != this->Implied.end(); });
  }

  /// Calls visit(code) for the representatives of all holders until it returns false. Those that
  /// are not known yet become pending.
  template <class Visit>
  void forEachHolder(Upper upper, Visit&& visit)
  {
    const auto meet = [&](Upper holder)
    {
      const Code code = this->Found.of(holder);
      if (code == kUnknown)
      {
        this->Pending.push_back(holder);
        return true;
      }
      return visit(code);
    };
    if (forEachNearHolder(this->Flow, upper, meet))
    {
      forEachHolderAround(this->Flow, upper, meet);
    }
  }

  static constexpr std::size_t kMost = 8; ///< holders that are compared; more are rare

  const FlowComplex& Flow;
  Representatives& Found;
  std::vector<Upper> Pending;
  std::vector<Code> Holders;
  std::vector<Code> Implied;
};

Representatives::Representatives(const FlowComplex& flow, Execution& execution)
  : Flow(flow)
  , FacetCount(4 * flow.delaunay().tetCount())
  , Obtuse(flow.delaunay(), execution,
      [&](Facet facet) { return flow.isFree(facet) && flow.isObtuse(facet); })
  , OfTet(flow.delaunay().tetCount())
  , OfObtuse(Obtuse.count())
{
  std::ranges::fill(this->OfTet, kUnknown);
  std::ranges::fill(this->OfObtuse, kUnknown);
  execution.parallelFor(this->OfTet.size(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      Search search(flow, *this);
      for (auto tet = static_cast<Index>(begin); tet < end; ++tet)
      {
        search.find({ true, tet });
        for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
        {
          if (this->Obtuse.contains(facet))
          {
            search.find({ false, facet });
          }
        }
      }
    });
}

Representatives::Code Representatives::of(Upper upper) const
{
  if (upper.isTet)
  {
    return loadRelaxed(this->OfTet[upper.name]);
  }
  return this->Flow.isObtuse(upper.name) ? loadRelaxed(this->OfObtuse[this->Obtuse.of(upper.name)])
                                         : upper.name; // critical
}

void Representatives::remember(Upper upper, Code code)
{
  storeRelaxed(
    upper.isTet ? this->OfTet[upper.name] : this->OfObtuse[this->Obtuse.of(upper.name)], code);
}

} // namespace scan
