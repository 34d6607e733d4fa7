// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/execution.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <utility>

using scan::Cancelled;
using scan::CancelToken;
using scan::Execution;

namespace
{

using Report = std::pair<std::string, double>;

std::vector<std::size_t> squares(unsigned threads, std::size_t n)
{
  Execution execution(threads);
  std::vector<std::size_t> result(n);
  execution.parallelFor(n, 100,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        result[i] += i * i;
      }
    });
  return result;
}

} // namespace

TEST(Execution, WeighsPhasesAndEndsAtOne)
{
  std::vector<Report> reports;
  Execution execution(
    1, {}, [&](std::string_view phase, double fraction) { reports.emplace_back(phase, fraction); });
  execution.plan({ { "sort", 1.0 }, { "wrap", 3.0 } });
  execution.step("sort", 1, 2);
  execution.step("sort", 2, 2);
  execution.step("wrap", 1, 2);
  execution.step("wrap", 0, 0); // nothing to do is done
  const std::vector<Report> expected{ { "sort", 0.125 }, { "sort", 0.25 }, { "wrap", 0.625 },
    { "wrap", 1.0 } };
  EXPECT_EQ(reports, expected);
}

TEST(Execution, ProgressNeverFallsAndStaysInRange)
{
  double last = 0.0;
  Execution execution(1, {},
    [&](std::string_view, double fraction)
    {
      EXPECT_GE(fraction, last);
      EXPECT_LE(fraction, 1.0);
      last = fraction;
    });
  execution.plan({ { "a" }, { "b" } });
  execution.step("b", 1, 2);
  execution.step("a", 1, 2); // a loop between phases
  execution.step("b", 9, 2); // a miscount
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(Execution, UnplannedStepIsSilentButCancels)
{
  const CancelToken token;
  int reports = 0;
  Execution execution(1, token, [&](std::string_view, double) { ++reports; });
  execution.plan({ { "a" } });
  execution.step("inner", 1, 2);
  EXPECT_EQ(reports, 0);
  token.cancel();
  EXPECT_THROW(execution.step("inner", 2, 2), Cancelled);
}

TEST(Execution, CancelledBeforeTheStartDoesNoWork)
{
  for (const unsigned threads : { 1U, 4U })
  {
    const CancelToken token;
    token.cancel();
    Execution execution(threads, token);
    std::atomic<int> calls = 0;
    EXPECT_THROW(
      execution.parallelFor(1000, 1, [&](std::size_t, std::size_t) { ++calls; }), Cancelled);
    EXPECT_EQ(calls, 0);
  }
}

TEST(Execution, CancelFromAnotherThreadStopsTheLoop)
{
  for (const unsigned threads : { 1U, 4U })
  {
    const CancelToken token;
    Execution execution(threads, token);
    std::atomic<bool> started = false;
    std::thread user(
      [&]
      {
        while (!started)
        {
          std::this_thread::yield();
        }
        token.cancel();
      });
    const std::size_t endless = std::size_t{ 1 } << 40U;
    EXPECT_THROW(
      execution.parallelFor(endless, 1, [&](std::size_t, std::size_t) { started = true; }),
      Cancelled);
    user.join();
  }
}

TEST(Execution, ParallelForGivesTheSameOnAnyNumberOfThreads)
{
  std::vector<std::size_t> expected(10007);
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    expected[i] = i * i;
  }
  for (const unsigned threads : { 0U, 1U, 2U, 7U })
  {
    EXPECT_EQ(squares(threads, expected.size()), expected) << threads << " threads";
  }
  EXPECT_TRUE(squares(2, 0).empty());
}
