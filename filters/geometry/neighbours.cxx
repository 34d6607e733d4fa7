// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/neighbours.h"

#include "filters/base/error.h"
#include "filters/geometry/finite_points.h"
#include "filters/geometry/hilbert_order.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kLeafSize = 12;

/// What nanoflann asks for; gives up building a tree when the run is cancelled.
struct Cloud
{
  const std::vector<Vec3>& places;
  const Execution* building;

  std::size_t kdtree_get_point_count() const { return this->places.size(); }
  double kdtree_get_pt(std::size_t place, std::size_t axis) const
  {
    if (this->building != nullptr && this->building->cancelled())
    {
      throw Cancelled();
    }
    const Vec3& p = this->places[place];
    return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

/// The nearest places so far, of which nanoflann's own sets would keep any of equally near ones.
struct NearestSet
{
  std::vector<Neighbour>& found;
  std::size_t capacity;
  std::span<const std::uint8_t> isLeftOut;

  std::size_t size() const { return this->found.size(); }
  bool full() const { return this->found.size() == this->capacity; }
  double worstDist() const // just above, so that equal distances come in, too
  {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    return this->full() ? std::nextafter(this->found.back().squaredDistance, kInfinity) : kInfinity;
  }
  bool addPoint(double squaredDistance, Index place)
  {
    const Neighbour added{ place, squaredDistance };
    if ((!this->isLeftOut.empty() && this->isLeftOut[place] != 0) ||
      (this->full() && !isNearer(added, this->found.back())))
    {
      return true;
    }
    if (this->full())
    {
      this->found.pop_back();
    }
    this->found.insert(std::ranges::upper_bound(this->found, added, isNearer), added);
    return true;
  }

  static bool isNearer(const Neighbour& a, const Neighbour& b)
  {
    return a.squaredDistance < b.squaredDistance ||
      (a.squaredDistance == b.squaredDistance && a.place < b.place);
  }
};

/// All places below a squared distance.
struct WithinSet
{
  std::vector<Neighbour>& found;
  double limit;

  std::size_t size() const { return this->found.size(); }
  bool full() const { return true; }
  double worstDist() const { return this->limit; }
  bool addPoint(double squaredDistance, Index place)
  {
    this->found.push_back({ place, squaredDistance });
    return true;
  }
};

} // namespace

class Neighbours::Tree
{
public:
  Tree(const std::vector<Vec3>& places, const Execution& execution)
    : Points{ places, &execution }
    , Index3(3, this->Points, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize))
  {
    this->Points.building = nullptr;
  }

  template <class Set>
  void search(const Vec3& at, Set& found) const
  {
    const double query[3] = { at.x, at.y, at.z };
    this->Index3.findNeighbors(found, query, nanoflann::SearchParams());
  }

private:
  Cloud Points;
  nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud, double, Index>,
    Cloud, 3, Index>
    Index3;
};

Neighbours::Neighbours(std::span<const Vec3> points, Execution& execution)
{
  execution.step("neighbours", 0, 3);
  requireFinitePoints(points);
  this->Order = hilbertOrder(points, execution);
  execution.step("neighbours", 1, 3);
  for (Index i = 0; i < this->Order.size(); ++i)
  {
    const Vec3& p = points[this->Order[i]];
    if (this->Places.empty() || p != this->Places.back())
    {
      this->Places.push_back(p);
      this->Begins.push_back(i);
    }
  }
  this->Begins.push_back(static_cast<Index>(this->Order.size()));
  if (!this->Places.empty())
  {
    this->Search = std::make_unique<Tree>(this->Places, execution);
  }
  execution.step("neighbours", 3, 3);
}

Neighbours::~Neighbours() = default;

void Neighbours::nearest(const Vec3& at, std::size_t count, std::vector<Neighbour>& found,
  std::span<const std::uint8_t> isLeftOut) const
{
  found.clear();
  NearestSet set{ found, count, isLeftOut };
  if (this->Search != nullptr && count > 0)
  {
    this->Search->search(at, set);
  }
}

void Neighbours::within(const Vec3& at, double radius, std::vector<Neighbour>& found) const
{
  found.clear();
  WithinSet set{ found, radius * radius };
  if (this->Search != nullptr)
  {
    this->Search->search(at, set);
  }
  std::ranges::sort(found, NearestSet::isNearer);
}

void parallelSteps(Execution& execution, const LoopOfPhase& loop, std::size_t n,
  const std::function<void(std::size_t begin, std::size_t end)>& body, std::size_t grain)
{
  const std::size_t step = 32 * grain;
  for (std::size_t done = 0; done < n; done += step)
  {
    execution.step(loop.phase, loop.loop * n + done, loop.loops * n);
    execution.parallelFor(std::min(step, n - done), grain,
      [&](std::size_t begin, std::size_t end) { body(done + begin, done + end); });
  }
  execution.step(loop.phase, loop.loop + 1, loop.loops);
}

} // namespace scan
