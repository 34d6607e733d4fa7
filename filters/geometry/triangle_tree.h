// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

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
  friend class TrianglesNear;
  struct Nodes;
  const TriMesh& Mesh;
  std::unique_ptr<Nodes> Tree;
};

/// The part of a tree that is near a box: for many questions about points in there, which get the
/// same answers in less time. For use on one thread.
class TrianglesNear
{
public:
  explicit TrianglesNear(const TriangleTree& tree);
  ~TrianglesNear();
  TrianglesNear(const TrianglesNear&) = delete;
  TrianglesNear& operator=(const TrianglesNear&) = delete;

  /// Takes what is within `reach` of a box, or the whole tree where that is much.
  void moveTo(const Box& box, double reach);

  /// TriangleTree::nearest(), faster for what is within `reach` of a point in the box.
  SurfacePlace nearest(const Vec3& at, Index hint) const;

private:
  struct Groups;
  const TriangleTree& Tree;
  Box Around;
  double Reach = -1.0;
  std::unique_ptr<Groups> Near;
};

} // namespace scan
