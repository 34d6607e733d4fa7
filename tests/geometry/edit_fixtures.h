// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model_edit.h"
#include "filters/geometry/wrap.h"

#include <string>
#include <vector>

namespace scan::test
{

/// The points of a file with one point a line.
std::vector<Vec3> readPoints(const std::string& path);

WrapModel wrappedModel(const std::vector<Vec3>& points, WrapOptions::Mode mode);

/// A model of the points' whole Delaunay complex, every tetrahedron kept.
WrapModel wholeModel(const std::vector<Vec3>& points);

/// Boundary triangles seen from the solid, and sheets.
std::vector<Facet> surfaceFacets(const WrapModel& model);

/// The numbers of kept simplices, by brute force: triangles and edges as faces, and lines.
WrapChange countKept(const WrapModel& model);

/// Expects that `now` is a complex in canonical form, without sheets when it is solid, that it
/// differs from `before` as reported, and that the report names the triangles that changed.
void expectReported(const WrapModel& before, const EditReport& report, const WrapModel& now);

} // namespace scan::test
