// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/facet_marks.h"
#include "filters/geometry/holders.h"
#include "filters/geometry/relaxed.h"

#include <cstdint>
#include <vector>

namespace scan
{

enum class Fate : std::uint8_t
{
  unknown,
  stays,
  goes
};

/// The answers so far, shared by all threads. Whoever asks gets the same answer, so it does no harm
/// when two threads work one out at the same time.
class IntervalFates
{
public:
  explicit IntervalFates(Index tetCount)
    : OfTet(tetCount, 0)
    , OfTriangle(tetCount)
  {
  }

  Fate known(Upper upper) const
  {
    return static_cast<Fate>(
      upper.isTet ? loadRelaxed(this->OfTet[upper.name]) : this->OfTriangle.at(upper.name));
  }

  void remember(Upper upper, Fate fate)
  {
    const auto stored = static_cast<std::uint8_t>(fate);
    if (upper.isTet)
    {
      storeRelaxed(this->OfTet[upper.name], stored);
    }
    else
    {
      this->OfTriangle.set(upper.name, stored);
    }
  }

private:
  std::vector<std::uint8_t> OfTet;
  FacetMarks OfTriangle; ///< at canonical free facets
};

/// Decides for intervals whether they stay: they do when critical or when a holder stays. The
/// relation is acyclic, so the questions are answered depth first on an explicit stack, each answer
/// remembered.
class FateSearch
{
public:
  FateSearch(const FlowComplex& flow, IntervalFates& fates)
    : Flow(flow)
    , Answers(fates)
  {
  }

  bool stays(Upper upper)
  {
    this->Pending.assign(1, upper);
    Fate fate = Fate::unknown;
    while (!this->Pending.empty())
    {
      const Upper top = this->Pending.back();
      fate = this->Answers.known(top);
      if (fate == Fate::unknown)
      {
        fate = this->decide(top);
        if (fate == Fate::unknown)
        {
          continue; // a holder was pushed: first things first
        }
        this->Answers.remember(top, fate);
      }
      this->Pending.pop_back();
    }
    return fate == Fate::stays;
  }

private:
  Fate decide(Upper upper)
  {
    if (upper.isTet ? this->Flow.isSink(upper.name) : !this->Flow.isObtuse(upper.name))
    {
      return Fate::stays;
    }
    Upper unanswered{ true, kNone };
    const auto goes = [&](Upper holder)
    {
      const Fate fate = this->Answers.known(holder);
      unanswered = fate == Fate::unknown ? holder : unanswered;
      return fate != Fate::stays;
    };
    if (!forEachNearHolder(this->Flow, upper, goes))
    {
      return Fate::stays;
    }
    if (unanswered.name == kNone && !forEachHolderAround(this->Flow, upper, goes))
    {
      return Fate::stays;
    }
    if (unanswered.name == kNone)
    {
      return Fate::goes;
    }
    this->Pending.push_back(unanswered); // the near ones usually settle it
    return Fate::unknown;
  }

  const FlowComplex& Flow;
  IntervalFates& Answers;
  std::vector<Upper> Pending;
};

} // namespace scan
