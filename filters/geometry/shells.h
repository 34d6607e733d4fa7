// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <span>
#include <vector>

namespace scan
{

/// A piece of a surface that hangs together by edges of two triangles.
struct Shell
{
  Index firstTriangle = 0;
  Index triangles = 0;
  bool isClosed = false;
  /// Of a closed shell what it encloses, negative when it faces inwards; 0 of an open one.
  double volume = 0.0;
  /// Of a closed shell that faces inwards: the number of the smallest shell around it that is
  /// closed and faces outwards, of whose body it is a void; kNone when there is none.
  Index container = kNone;
};

struct Shells
{
  std::vector<Shell> shells;  ///< in the order of their first triangles
  std::vector<Index> shellOf; ///< per triangle
};

/// The shells of a mesh.
/// @param mate per half-edge, as pairEdges() finds it
Shells findShells(const TriMesh& mesh, std::span<const Index> mate);

/// Finds the containers, by exact winding numbers around a point of each shell that faces inwards.
/// Time: the triangles times the shells that face inwards and share their range of x.
///
/// Throws Cancelled.
/// @param mesh oriented within its closed shells
void findContainers(const TriMesh& mesh, Shells& shells, Execution& execution);

} // namespace scan
