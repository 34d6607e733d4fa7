// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/execution.h"

#include "filters/base/error.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <stdexcept>
#include <thread>

namespace scan
{

Execution::Execution(unsigned threads, CancelToken token, Listener listener)
  : Threads(threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency()))
  , Token(std::move(token))
  , Notify(std::move(listener))
{
}

void Execution::plan(std::vector<Phase> phases)
{
  this->Phases = std::move(phases);
  this->Fraction = 0.0;
}

void Execution::step(std::string_view phase, std::size_t done, std::size_t total)
{
  if (this->cancelled())
  {
    throw Cancelled();
  }
  if (!this->Notify)
  {
    return;
  }
  double before = 0.0;
  double whole = 0.0;
  double own = 0.0;
  for (const Phase& planned : this->Phases)
  {
    if (planned.name == phase)
    {
      before = whole;
      own = planned.weight;
    }
    whole += planned.weight;
  }
  if (own <= 0.0)
  {
    return;
  }
  const double part = total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0;
  this->Fraction = std::max(this->Fraction, (before + own * std::clamp(part, 0.0, 1.0)) / whole);
  this->Notify(phase, this->Fraction);
}

void Execution::runOnThreads(std::size_t n, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
  using Range = tbb::blocked_range<std::size_t>;
  tbb::task_group_context context;
  const auto guarded = [&](const Range& range)
  {
    if (this->cancelled())
    {
      context.cancel_group_execution();
      return;
    }
    body(range.begin(), range.end());
  };
  // more than the machine's would only make TBB complain on stderr
  const int threads = std::min(static_cast<int>(this->Threads), tbb::info::default_concurrency());
  try
  {
    tbb::task_arena arena(threads);
    arena.execute(
      [&] { tbb::parallel_for(Range(0, n, grain), guarded, tbb::simple_partitioner(), context); });
  }
  catch (const Error&)
  {
    throw;
  }
  catch (const std::runtime_error& error) // of TBB, as bodies do not throw: no stack for a thread
  {
    throw Error(ErrorCode::memory,
      std::string("no memory for another thread (") + error.what() +
        "); allow more memory or use --threads=1");
  }
}

void Execution::parallelFor(std::size_t n, std::size_t grain,
  const std::function<void(std::size_t begin, std::size_t end)>& body)
{
  grain = std::max<std::size_t>(grain, 1);
  if (this->Threads == 1 || n <= grain)
  {
    for (std::size_t begin = 0; begin < n && !this->cancelled(); begin += grain)
    {
      body(begin, std::min(n, begin + grain));
    }
  }
  else
  {
    this->runOnThreads(n, grain, body);
  }
  if (this->cancelled())
  {
    throw Cancelled();
  }
}

} // namespace scan
