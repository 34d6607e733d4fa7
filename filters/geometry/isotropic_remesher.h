// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "filters/geometry/triangle_tree.h"

#include <memory>
#include <vector>

namespace scan
{

/// CGAL's remeshing of a whole oriented manifold that uses all its points, an iteration a call.
class IsotropicRemesher
{
public:
  struct Options
  {
    double edgeLength = 1.0;
    double featureAngle = 180.0;  ///< degrees
    bool isBoundaryFixed = false; ///< no boundary edge changes but those that may
  };

  /// @param surface what points are put on; must outlive it
  /// @param maySplit per half-edge of a boundary 1 where it may be split although it is fixed
  IsotropicRemesher(const TriMesh& mesh, const std::vector<std::uint8_t>& maySplit,
    const Options& options, const TriangleTree& surface);
  ~IsotropicRemesher();
  IsotropicRemesher(const IsotropicRemesher&) = delete;
  IsotropicRemesher& operator=(const IsotropicRemesher&) = delete;

  void iterate();

  /// The mesh, and per point the one that it was; kNone for new ones.
  TriMesh mesh(std::vector<Index>& origins) const;

private:
  struct State;
  std::unique_ptr<State> S;
};

} // namespace scan
