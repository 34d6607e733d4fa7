// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <string>
#include <vector>

namespace scan
{

/// A closed surface in one piece. Its triangles face away from the material.
struct ClosedShell
{
  TriMesh mesh;            ///< every point is used
  std::vector<Index> mate; ///< per half-edge: the one on the other side of the edge
};

/// A piece of material: what is inside the first shell and outside the others.
struct SolidBody
{
  ClosedShell outer;
  std::vector<ClosedShell> voids;
};

/// The bodies that a mesh bounds, ordered by the first triangles of their outer shells. A shell
/// that faces inwards is a void of the smallest body around it; where there is none it is turned.
///
/// Throws Error badInput unless the mesh is closed, oriented and manifold and every triangle has
/// area. Phase "write", for cancel.
/// @param name what the errors are about
std::vector<SolidBody> bodiesOf(const TriMesh& mesh, const std::string& name, Execution& execution);

} // namespace scan
