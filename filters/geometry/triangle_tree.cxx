// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/triangle_tree.h"

#include "filters/geometry/box_tree.h"
#include "filters/geometry/point_triangle.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scan
{
namespace
{

std::vector<Index> allOf(const TriMesh& mesh)
{
  std::vector<Index> triangles(mesh.triangles.size());
  std::iota(triangles.begin(), triangles.end(), Index{ 0 });
  return triangles;
}

constexpr double kFarthest = std::numeric_limits<double>::max(); // at infinity there is nothing

/// The nearest place so far, and how near a box has to be to hold a nearer one or an equally near
/// triangle with a smaller number: the computed distance of that may be less than that of the box
/// by rounding.
class Nearest
{
public:
  Nearest(const TriMesh& mesh, const Vec3& at)
    : Mesh(mesh)
    , At(at)
    , Rounding(0x1p-48 * std::max({ std::abs(at.x), std::abs(at.y), std::abs(at.z) }))
  {
  }

  void look(Index triangle)
  {
    if (triangle == this->Best.triangle)
    {
      return;
    }
    const auto& [a, b, c] = this->Mesh.triangles[triangle];
    const Vec3 q = nearestPointOnTriangle(
      this->At, this->Mesh.points[a], this->Mesh.points[b], this->Mesh.points[c]);
    const double squared = dot(q - this->At, q - this->At);
    SurfacePlace& best = this->Best;
    if (squared < best.squaredDistance ||
      (squared == best.squaredDistance && triangle < best.triangle))
    {
      best = { triangle, q, squared };
      const double reach = std::sqrt(squared) * (1.0 + 0x1p-48) + this->Rounding;
      this->SquaredReach = std::min(reach * reach, kFarthest);
    }
  }

  /// Looks at the triangles of a lowest group whose boxes are near enough.
  void lookInGroup(const BoxTree& tree, std::size_t group)
  {
    EightBoxes::Row squares;
    unsigned bits = tree.level(0)[group].within(this->At, this->SquaredReach, squares);
    for (; bits != 0; bits &= bits - 1)
    {
      const auto place = static_cast<std::size_t>(std::countr_zero(bits));
      if (squares[place / 2][place % 2] <= this->SquaredReach)
      {
        this->look(tree[BoxTree::kFan * group + place]);
      }
    }
  }

  double squaredReach() const { return this->SquaredReach; }
  const SurfacePlace& best() const { return this->Best; }

private:
  const TriMesh& Mesh;
  Vec3 At;
  double Rounding;
  SurfacePlace Best;
  double SquaredReach = kFarthest;
};

} // namespace

struct TriangleTree::Nodes : BoxTree
{
  using BoxTree::BoxTree;
};

TriangleTree::TriangleTree(const TriMesh& mesh, Execution& execution)
  : Mesh(mesh)
  , Tree(std::make_unique<Nodes>(mesh, allOf(mesh), execution))
{
}

TriangleTree::~TriangleTree() = default;

SurfacePlace TriangleTree::nearest(const Vec3& at, Index hint) const
{
  struct Step
  {
    double squared; // distance of the box
    std::size_t level;
    std::size_t group;
  };
  const BoxTree& tree = *this->Tree;
  if (tree.levels() == 0)
  {
    return {};
  }
  Nearest nearest(this->Mesh, at);
  nearest.look(hint < this->Mesh.triangles.size() ? hint : tree[0]);
  std::array<Step, BoxTree::kStack> stack;
  std::size_t waiting = 0;
  stack[waiting++] = { 0.0, tree.levels() - 1, 0 };
  while (waiting > 0)
  {
    const Step step = stack[--waiting];
    if (step.squared > nearest.squaredReach())
    {
      continue;
    }
    if (step.level == 0)
    {
      nearest.lookInGroup(tree, step.group);
      continue;
    }
    EightBoxes::Row squares;
    unsigned bits = tree.level(step.level)[step.group].within(at, nearest.squaredReach(), squares);
    const std::size_t bottom = waiting;
    for (; bits != 0; bits &= bits - 1)
    {
      const auto place = static_cast<std::size_t>(std::countr_zero(bits));
      const double squared = squares[place / 2][place % 2];
      std::size_t slot = waiting++; // the nearest child goes on top
      for (; slot > bottom && stack[slot - 1].squared < squared; --slot)
      {
        stack[slot] = stack[slot - 1];
      }
      stack[slot] = { squared, step.level - 1, BoxTree::kFan * step.group + place };
    }
  }
  return nearest.best();
}

void TriangleTree::touching(const Box& box, std::vector<Index>& found) const
{
  this->Tree->forGroupsTouching(box, 0,
    [&](std::size_t group, unsigned touching)
    {
      for (; touching != 0; touching &= touching - 1)
      {
        found.push_back((*this->Tree)[BoxTree::kFan * group + std::countr_zero(touching)]);
      }
      return true;
    });
}

struct TrianglesNear::Groups
{
  static constexpr std::size_t kMost = 4; // times eight groups

  std::array<EightBoxes, kMost> boxes;
  std::array<std::size_t, kMost * BoxTree::kFan> groups;
  std::size_t count = 0;
};

TrianglesNear::TrianglesNear(const TriangleTree& tree)
  : Tree(tree)
  , Near(std::make_unique<Groups>())
{
}

TrianglesNear::~TrianglesNear() = default;

void TrianglesNear::moveTo(const Box& box, double reach)
{
  const BoxTree& tree = *this->Tree.Tree;
  Groups& near = *this->Near;
  const Vec3 margin{ reach, reach, reach };
  this->Around = box;
  this->Reach = reach;
  near.count = 0;
  tree.forGroupsTouching({ box.low - margin, box.high + margin }, 0,
    [&](std::size_t group, unsigned)
    {
      if (near.count == near.groups.size())
      {
        this->Reach = -1.0;
        return false;
      }
      const std::size_t place = near.count % BoxTree::kFan;
      EightBoxes& boxes = near.boxes[near.count / BoxTree::kFan];
      if (place == 0)
      {
        boxes.clear();
      }
      boxes.set(place, tree.level(0)[group].around());
      near.groups[near.count++] = group;
      return true;
    });
}

SurfacePlace TrianglesNear::nearest(const Vec3& at, Index hint) const
{
  const TriMesh& mesh = this->Tree.mesh();
  if (!(this->Reach > 0.0) || this->Near->count == 0)
  {
    return this->Tree.nearest(at, hint);
  }
  const BoxTree& tree = *this->Tree.Tree;
  const Groups& near = *this->Near;
  Nearest nearest(mesh, at);
  nearest.look(hint < mesh.triangles.size() ? hint : tree[BoxTree::kFan * near.groups[0]]);
  for (std::size_t eight = 0; BoxTree::kFan * eight < near.count; ++eight)
  {
    EightBoxes::Row squares;
    unsigned bits = near.boxes[eight].within(at, nearest.squaredReach(), squares);
    for (; bits != 0; bits &= bits - 1)
    {
      const auto place = static_cast<std::size_t>(std::countr_zero(bits));
      if (squares[place / 2][place % 2] <= nearest.squaredReach())
      {
        nearest.lookInGroup(tree, near.groups[BoxTree::kFan * eight + place]);
      }
    }
  }
  const Vec3 out = at -
    Vec3{ std::clamp(at.x, this->Around.low.x, this->Around.high.x),
      std::clamp(at.y, this->Around.low.y, this->Around.high.y),
      std::clamp(at.z, this->Around.low.z, this->Around.high.z) };
  const double reach = this->Reach - std::sqrt(dot(out, out)); // that everything within is known
  return reach > 0.0 && nearest.squaredReach() <= reach * reach
    ? nearest.best()
    : this->Tree.nearest(at, nearest.best().triangle);
}

} // namespace scan
