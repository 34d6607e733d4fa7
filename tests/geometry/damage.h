// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"
#include "filters/geometry/random.h"

#include <cmath>
#include <utility>

namespace scan::test
{

/// Random damage to a surface of any kind that mending must cope with.
class SurfaceDamage
{
public:
  SurfaceDamage(TriMesh mesh, std::uint64_t seed)
    : Mesh(std::move(mesh))
    , Numbers(seed)
  {
  }

  const TriMesh& mesh() const { return this->Mesh; }

  void doSomething()
  {
    const auto t = static_cast<std::size_t>(this->Numbers.below(this->Mesh.triangles.size()));
    switch (this->Numbers.below(8))
    {
      case 0: // flip
        std::swap(this->Mesh.triangles[t][0], this->Mesh.triangles[t][1]);
        break;
      case 1: // repeat
        this->Mesh.triangles.push_back(Triangle(this->Mesh.triangles[t]));
        break;
      case 2: // tear out
        for (Index& corner : this->Mesh.triangles[t])
        {
          corner = this->copy(corner);
        }
        break;
      case 3: // tear at a corner
        this->Mesh.triangles[t][0] = this->copy(this->Mesh.triangles[t][0]);
        break;
      case 4: // push a point to anywhere near
        this->push(this->Mesh.triangles[t][0], 3.0);
        break;
      case 5: // spike
        this->push(this->Mesh.triangles[t][1], 10.0);
        break;
      case 6: // a hole
        this->Mesh.triangles.erase(this->Mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
        break;
      default: // a fin
        this->Mesh.triangles.push_back(
          { this->Mesh.triangles[t][0], this->Mesh.triangles[t][1], this->finTip(t) });
    }
  }

private:
  Index copy(Index point)
  {
    this->Mesh.points.push_back(Vec3(this->Mesh.points[point]));
    return static_cast<Index>(this->Mesh.points.size() - 1);
  }

  double edgeOf(std::size_t t) const
  {
    const Vec3 e =
      this->Mesh.points[this->Mesh.triangles[t][1]] - this->Mesh.points[this->Mesh.triangles[t][0]];
    return std::sqrt(dot(e, e));
  }

  Vec3 anyWay(double size)
  {
    const auto one = [&] { return size * (2.0 * this->Numbers.unit() - 1.0); };
    const double x = one();
    const double y = one();
    return { x, y, one() };
  }

  void push(Index point, double edges)
  {
    for (std::size_t t = 0; t < this->Mesh.triangles.size(); ++t)
    {
      if (this->Mesh.triangles[t][0] == point || this->Mesh.triangles[t][1] == point)
      {
        this->Mesh.points[point] = this->Mesh.points[point] + this->anyWay(edges * this->edgeOf(t));
        return;
      }
    }
  }

  Index finTip(std::size_t t)
  {
    const Vec3 tip = this->Mesh.points[this->Mesh.triangles[t][2]] + this->anyWay(this->edgeOf(t));
    this->Mesh.points.push_back(tip);
    return static_cast<Index>(this->Mesh.points.size() - 1);
  }

  TriMesh Mesh;
  Random Numbers;
};

} // namespace scan::test
