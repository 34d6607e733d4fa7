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
  Nearest nearest(this->Mesh, at);
  if (tree.levels() == 0)
  {
    return {};
  }
  nearest.look(hint < this->Mesh.triangles.size() ? hint : tree[0]);
  std::array<Step, 128> stack;
  std::size_t waiting = 0;
  stack[waiting++] = { 0.0, tree.levels(), 0 };
  while (waiting > 0)
  {
    const Step step = stack[--waiting];
    if (step.squared > nearest.squaredReach())
    {
      continue;
    }
    if (step.level == 0)
    {
      if (tree[step.group] != hint)
      {
        nearest.look(tree[step.group]);
      }
      continue;
    }
    // the nearest child goes on top
    const EightBoxes::Row squares = tree.level(step.level - 1)[step.group].squaredDistances(at);
    const std::size_t bottom = waiting;
    for (std::size_t child = 0; child < BoxTree::kFan; ++child)
    {
      const double squared = squares[child / 2][child % 2];
      if (squared <= nearest.squaredReach())
      {
        std::size_t place = waiting++;
        for (; place > bottom && stack[place - 1].squared < squared; --place)
        {
          stack[place] = stack[place - 1];
        }
        stack[place] = { squared, step.level - 1, BoxTree::kFan * step.group + child };
      }
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
