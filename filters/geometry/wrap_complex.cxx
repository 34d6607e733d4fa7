// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/wrap_complex.h"

#include <algorithm>
#include <bit>

namespace scan
{
namespace
{

/// A simplex whose fate is asked for: a tetrahedron, or a free triangle by its canonical facet.
struct Question
{
  bool aboutTet;
  Index name;
};

/// Decides for every interval [L, U] whether it stays: it does when critical or when a coface of L
/// outside the interval stays. The relation is acyclic, so the questions are answered depth first
/// on an explicit stack, each answer remembered.
class Collapse
{
public:
  explicit Collapse(const FlowComplex& flow)
    : Flow(flow)
    , Complex(flow.delaunay())
    , TetFate(Complex.tetCount(), Fate::unknown)
    , TriangleFate(Complex.tetCount(), 0)
  {
  }

  bool stays(Question question)
  {
    this->Pending.assign(1, question);
    Fate fate = Fate::unknown;
    while (!this->Pending.empty())
    {
      const Question top = this->Pending.back();
      fate = this->known(top);
      if (fate == Fate::unknown)
      {
        fate = top.aboutTet ? this->decideTet(top.name) : this->decideTriangle(top.name);
        if (fate == Fate::unknown)
        {
          continue; // a coface was pushed: first things first
        }
        this->remember(top, fate);
      }
      this->Pending.pop_back();
    }
    return fate == Fate::stays;
  }

private:
  enum class Fate : std::uint8_t
  {
    unknown,
    stays,
    goes
  };

  Fate known(Question question) const
  {
    if (question.aboutTet)
    {
      return this->TetFate[question.name];
    }
    return static_cast<Fate>(
      this->TriangleFate[question.name / 4] >> (2 * (question.name % 4)) & 3U);
  }

  void remember(Question question, Fate fate)
  {
    if (question.aboutTet)
    {
      this->TetFate[question.name] = fate;
    }
    else
    {
      this->TriangleFate[question.name / 4] |=
        static_cast<std::uint8_t>(static_cast<unsigned>(fate) << (2 * (question.name % 4)));
    }
  }

  /// The fate if known; otherwise asks and returns unknown.
  Fate ask(Question question)
  {
    const Fate fate = this->known(question);
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
    if (std::popcount(attached) == 1)
    {
      const Index beyond = this->Complex.neighbour(tet, std::countr_zero(attached));
      return beyond == kNone ? Fate::goes : this->ask({ true, beyond });
    }
    // two: all but this tetrahedron around the edge, seen from either of its attached facets
    const auto first = static_cast<unsigned>(std::countr_zero(attached));
    const auto second = static_cast<unsigned>(std::countr_zero(attached & (attached - 1)));
    return this->decideEdge(4 * tet + first, this->Complex.tetrahedra[tet][second], tet, kNone);
  }

  Fate decideTriangle(Facet facet)
  {
    const Index apex = this->Flow.obtuseVertex(facet);
    return apex == kNone ? Fate::stays : this->decideEdge(facet, apex, kNone, facet);
  }

  /// An interval [edge, ownTet] or [edge, ownTriangle] stays when another coface of the edge does.
  Fate decideEdge(Facet start, Index behind, Index ownTet, Facet ownTriangle)
  {
    Question unanswered{ true, kNone };
    const auto goes = [&](Question question)
    {
      const Fate fate = this->known(question);
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
  std::vector<Fate> TetFate;
  std::vector<std::uint8_t> TriangleFate; ///< two bits a facet, at canonical free facets
  std::vector<Question> Pending;
};

} // namespace

WrapComplex collapseFromOutside(const FlowComplex& flow, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  Collapse collapse(flow);
  WrapComplex wrap(flow);
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    if (tet % 65536 == 0)
    {
      execution.step("collapse", tet, complex.tetCount());
    }
    if (collapse.stays({ true, tet }))
    {
      wrap.keepTet(tet);
    }
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      // triangles beside a kept tetrahedron stay anyway
      if (complex.canonical(facet) == facet && flow.isFree(facet) && !wrap.keepsTet(tet) &&
        collapse.stays({ false, facet }))
      {
        wrap.keepTriangle(facet);
      }
    }
  }
  return wrap;
}

std::vector<Segment> keptLines(const WrapComplex& wrap, Execution& execution)
{
  std::vector<Segment> lines;
  const DelaunayComplex& complex = wrap.flow().delaunay();
  for (const CriticalEdge& edge : criticalEdges(wrap.flow(), execution))
  {
    const bool bare = complex.walkWholeEdge(edge.triangle, edge.apex,
      [&](Facet, Facet leaving, Facet) { return !wrap.keepsTriangle(leaving); });
    if (bare && !wrap.keepsTriangle(edge.triangle))
    {
      lines.push_back(edge.vertices);
    }
  }
  return lines;
}

} // namespace scan
