// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/dominators.h"

#include "filters/geometry/relaxed.h"

namespace scan
{
namespace
{

constexpr Dominators::Code kNothing = kNone;
constexpr Dominators::Code kUnknown = kNone - 1;

// of an obtuse free triangle
constexpr unsigned kItself = 1;
constexpr unsigned kAsBeside = 2;

} // namespace

/// Depth first on an explicit stack: the relation is acyclic. Whoever works one out gets the same,
/// so it does no harm when two threads do.
class Dominators::Search
{
public:
  Search(const FlowComplex& flow, Dominators& found)
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
        const Code code = this->work(top);
        if (code == kUnknown)
        {
          continue; // holders were pushed: first things first
        }
        this->Found.remember(top, code);
      }
      this->Pending.pop_back();
    }
  }

private:
  /// What all holders hang on, itself if that differs, or unknown.
  Code work(Upper upper)
  {
    const Code self = this->Found.codeOf(upper);
    if (upper.isTet && this->Flow.isSink(upper.name))
    {
      return self;
    }
    const std::size_t before = this->Pending.size();
    Code common = kNothing;
    const auto agrees = [&](Upper holder)
    {
      const Code code = this->Found.of(holder);
      if (code == kUnknown)
      {
        this->Pending.push_back(holder);
      }
      else if (code != kNothing)
      {
        const bool isOther = common != kNothing && common != code;
        common = code;
        return !isOther;
      }
      return true;
    };
    bool isOne = forEachNearHolder(this->Flow, upper, agrees);
    if (isOne && this->Pending.size() == before)
    {
      isOne = forEachHolderAround(this->Flow, upper, agrees);
    }
    if (!isOne)
    {
      this->Pending.resize(before);
      return self;
    }
    if (this->Pending.size() > before)
    {
      return kUnknown;
    }
    const bool isPlain = upper.isTet ? common == kNothing || this->Found.at(common).isTet
                                     : this->Found.beside(upper.name) == common;
    return isPlain ? common : self;
  }

  const FlowComplex& Flow;
  Dominators& Found;
  std::vector<Upper> Pending;
};

Dominators::Dominators(const FlowComplex& flow, Execution& execution)
  : Flow(flow)
  , FacetCount(4 * flow.delaunay().tetCount())
  , OfTet(flow.delaunay().tetCount(), kUnknown)
  , OfTriangle(flow.delaunay().tetCount())
{
  execution.parallelFor(this->OfTet.size(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      Search search(flow, *this);
      for (auto tet = static_cast<Index>(begin); tet < end; ++tet)
      {
        search.find({ true, tet });
        for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
        {
          if (flow.isObtuse(facet) && flow.isFree(facet) &&
            flow.delaunay().canonical(facet) == facet)
          {
            search.find({ false, facet });
          }
        }
      }
    });
}

Dominators::Code Dominators::of(Upper upper) const
{
  if (upper.isTet)
  {
    return loadRelaxed(this->OfTet[upper.name]);
  }
  if (!this->Flow.isObtuse(upper.name))
  {
    return upper.name; // critical
  }
  const unsigned stored = this->OfTriangle.at(upper.name);
  return stored == kItself ? upper.name : stored == kAsBeside ? this->beside(upper.name) : kUnknown;
}

/// Of the tetrahedra on the sides of a triangle, the first one that hangs on something.
Dominators::Code Dominators::beside(Facet triangle) const
{
  const Code own = this->of({ true, triangle / 4 });
  const Index beyond =
    this->Flow.delaunay().neighbour(triangle / 4, static_cast<int>(triangle % 4));
  return own == kNothing && beyond != kNone ? this->of({ true, beyond }) : own;
}

void Dominators::remember(Upper upper, Code code)
{
  if (upper.isTet)
  {
    storeRelaxed(this->OfTet[upper.name], code);
    return;
  }
  this->OfTriangle.set(upper.name, code == upper.name ? kItself : kAsBeside);
}

} // namespace scan
