// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/delaunay_worker.h"

#include "filters/geometry/delaunay_predicates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <tuple>

namespace scan
{
namespace
{

/// Corners of a triangle after the j-th: kNext[j], kNext[j + 1].
constexpr std::array<int, 4> kNext{ 1, 2, 0, 1 };

} // namespace

inline Index DelaunayWorker::Numbering::operator()(Index vertex)
{
  const std::uint64_t key = this->Round | vertex;
  for (Index place = vertex;; ++place)
  {
    Slot& slot = this->Slots[place % this->Slots.size()];
    if (slot.key == key)
    {
      return slot.number;
    }
    if (slot.key < this->Round) // of an earlier round
    {
      if (this->Count < kMost)
      {
        slot = { key, this->Count++ };
        return slot.number;
      }
      return kMost;
    }
  }
}

DelaunayWorker::DelaunayWorker(DelaunayCells& cells, unsigned number)
  : All(cells)
  , Held(static_cast<std::uint16_t>(2 * number + 1))
  , InCavity(static_cast<std::uint16_t>(2 * number + 2))
{
}

bool DelaunayWorker::insert(Index vertex, bool alone)
{
  this->Alone = alone;
  this->Cavity.clear();
  this->Rim.clear();
  this->Boundary.clear();
  this->Fresh.clear();
  const Vec3& p = this->All.points[vertex];
  Index first = kNone;
  const bool done = this->locate(p, first) && this->findCavity(first, p) &&
    this->haveFreeCells(this->Boundary.size());
  if (done)
  {
    this->fillCavity(vertex);
  }
  this->release(done);
  return done;
}

inline bool DelaunayWorker::acquire(Index cell)
{
  const std::atomic_ref mark(this->All.marks[cell]);
  if (this->Alone)
  {
    mark.store(this->Held, std::memory_order_relaxed);
    return true;
  }
  std::uint16_t nobody = 0;
  return mark.load(std::memory_order_relaxed) == nobody &&
    mark.compare_exchange_strong(
      nobody, this->Held, std::memory_order_acquire, std::memory_order_relaxed);
}

inline void DelaunayWorker::setMark(Index cell, std::uint16_t mark)
{
  std::atomic_ref(this->All.marks[cell]).store(mark, std::memory_order_release);
}

/// Lets go of a cell for the next one; of both when that is held by another worker.
inline bool DelaunayWorker::moveTo(Index& cell, Index next)
{
  const bool acquired = this->acquire(next);
  this->setMark(cell, 0);
  cell = next;
  return acquired;
}

/// The facet, other than the one entered through, that parts the cell from p; -1 when p is inside.
int DelaunayWorker::facetBefore(const DelaunayCell& cell, const Vec3& p, int entered) const
{
  const auto corner = [&](int k) -> const Vec3& { return this->All.points[cell.vertices[k]]; };
  const std::array<Vec3, 4> to{ corner(0) - p, corner(1) - p, corner(2) - p, corner(3) - p };
  const auto extent = [&](auto axis)
  {
    return std::max({ std::abs(to[0].*axis), std::abs(to[1].*axis), std::abs(to[2].*axis),
      std::abs(to[3].*axis) });
  };
  const double x = extent(&Vec3::x);
  const double y = extent(&Vec3::y);
  const double z = extent(&Vec3::z);
  const double error = std::min({ x, y, z }) > kSmallestExtent
    ? kVolumeError * x * y * z
    : std::numeric_limits<double>::infinity();
  for (int k = 0; k < 4; ++k)
  {
    if (k == entered)
    {
      continue;
    }
    const auto& f = kFacetVertices[k];
    const double volume = dot(to[f[0]], cross(to[f[1]], to[f[2]]));
    if (volume < -error ||
      (volume <= error && orientation(corner(f[0]), corner(f[1]), corner(f[2]), p) > 0))
    {
      return k;
    }
  }
  return -1;
}

/// Takes hold of the cell that was made last, or of one near it when another worker has it.
bool DelaunayWorker::acquireHint()
{
  const std::size_t count = std::min<std::size_t>(this->All.used(), this->All.cells.size());
  for (std::size_t attempt = 0; attempt < count; ++attempt)
  {
    const bool isFree = this->Alone && this->All.cells[this->Hint].isFree();
    if (!isFree && this->acquire(this->Hint))
    {
      return true;
    }
    this->Hint = static_cast<Index>((this->Hint + 1) % count);
  }
  return false;
}

/// Walks from the last inserted point towards p; `found` is held then, and in conflict with p.
bool DelaunayWorker::locate(const Vec3& p, Index& found)
{
  const auto cell = [&]() -> const DelaunayCell& { return this->All.cells[found]; };
  if (!this->acquireHint())
  {
    return false;
  }
  found = this->Hint;
  if (!cell().isTetrahedron() && !this->moveTo(found, cell().mirror[3] / 4))
  {
    return false;
  }
  for (int entered = -1; cell().isTetrahedron();)
  {
    const int next = this->facetBefore(cell(), p, entered);
    if (next < 0)
    {
      return true;
    }
    const Facet beyond = cell().mirror[next];
    if (!this->moveTo(found, beyond / 4))
    {
      return false;
    }
    entered = static_cast<int>(beyond % 4);
  }
  return true; // beyond a hull triangle
}

/// Is p inside the cell's circumsphere? At infinity that is the half space beyond the hull
/// triangle; in its plane the tetrahedron behind decides, whose sphere meets the plane in the same
/// circle.
bool DelaunayWorker::inConflict(const DelaunayCell& cell, const Vec3& p) const
{
  const Vec3* const points = this->All.points.data();
  const auto& v = cell.vertices;
  if (cell.isTetrahedron())
  {
    return insideCircumsphere(points[v[0]], points[v[1]], points[v[2]], points[v[3]], p);
  }
  const int side = orientation(points[v[0]], points[v[1]], points[v[2]], p);
  return side != 0 ? side > 0 : this->inConflict(this->All.cells[cell.mirror[3] / 4], p);
}

/// All cells in conflict with p hang together: spreads from the first one.
bool DelaunayWorker::findCavity(Index first, const Vec3& p)
{
  const DelaunayCell* const cells = this->All.cells.data();
  const auto addToCavity = [&](Index cell)
  {
    std::atomic_ref(this->All.marks[cell]).store(this->InCavity, std::memory_order_relaxed);
    this->Cavity.push_back(cell);
    for (const Facet beyond : cells[cell].mirror) // will be needed soon
    {
      __builtin_prefetch(&cells[beyond / 4]);
    }
  };
  addToCavity(first);
  for (std::size_t i = 0; i < this->Cavity.size(); ++i)
  {
    const Index cell = this->Cavity[i];
    for (Facet k = 0; k < 4; ++k)
    {
      const Index next = cells[cell].mirror[k] / 4;
      const std::uint16_t mark =
        std::atomic_ref(this->All.marks[next]).load(std::memory_order_relaxed);
      if (mark == this->InCavity)
      {
        continue;
      }
      if (mark != this->Held)
      {
        if (!this->acquire(next))
        {
          return false;
        }
        if (this->inConflict(cells[next], p))
        {
          addToCavity(next);
          continue;
        }
        this->Rim.push_back(next);
      }
      this->Boundary.push_back(4 * cell + k);
    }
  }
  return true;
}

bool DelaunayWorker::haveFreeCells(std::size_t count)
{
  while (this->Free.size() < count)
  {
    if (this->Alone)
    {
      this->All.makeRoom(DelaunayCells::kBlock);
    }
    const Index block = this->All.takeBlock();
    if (block == kNone)
    {
      return false;
    }
    for (Index cell = block + DelaunayCells::kBlock; cell-- > block;)
    {
      this->Free.push_back(cell);
    }
  }
  return true;
}

/// Joins the vertex to the facets around the cavity.
void DelaunayWorker::fillCavity(Index vertex)
{
  DelaunayCell* const cells = this->All.cells.data();
  for (const Facet facet : this->Boundary)
  {
    const Index fresh = this->Free.back();
    this->Free.pop_back();
    this->setMark(fresh, this->Held);
    this->Fresh.push_back(fresh);
    const Facet k = facet % 4;
    const Facet outside = cells[facet / 4].mirror[k];
    DelaunayCell& cell = cells[fresh];
    cell.vertices = cells[facet / 4].vertices;
    cell.vertices[k] = vertex;
    cell.mirror[k] = outside;
    cells[outside / 4].mirror[outside % 4] = 4 * fresh + k;
    this->Hint = cell.isTetrahedron() ? fresh : this->Hint;
  }
  if (!this->linkThroughTable())
  {
    this->linkBySorting();
  }
  for (const Index cell : this->Cavity)
  {
    cells[cell].setFree();
    this->Free.push_back(cell);
  }
}

/// Two new cells meet at each edge of the boundary. Facets there run along it in opposite
/// directions. Returns false, without a change, when the cavity has too many vertices.
bool DelaunayWorker::linkThroughTable()
{
  DelaunayCell* const cells = this->All.cells.data();
  this->NumberOf.reset();
  this->Corners.resize(this->Boundary.size());
  for (std::size_t i = 0; i < this->Boundary.size(); ++i)
  {
    const auto& f = kFacetVertices[this->Boundary[i] % 4];
    const Index fresh = this->Fresh[i];
    auto& corner = this->Corners[i];
    for (int j = 0; j < 3; ++j)
    {
      corner[j] = this->NumberOf(cells[fresh].vertices[f[j]]);
      if (corner[j] == Numbering::kMost)
      {
        return false;
      }
    }
    for (int j = 0; j < 3; ++j)
    {
      this->facetAt(corner[kNext[j]], corner[kNext[j + 1]]) = 4 * fresh + static_cast<Facet>(f[j]);
    }
  }
  for (std::size_t i = 0; i < this->Boundary.size(); ++i)
  {
    const auto& f = kFacetVertices[this->Boundary[i] % 4];
    const auto& corner = this->Corners[i];
    for (int j = 0; j < 3; ++j)
    {
      cells[this->Fresh[i]].mirror[f[j]] = this->facetAt(corner[kNext[j + 1]], corner[kNext[j]]);
    }
  }
  return true;
}

/// The same for any number of vertices.
void DelaunayWorker::linkBySorting()
{
  DelaunayCell* const cells = this->All.cells.data();
  std::vector<std::tuple<Index, Index, Facet>> edges;
  for (std::size_t i = 0; i < this->Boundary.size(); ++i)
  {
    const auto& f = kFacetVertices[this->Boundary[i] % 4];
    const Index fresh = this->Fresh[i];
    for (int j = 0; j < 3; ++j)
    {
      const auto [low, high] =
        std::minmax({ cells[fresh].vertices[f[kNext[j]]], cells[fresh].vertices[f[kNext[j + 1]]] });
      edges.emplace_back(low, high, 4 * fresh + static_cast<Facet>(f[j]));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size(); i += 2)
  {
    const Facet one = std::get<2>(edges[i]);
    const Facet other = std::get<2>(edges[i + 1]);
    cells[one / 4].mirror[one % 4] = other;
    cells[other / 4].mirror[other % 4] = one;
  }
}

/// Lets go of all cells, but of those that are free now.
void DelaunayWorker::release(bool done)
{
  for (const auto* held : { done ? &this->Fresh : &this->Cavity, &this->Rim })
  {
    for (const Index cell : *held)
    {
      this->setMark(cell, 0);
    }
  }
}

} // namespace scan
