// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <string>
#include <vector>

namespace quality
{

/// What every method gets.
struct Cloud
{
  std::vector<scan::Vec3> points;
  std::vector<scan::Vec3> normals; ///< as many as points where the file has them, else none
};

/// A way from points to a surface, on one thread.
struct Method
{
  std::string name;
  scan::TriMesh (*reconstruct)(const Cloud& cloud); ///< throws where it has no result
};

/// Ours.
scan::TriMesh automaticWrap(const Cloud& cloud);

/// The rivals, all of CGAL, with the defaults and the parameters of its manual.
/// Cohen-Steiner, Da, "A greedy Delaunay-based surface reconstruction algorithm" (2004).
scan::TriMesh advancingFront(const Cloud& cloud);
/// Digne et al., "Scale space meshing of raw data point sets" (2011): four rounds of smoothing by
/// weighted principal components, then an alpha shape, each triangle once.
scan::TriMesh scaleSpace(const Cloud& cloud);
/// The same with four rounds of jet fitting, then the advancing front.
scan::TriMesh scaleSpaceFront(const Cloud& cloud);
/// Kazhdan, Bolitho, Hoppe, "Poisson surface reconstruction" (2006), on a Delaunay mesh. Normals
/// that are missing are estimated from 18 neighbours by jet fitting and oriented by a minimum
/// spanning tree.
scan::TriMesh poisson(const Cloud& cloud);
/// Portaneri et al., "Alpha wrapping with an offset" (2022): alpha three spacings, offset half a
/// spacing.
scan::TriMesh fineAlphaWrap(const Cloud& cloud);
/// The same with alpha a tenth and offset a three-hundredth of the diagonal.
scan::TriMesh coarseAlphaWrap(const Cloud& cloud);

/// In the order of the tables.
const std::vector<Method>& methods();

} // namespace quality
