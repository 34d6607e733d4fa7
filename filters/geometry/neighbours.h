// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace scan
{

/// A place that a search found.
struct Neighbour
{
  Index place = 0;
  double squaredDistance = 0.0;
};

/// The places where points are, and searches among them. Equal points are one place, so that
/// repeated points neither count twice nor slow a search down. Places are numbered along a Hilbert
/// curve: what is near by number is near in space. The numbers depend on the points alone.
///
/// About a second and 70 bytes a point for a million. Searches may run on many threads.
class Neighbours
{
public:
  /// @throws Error{badInput} for points that are not finite; Cancelled
  Neighbours(std::span<const Vec3> points, Execution& execution);
  ~Neighbours();
  Neighbours(const Neighbours&) = delete;
  Neighbours& operator=(const Neighbours&) = delete;

  Index size() const { return static_cast<Index>(this->Places.size()); }
  const Vec3& operator[](Index place) const { return this->Places[place]; }

  /// The points at a place, rising.
  std::span<const Index> pointsAt(Index place) const
  {
    return { this->Order.data() + this->Begins[place],
      this->Order.data() + this->Begins[place + 1] };
  }

  /// The `count` places nearest to `at`, or all where there are fewer, nearest first and equally
  /// near ones by number. A place finds itself.
  /// @param isLeftOut per place, 1 for those that do not count; empty for none
  void nearest(const Vec3& at, std::size_t count, std::vector<Neighbour>& found,
    std::span<const std::uint8_t> isLeftOut = {}) const;

  /// The places nearer to `at` than `radius`, in the same order.
  void within(const Vec3& at, double radius, std::vector<Neighbour>& found) const;

private:
  class Tree;
  std::vector<Index> Order;  // of the points, place by place
  std::vector<Index> Begins; // per place in Order, and the end
  std::vector<Vec3> Places;
  std::unique_ptr<Tree> Search;
};

/// Of loops that make a phase, one after the other.
struct LoopOfPhase
{
  std::string_view phase;
  std::size_t loop = 0; ///< from 0
  std::size_t loops = 1;
};

/// Calls body(begin, end) over [0, n) on all threads and reports progress of the phase on the way.
/// @param grain how many are worth a task
void parallelSteps(Execution& execution, const LoopOfPhase& loop, std::size_t n,
  const std::function<void(std::size_t begin, std::size_t end)>& body,
  std::size_t grain = 1U << 10U);

} // namespace scan
