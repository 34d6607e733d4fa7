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
  /// Of a closed shell what it encloses, negative when it faces inwards; 0 of an open one. Where
  /// rounding could hide the sign it is computed exactly.
  double volume = 0.0;
  /// Of a closed shell: the number of the smallest closed shell around it, whichever way that
  /// faces; kNone when there is none.
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

/// Finds the containers, by exact winding numbers around a point of each closed shell. Shells that
/// touch one around them only do so in some places; where a shell lies on another everywhere,
/// neither contains the other. Time about n log n for n triangles, and a little for each two shells
/// of which one lies in the other.
///
/// Throws Cancelled.
/// @param mesh oriented within its closed shells
void findContainers(const TriMesh& mesh, Shells& shells, Execution& execution);

/// The largest shell around a shell, perhaps itself.
Index outermost(const Shells& shells, Index shell);

} // namespace scan
