// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// A flag that any thread or signal handler may raise; copies share it.
class CancelToken
{
public:
  /// Async-signal-safe.
  void cancel() const noexcept { this->Flag->store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return this->Flag->load(std::memory_order_relaxed); }

private:
  std::shared_ptr<std::atomic<bool>> Flag = std::make_shared<std::atomic<bool>>(false);
};

/// A named part of a run and its share of the run's time, relative to the other phases.
struct Phase
{
  std::string name;
  double weight = 1.0;
};

/// How a kernel talks to whoever runs it: progress, cancel, threads.
///
/// A default Execution is silent, cannot be cancelled from outside and uses every core. Progress
/// reported to the listener is in [0, 1] and never falls. step() and parallelFor() belong to the
/// thread that runs the kernel; the token may be raised from any thread.
class Execution
{
public:
  using Listener = std::function<void(std::string_view phase, double fraction)>;

  /// @param threads number of threads for parallelFor; 0 = all cores
  explicit Execution(unsigned threads = 0, CancelToken token = {}, Listener listener = {});

  /// Declares the phases of the whole run, in order; resets progress to 0.
  void plan(std::vector<Phase> phases);

  /// Reports that `done` of `total` of the named phase are finished and throws Cancelled when
  /// the token is raised. A name that was not planned only checks for cancel.
  void step(std::string_view phase, std::size_t done, std::size_t total);

  bool cancelled() const noexcept { return this->Token.cancelled(); }
  unsigned threads() const noexcept { return this->Threads; }

  /// Calls body(begin, end) over [0, n) in ranges of about `grain`, on up to threads() threads.
  /// Bodies write disjoint data and must not throw; ranges that start after a cancel are skipped.
  /// Throws Cancelled afterwards when the token is raised.
  void parallelFor(std::size_t n, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& body);

private:
  void runOnThreads(std::size_t n, std::size_t grain,
    const std::function<void(std::size_t begin, std::size_t end)>& body);

  unsigned Threads;
  CancelToken Token;
  Listener Notify;
  std::vector<Phase> Phases;
  double Fraction = 0.0;
};

/// Calls body(i) for every i below n, under the terms of parallelFor().
template <class Body>
void parallelForEach(Execution& execution, std::size_t n, std::size_t grain, const Body& body)
{
  execution.parallelFor(n, grain,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        body(i);
      }
    });
}

} // namespace scan
