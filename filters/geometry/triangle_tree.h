// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace scan
{

/// A place on a surface.
struct SurfacePlace
{
  Index triangle = kNone; ///< kNone where none was found
  Vec3 point;
  double squaredDistance = std::numeric_limits<double>::infinity(); ///< from what was asked for
};

/// An axis-parallel box.
struct Box
{
  Vec3 low;
  Vec3 high;
};

/// The triangles of a mesh in a tree of boxes, for questions about what is near: eight children a
/// node, in the order of a Hilbert curve. Keeps a reference to the mesh. Questions may be asked on
/// many threads. The answers do not depend on the number of threads.
class TriangleTree
{
public:
  /// Triangles of any shape. Throws Error badInput for coordinates that are not finite.
  TriangleTree(const TriMesh& mesh, Execution& execution);
  ~TriangleTree();
  TriangleTree(const TriangleTree&) = delete;
  TriangleTree& operator=(const TriangleTree&) = delete;

  const TriMesh& mesh() const { return this->Mesh; }

  /// The place of the surface nearest to `at`: exact up to the rounding of coordinates as doubles.
  /// @param hint a triangle that is probably near, such as the answer for a point nearby: faster;
  ///   kNone for none
  SurfacePlace nearest(const Vec3& at, Index hint = kNone) const;

  /// Appends the triangles whose boxes touch a box, in increasing order of the tree.
  void touching(const Box& box, std::vector<Index>& found) const;

private:
  struct Nodes;
  const TriMesh& Mesh;
  std::unique_ptr<Nodes> Tree;
};

} // namespace scan
