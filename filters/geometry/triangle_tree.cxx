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
      this->SquaredReach = reach * reach;
    }
  }

  double squaredReach() const { return this->SquaredReach; }
  const SurfacePlace& best() const { return this->Best; }

private:
  const TriMesh& Mesh;
  Vec3 At;
  double Rounding;
  SurfacePlace Best;
  double SquaredReach = std::numeric_limits<double>::max(); // there is nothing at infinity
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
  hint = hint < this->Mesh.triangles.size() ? hint : tree[0];
  nearest.look(hint);
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
    EightBoxes::Row squares;
    unsigned bits = tree.level(step.level)[step.group].within(at, nearest.squaredReach(), squares);
    const std::size_t bottom = waiting;
    for (; bits != 0; bits &= bits - 1)
    {
      const auto place = static_cast<std::size_t>(std::countr_zero(bits));
      const double squared = squares[place / 2][place % 2];
      const std::size_t child = BoxTree::kFan * step.group + place;
      if (step.level == 0)
      {
        if (squared <= nearest.squaredReach() && tree[child] != hint)
        {
          nearest.look(tree[child]);
        }
        continue;
      }
      std::size_t slot = waiting++; // the nearest child goes on top
      for (; slot > bottom && stack[slot - 1].squared < squared; --slot)
      {
        stack[slot] = stack[slot - 1];
      }
      stack[slot] = { squared, step.level - 1, child };
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
    });
}

} // namespace scan
