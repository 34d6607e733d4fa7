// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model_edit.h"

#include <span>

namespace scan
{

struct WebOptions
{
  /// A sheet triangle is sparse when its circumradius is larger than this many local spacings.
  double factor = 4.0;
};

struct WebReport : EditReport
{
  Index sparse = 0;  ///< sparse triangles removed, without what collapsed after them
  Index hanging = 0; ///< triangles removed that hung over the surface
};

/// Removes webs, sheets that span what was not scanned: first the sparse triangles, larger than the
/// largest local spacing of their three vertices allows, and in classic mode what collapses then.
/// Afterwards, largest first until there are none, triangles that hang over the surface: those
/// with a free edge whose other edges are free too or have three triangles or more. The border of
/// an open sheet, triangles with a free edge and an ordinary one, is no web and stays.
/// Only triangles of the region are chosen; what collapses may lie beyond it. A closed automatic
/// wrap has no sheets and stays as it is.
/// Linear time. Reports phases "edges" and "webs".
WebReport removeWebs(
  WrapModel& model, std::span<const Facet> region, const WebOptions& options, Execution& execution);

} // namespace scan
