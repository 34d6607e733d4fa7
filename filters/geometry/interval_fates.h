// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/flow_complex.h"
#include "filters/geometry/wrap_complex.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace scan
{

/// A simplex whose fate is asked for: a tetrahedron, or a free triangle by its canonical facet.
struct Question
{
  bool aboutTet;
  Index name;
};

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
    , OfTriangle(tetCount, 0)
  {
  }

  Fate known(Question question) const
  {
    const std::uint8_t stored = question.aboutTet
      ? load(this->OfTet[question.name])
      : load(this->OfTriangle[question.name / 4]) >> (2 * (question.name % 4)) & 3U;
    return static_cast<Fate>(stored);
  }

  void remember(Question question, Fate fate)
  {
    const auto stored = static_cast<unsigned>(fate);
    if (question.aboutTet)
    {
      std::atomic_ref(this->OfTet[question.name])
        .store(static_cast<std::uint8_t>(stored), std::memory_order_relaxed);
    }
    else
    {
      std::atomic_ref(this->OfTriangle[question.name / 4])
        .fetch_or(static_cast<std::uint8_t>(stored << (2 * (question.name % 4))),
          std::memory_order_relaxed);
    }
  }

private:
  static std::uint8_t load(const std::uint8_t& place)
  {
    return std::atomic_ref(const_cast<std::uint8_t&>(place)).load(std::memory_order_relaxed);
  }

  std::vector<std::uint8_t> OfTet;
  std::vector<std::uint8_t> OfTriangle; ///< two bits a facet, at canonical free facets
};

/// Decides for intervals [L, U] whether they stay: they do when critical or when a coface of L
/// outside the interval stays. The relation is acyclic, so the questions are answered depth first
/// on an explicit stack, each answer remembered.
class FateSearch
{
public:
  /// @param within what is kept so far, where that is not everything: triangles that are not in it
  /// are gone. The fates of its tetrahedra are to be remembered beforehand.
  /// @param doors critical triangles, in increasing order, that go when both of their sides do
  FateSearch(const FlowComplex& flow, IntervalFates& fates, const WrapComplex* within = nullptr,
    std::span<const Facet> doors = {})
    : Flow(flow)
    , Complex(flow.delaunay())
    , Answers(fates)
    , Within(within)
    , Doors(doors)
  {
  }

  bool stays(Question question)
  {
    this->Pending.assign(1, question);
    Fate fate = Fate::unknown;
    while (!this->Pending.empty())
    {
      const Question top = this->Pending.back();
      fate = this->Answers.known(top);
      if (fate == Fate::unknown)
      {
        fate = top.aboutTet ? this->decideTet(top.name) : this->decideTriangle(top.name);
        if (fate == Fate::unknown)
        {
          continue; // a coface was pushed: first things first
        }
        this->Answers.remember(top, fate);
      }
      this->Pending.pop_back();
    }
    return fate == Fate::stays;
  }

private:
  /// The fate if known; otherwise asks and returns unknown.
  Fate ask(Question question)
  {
    const Fate fate = this->Answers.known(question);
    if (fate == Fate::unknown)
    {
      this->Pending.push_back(question);
    }
    return fate;
  }

  Fate decideTet(Index tet)
  {
    const unsigned attached = this->Flow.attachedFacets(tet);
    if (attached == 0)
    {
      return Fate::stays;
    }
    // the tetrahedra beyond attached facets are cofaces too, and usually settle it
    for (unsigned rest = attached; rest != 0; rest &= rest - 1)
    {
      const Index beyond = this->Complex.neighbour(tet, std::countr_zero(rest));
      const Fate fate = beyond == kNone ? Fate::goes : this->ask({ true, beyond });
      if (fate != Fate::goes)
      {
        return fate;
      }
    }
    if (std::popcount(attached) == 1)
    {
      return Fate::goes;
    }
    // two: everything else around their edge, seen from either of them
    const auto first = static_cast<unsigned>(std::countr_zero(attached));
    const auto second = static_cast<unsigned>(std::countr_zero(attached & (attached - 1)));
    return this->decideEdge(4 * tet + first, this->Complex.tetrahedra[tet][second], tet, kNone);
  }

  Fate decideTriangle(Facet facet)
  {
    if (this->Within != nullptr && !this->Within->keepsTriangle(facet))
    {
      return Fate::goes;
    }
    const Index apex = this->Flow.obtuseVertex(facet);
    if (apex != kNone)
    {
      return this->decideEdge(facet, apex, kNone, facet);
    }
    return std::ranges::binary_search(this->Doors, facet) ? this->decideDoor(facet) : Fate::stays;
  }

  Fate decideDoor(Facet facet)
  {
    const Fate fate = this->ask({ true, facet / 4 });
    const Facet mirror = this->Complex.mirror[facet / 4][facet % 4];
    return fate != Fate::goes || mirror == kNone ? fate : this->ask({ true, mirror / 4 });
  }

  /// An interval [edge, ownTet] or [edge, ownTriangle] stays when another coface of the edge does.
  Fate decideEdge(Facet start, Index behind, Index ownTet, Facet ownTriangle)
  {
    Question unanswered{ true, kNone };
    const auto goes = [&](Question question)
    {
      const Fate fate = this->Answers.known(question);
      if (fate == Fate::unknown)
      {
        unanswered = question;
      }
      return fate != Fate::stays;
    };
    const bool noneStays = this->Complex.walkWholeEdge(start, behind,
      [&](Facet entering, Facet leaving, Facet)
      {
        if (entering / 4 != ownTet && !goes({ true, entering / 4 }))
        {
          return false;
        }
        const Facet name = this->Complex.canonical(leaving);
        return name == ownTriangle || !this->Flow.isFree(name) || goes({ false, name });
      });
    if (!noneStays)
    {
      return Fate::stays;
    }
    if (unanswered.name != kNone)
    {
      this->Pending.push_back(unanswered);
      return Fate::unknown;
    }
    return Fate::goes;
  }

  const FlowComplex& Flow;
  const DelaunayComplex& Complex;
  IntervalFates& Answers;
  const WrapComplex* Within;
  std::span<const Facet> Doors;
  std::vector<Question> Pending;
};

} // namespace scan
