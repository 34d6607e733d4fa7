// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/bulk_collapse.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/interval_fates.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace scan
{
namespace
{

constexpr std::size_t kChunk = 1 << 12;

enum class Event : std::uint8_t
{
  tetGoes,
  triangleStays,
  triangleGoes
};

struct Found
{
  Event event;
  Index name;
};

/// One removal: marks what is in question, then asks for each of them.
class BulkCollapse
{
public:
  BulkCollapse(const WrapComplex& kept, const Blocks& blocks, std::span<const Index> volumes,
    std::span<const Facet> doors)
    : Kept(kept)
    , Flow(kept.flow())
    , Complex(Flow.delaunay())
    , Doors(doors)
    , BasinOf(blocks.basins().ofTet)
    , IsHeld(blocks.outside(), 0)
    , Fates(Complex.tetCount())
  {
    for (Index basin = 0; basin < blocks.outside(); ++basin)
    {
      this->IsHeld[basin] = blocks.isVolume(basin) && kept.keepsTet(blocks.sink(basin)) ? 1 : 0;
    }
    for (const Index volume : volumes)
    {
      this->IsHeld[volume] = 0;
    }
  }

  BulkLoss find(Execution& execution)
  {
    const std::vector<Index> questionable = this->findQuestionable(execution);
    BulkLoss loss;
    std::vector<std::vector<Found>> found((questionable.size() + kChunk - 1) / kChunk);
    execution.parallelFor(found.size(), 1,
      [&](std::size_t begin, std::size_t end)
      {
        FateSearch search(this->Flow, this->Fates, &this->Kept, this->Doors);
        for (std::size_t i = kChunk * begin; i < std::min(kChunk * end, questionable.size()); ++i)
        {
          this->ask(questionable[i], search, found[i / kChunk]);
        }
      });
    for (const std::vector<Found>& part : found)
    {
      for (const Found& one : part)
      {
        (one.event == Event::tetGoes            ? loss.tets
            : one.event == Event::triangleStays ? loss.bared
                                                : loss.free)
          .push_back(one.name);
      }
    }
    return loss;
  }

private:
  /// Remembers the fate of all tetrahedra that is clear at once. Returns the others, and those that
  /// give their names to sheets.
  std::vector<Index> findQuestionable(Execution& execution)
  {
    return collect<Index>(this->Complex.tetCount(), execution,
      [&](Index tet, auto& found)
      {
        // without branches that nobody can foretell
        const unsigned isKept = this->Kept.keepsTet(tet) ? 1 : 0;
        const unsigned isOpen = isKept & (this->IsHeld[this->BasinOf[tet]] ^ 1U);
        constexpr std::array<Fate, 4> kFates{ Fate::goes, Fate::stays, Fate::unknown,
          Fate::unknown };
        this->Fates.remember({ true, tet }, kFates[2 * isOpen + isKept]);
        if ((isOpen | this->Kept.sheetsNamedAfter(tet)) != 0)
        {
          if (isOpen != 0 && this->Flow.isSink(tet))
          {
            this->Fates.remember({ true, tet }, Fate::goes);
          }
          found.push_back(tet);
        }
      });
  }

  void ask(Index tet, FateSearch& search, std::vector<Found>& found) const
  {
    if (!this->Kept.keepsTet(tet))
    {
      for (unsigned rest = this->Kept.sheetsNamedAfter(tet); rest != 0; rest &= rest - 1)
      {
        const Facet sheet = 4 * tet + static_cast<Facet>(std::countr_zero(rest));
        if (!search.stays({ false, sheet }))
        {
          found.push_back({ Event::triangleGoes, sheet });
        }
      }
    }
    else if (!search.stays({ true, tet }))
    {
      found.push_back({ Event::tetGoes, tet });
      this->askFacets(tet, search, found);
    }
  }

  /// Free facets of a tetrahedron that goes; of two that go the first one speaks for both.
  void askFacets(Index tet, FateSearch& search, std::vector<Found>& found) const
  {
    for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
    {
      const Index beyond = this->Complex.neighbour(tet, static_cast<int>(facet % 4));
      const bool isOther = beyond != kNone && beyond < tet && this->Kept.keepsTet(beyond);
      if (isOther || !this->Flow.isFree(facet) ||
        (beyond != kNone && search.stays({ true, beyond })))
      {
        continue;
      }
      const Facet name = this->Complex.canonical(facet);
      found.push_back(
        { search.stays({ false, name }) ? Event::triangleStays : Event::triangleGoes, name });
    }
  }

  const WrapComplex& Kept;
  const FlowComplex& Flow;
  const DelaunayComplex& Complex;
  std::span<const Facet> Doors;
  const std::vector<Index>& BasinOf;
  std::vector<std::uint8_t> IsHeld; ///< per basin: its sink stays
  IntervalFates Fates;
};

} // namespace

BulkLoss findBulkLoss(const WrapComplex& kept, const Blocks& blocks, std::span<const Index> volumes,
  std::span<const Facet> doors, Execution& execution)
{
  return BulkCollapse(kept, blocks, volumes, doors).find(execution);
}

} // namespace scan
