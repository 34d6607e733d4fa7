// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/automatic_wrap.h"

#include "filters/geometry/basin_refinement.h"
#include "filters/geometry/collect.h"
#include "filters/geometry/fine_tune.h"
#include "filters/geometry/rooms.h"
#include "filters/geometry/scan_spacing.h"

namespace scan
{
namespace
{

/// The triangles between inside and outside, seen from inside.
std::vector<Facet> cutOf(
  const DelaunayComplex& complex, const std::vector<std::uint8_t>& inside, Execution& execution)
{
  return collect<Facet>(complex.tetCount(), execution,
    [&](Index tet, auto& found)
    {
      for (int k = 0; inside[tet] && k < 4; ++k)
      {
        const Index beyond = complex.neighbour(tet, k);
        if (beyond == kNone || !inside[beyond])
        {
          found.push_back(4 * tet + static_cast<Facet>(k));
        }
      }
    });
}

} // namespace

std::vector<Phase> automaticWrapPhases(const AutomaticWrapOptions& options)
{
  std::vector<Phase> phases{ { "edges", 1.0 }, { "walls", 0.3 }, { "rooms", 1.0 },
    { "refine", 2.0 } };
  if (options.fineTune)
  {
    phases.push_back({ "fine-tune", 1.0 });
  }
  return phases;
}

AutomaticWrap wrapAutomatically(const FlowComplex& flow, const Basins& basins,
  const AutomaticWrapOptions& options, Execution& execution)
{
  const DelaunayComplex& complex = flow.delaunay();
  const std::vector<float> spacing = localSpacing(flow, execution);
  const std::vector<Wall> walls = findWalls(flow, basins, execution);
  const std::vector<std::uint8_t> insideBasin = refineBasins(
    flow, basins, walls, spacing, persistentRooms(flow, basins, walls, execution), execution);

  AutomaticWrap wrap;
  wrap.inside.resize(complex.tetCount());
  for (Index tet = 0; tet < complex.tetCount(); ++tet)
  {
    wrap.inside[tet] = insideBasin[basins.ofTet[tet]];
  }
  if (options.fineTune)
  {
    wrap.inside = fineTune(flow, spacing, std::move(wrap.inside), execution);
  }
  wrap.surface = cutOf(complex, wrap.inside, execution);
  return wrap;
}

} // namespace scan
