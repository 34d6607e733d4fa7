// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>
#include <vector>

namespace scan
{

/// What may be wrong with a surface. What counts as one defect, and as its triangles:
enum class DefectKind : std::uint8_t
{
  nonManifoldEdges,  ///< an edge with three triangles or more; these
  nonManifoldPoints, ///< a point on good edges only with more than one fan of triangles; all there
  selfIntersections, ///< triangles that meet others beyond shared corners, as far as they are next
                     ///< to each other
  degenerate,        ///< a triangle without area: collapsed, on a line, or lower than a height
  duplicates,        ///< triangles with the same points; all but the first
  inverted,          ///< triangles next to each other that face the wrong side: the smaller part of
                     ///< a piece whose neighbours disagree, a closed piece inside out, the seam of
                     ///< a one-sided piece
  spikes,            ///< a point far out of its neighbours (spikes.h); the triangles there
  smallComponents,   ///< a piece with few triangles and little area; these
  smallHoles,        ///< a short rim that is not that of a sheet; the triangles along it
  seams              ///< boundary edges that lie on each other in pairs: the surface is torn; the
                     ///< triangles along it
};

inline constexpr std::size_t kDefectKinds = 10;

/// Stable names, in the order of DefectKind.
inline constexpr std::array<std::string_view, kDefectKinds> kDefectNames{ "non-manifold-edges",
  "non-manifold-points", "self-intersections", "degenerate", "duplicates", "inverted", "spikes",
  "small-components", "small-holes", "seams" };

using DefectKinds = std::bitset<kDefectKinds>;

inline bool has(const DefectKinds& kinds, DefectKind kind)
{
  return kinds[static_cast<std::size_t>(kind)];
}

/// The kinds that a text names: "all", or names with commas between.
/// @throws Error{badParameter} for a name that is none
DefectKinds parseDefectKinds(std::string_view text);

struct DefectOptions
{
  DefectKinds kinds = DefectKinds().set(); ///< that are looked for
  double leastHeight = 0.0;     ///< of a triangle, in model units; 0: exactly none is degenerate
  double spikeRatio = 2.0;      ///< height of a spike over the radius of its ring; above 0
  double smallComponent = 0.01; ///< share of the largest, by triangles and by area: 0 to 1
  double smallHole = 0.0;       ///< length of the rim in model units
};

struct Defect
{
  DefectKind kind = DefectKind::nonManifoldEdges;
  Vec3 place;                   ///< on it
  std::vector<Index> triangles; ///< rising
};

struct DefectList
{
  std::vector<Defect> defects; ///< by kind, then by their first triangle

  std::size_t count(DefectKind kind) const;
  /// The triangles in defects of a kind, each once.
  std::size_t triangles(DefectKind kind) const;
};

/// Looks for what is wrong with a surface of any quality. The list depends on the mesh alone.
/// About two seconds for a million good triangles, half of it for self-intersections.
///
/// Throws Error badInput for a triangle that names a missing point and coordinates that are not
/// finite; Cancelled.
DefectList findDefects(const TriMesh& mesh, const DefectOptions& options, Execution& execution);

} // namespace scan
