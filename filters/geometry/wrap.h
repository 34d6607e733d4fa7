// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/automatic_wrap.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/wrap_model.h"

#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace scan
{

struct WrapOptions
{
  enum class Mode
  {
    automatic, ///< the pushes a person would make, found by one objective
    classic,   ///< the initial Wrap complex, the start for pushing by hand
    front      ///< CGAL's advancing front over the same points, for comparison
  };
  enum class Fit
  {
    all,   ///< single tetrahedra flip at the end: through as many points as possible
    robust ///< whole basins only: smoother on noisy scans
  };

  Mode mode = Mode::automatic;
  Fit fit = Fit::all;                   ///< automatic mode only
  Opening opening = Opening::automatic; ///< automatic mode only
  bool manifold = true; ///< split non-manifold edges and vertices into separate sheets

  /// Classic mode only: everything that one reaches from outside through doors wider than this
  /// radius is removed, and webs with a larger radius. Infinite: nothing.
  double size = std::numeric_limits<double>::infinity();
};

/// What happened to the points; nothing is dropped silently.
struct WrapReport
{
  Index pointsRead = 0;
  Index duplicatesMerged = 0;  ///< points with exactly the coordinates of an earlier one
  Index pointsOnSurface = 0;   ///< distinct scan points that the surface passes through
  Index tetrahedra = 0;        ///< of the Delaunay complex
  Index tetrahedraKept = 0;    ///< inside the surface
  Index boundaryTriangles = 0; ///< triangles with exactly one kept tetrahedron
  Index sheetTriangles = 0;    ///< kept triangles with no kept tetrahedron
  bool isOpen = false;         ///< automatic mode: the open result was the better one, or asked for
  Index openingTriangles = 0;  ///< that span openings of the scan and were left out
  Index nonManifoldEdges = 0;  ///< edges split into separate sheets
  Index nonManifoldVertices = 0; ///< vertices split into separate fans
};

struct WrapResult
{
  WrapModel model;
  TriMesh surface;                 ///< only used points; boundary triangles face outward,
                                   ///< sheets are oriented consistently where they can be
  std::vector<Facet> facets;       ///< per triangle: its facet; at a boundary seen from the solid
  std::vector<Index> scanPointIds; ///< per surface point: index of its scan point in the input
  std::vector<Segment> lines;      ///< kept edges without a kept triangle (classic mode)
  bool isSplit = false;            ///< into sheets that are manifold
  WrapReport report;
};

/// The phases that wrap() reports, for Execution::plan.
std::vector<Phase> wrapPhases(const WrapOptions& options);

/// Surface of a scan as a subcomplex of the Delaunay complex of its points: no normals, no density.
///
/// Guarantee: every triangle is a Delaunay triangle of the distinct input points; shared vertices,
/// no cracks; automatic mode gives closed surfaces unless the scan is open. With `manifold` the
/// result is a 2-manifold with or without boundary. The same input gives the same bytes on any
/// number of threads.
/// @param points finite coordinates with absolute values up to 1e50, in model units
/// @throws Error badInput when fewer than four points, or all of them in one plane; Cancelled
/// Time and memory: nearly linear for points on surfaces, about 0.6 kB a point.
/// Edelsbrunner, "Surface reconstruction by wrapping finite sets in space" (2003).
WrapResult wrap(std::span<const Vec3> points, const WrapOptions& options, Execution& execution);

/// The same for a complex that exists already. Reports all phases but those of ScanComplex.
WrapResult wrap(
  std::shared_ptr<const ScanComplex> scan, const WrapOptions& options, Execution& execution);

/// The surface of a model as it is now. Reports phase "surface".
WrapResult surfaceOf(const WrapModel& model, bool manifold, Execution& execution);

} // namespace scan
