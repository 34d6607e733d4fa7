// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/shells.h"

#include "filters/geometry/union_find.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/MP_Float.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

namespace scan
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

namespace bg = boost::geometry;
template <std::size_t N>
using Box = bg::model::box<bg::model::point<double, N, bg::cs::cartesian>>;
template <std::size_t N>
using Boxes = bg::index::rtree<std::pair<Box<N>, Index>, bg::index::quadratic<16>>;

/// Six times the volume between a triangle and a point. Short edges keep the rounding small.
template <class Number>
Number sixVolumes(const TriMesh& mesh, const Triangle& triangle, const Vec3& from)
{
  const auto difference = [&](const Vec3& p, const Vec3& q)
  {
    return std::array{ Number(p.x) - Number(q.x), Number(p.y) - Number(q.y),
      Number(p.z) - Number(q.z) };
  };
  const Vec3& a = mesh.points[triangle[0]];
  const auto [x, y, z] = difference(a, from);
  const auto [ux, uy, uz] = difference(mesh.points[triangle[1]], a);
  const auto [vx, vy, vz] = difference(mesh.points[triangle[2]], a);
  return x * (uy * vz - uz * vy) + y * (uz * vx - ux * vz) + z * (ux * vy - uy * vx);
}

/// What the rounding errors of sixVolumes() are relative to.
double magnitudeOfVolume(const TriMesh& mesh, const Triangle& triangle, const Vec3& from)
{
  const auto length = [](const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
  const Vec3& a = mesh.points[triangle[0]];
  return length(a - from) * length(mesh.points[triangle[1]] - a) *
    length(mesh.points[triangle[2]] - a);
}

/// Gives closed shells that enclose less than the rounding of their volume the exact one.
/// @param magnitudes per shell, of all its triangles
void correctVolumes(const TriMesh& mesh, const std::vector<double>& magnitudes, Shells& shells)
{
  std::map<Index, CGAL::MP_Float> exact;
  for (Index i = 0; i < shells.shells.size(); ++i)
  {
    const Shell& shell = shells.shells[i];
    const double error =
      std::numeric_limits<double>::epsilon() * (shell.triangles + 16.0) * magnitudes[i];
    if (shell.isClosed && std::isfinite(error) && 6.0 * std::abs(shell.volume) <= error)
    {
      exact.emplace(i, 0.0);
    }
  }
  for (Index t = 0; t < mesh.triangles.size() && !exact.empty(); ++t)
  {
    if (const auto found = exact.find(shells.shellOf[t]); found != exact.end())
    {
      const Triangle& first = mesh.triangles[shells.shells[found->first].firstTriangle];
      found->second += sixVolumes<CGAL::MP_Float>(mesh, mesh.triangles[t], mesh.points[first[0]]);
    }
  }
  for (const auto& [shell, six] : exact)
  {
    const double least = std::numeric_limits<double>::denorm_min(); // the sign must stay
    const double most = std::max(std::abs(CGAL::to_double(six)) / 6.0, least);
    shells.shells[shell].volume = static_cast<int>(CGAL::sign(six)) * most;
  }
}

/// How often, and which way, a triangle winds around a point seen along z: 1, -1 or 0. A point on
/// an edge counts as moved a little, the same way for all triangles at the edge.
int windingAlongZ(const std::array<Vec3, 3>& corners, const Vec3& point)
{
  const auto flat = [](const Vec3& p) { return Kernel::Point_2(p.x, p.y); };
  int winding = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& from = corners[k];
    const Vec3& to = corners[(k + 1) % 3];
    const bool isUpwards = from.y <= point.y && to.y > point.y;
    const bool isDownwards = from.y > point.y && to.y <= point.y;
    if (isUpwards || isDownwards)
    {
      const CGAL::Orientation side = CGAL::orientation(flat(from), flat(to), flat(point));
      winding += isUpwards && side == CGAL::LEFT_TURN ? 1 : 0;
      winding -= isDownwards && side == CGAL::RIGHT_TURN ? 1 : 0;
    }
  }
  return winding;
}

/// Where the point is of the plane of a triangle that winds around it.
CGAL::Orientation sideOfPlane(const std::array<Vec3, 3>& corners, const Vec3& point)
{
  const auto exact = [](const Vec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return CGAL::orientation(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(point));
}

bool isInBox(const std::array<Vec3, 3>& corners, const Vec3& point)
{
  const auto isBetween = [&](double Vec3::*axis)
  {
    const auto [low, high] = std::minmax({ corners[0].*axis, corners[1].*axis, corners[2].*axis });
    return low <= point.*axis && point.*axis <= high;
  };
  return isBetween(&Vec3::x) && isBetween(&Vec3::y) && isBetween(&Vec3::z);
}

enum class Place
{
  outside,
  inside,
  on
};

/// Finds out which closed shells lie in which.
class ContainerSearch
{
public:
  ContainerSearch(const TriMesh& mesh, const Shells& shells)
    : Mesh(mesh)
    , Pieces(shells)
    , Begin(shells.shells.size() + 1, 0)
    , Triangles(mesh.triangles.size())
    , Asked(shells.shells.size(), 0)
    , Trees(shells.shells.size())
  {
    this->groupTriangles();
    this->boxShells();
  }

  /// The smallest shell around a shell.
  Index containerOf(Index shell)
  {
    if (!this->isContent(shell))
    {
      return kNone;
    }
    std::vector<std::pair<double, Index>> candidates; // by their volume
    const auto see = [&](const std::pair<Box<3>, Index>& found)
    {
      if (this->sizeOf(found.second) > this->sizeOf(shell))
      {
        candidates.emplace_back(this->sizeOf(found.second), found.second);
      }
    };
    this->ShellBoxes.query(
      bg::index::covers(this->BoxOf[shell]), boost::make_function_output_iterator(see));
    std::ranges::make_heap(candidates, std::greater());
    while (!candidates.empty())
    {
      const Index candidate = candidates.front().second;
      if (this->isInside(shell, candidate))
      {
        return candidate;
      }
      std::ranges::pop_heap(candidates, std::greater());
      candidates.pop_back();
    }
    return kNone;
  }

private:
  double sizeOf(Index shell) const { return std::abs(this->Pieces.shells[shell].volume); }
  bool isContent(Index shell) const { return this->sizeOf(shell) > 0.0; }

  std::span<const Index> trianglesOf(Index shell) const
  {
    return std::span(this->Triangles)
      .subspan(this->Begin[shell], this->Begin[shell + 1] - this->Begin[shell]);
  }

  std::array<Vec3, 3> cornersOf(Index triangle) const
  {
    const auto& [a, b, c] = this->Mesh.triangles[triangle];
    return { this->Mesh.points[a], this->Mesh.points[b], this->Mesh.points[c] };
  }

  void groupTriangles()
  {
    for (const Index shell : this->Pieces.shellOf)
    {
      ++this->Begin[shell + 1];
    }
    std::partial_sum(this->Begin.begin(), this->Begin.end(), this->Begin.begin());
    std::vector<Index> next(this->Begin.begin(), this->Begin.end() - 1);
    for (Index t = 0; t < this->Triangles.size(); ++t)
    {
      this->Triangles[next[this->Pieces.shellOf[t]]++] = t;
    }
  }

  void boxShells()
  {
    std::vector<std::pair<Box<3>, Index>> boxes;
    this->BoxOf.resize(this->Pieces.shells.size());
    for (Index shell = 0; shell < this->Pieces.shells.size(); ++shell)
    {
      Vec3 low = this->cornersOf(this->trianglesOf(shell)[0])[0];
      Vec3 high = low;
      for (const Index triangle : this->trianglesOf(shell))
      {
        for (const Vec3& p : this->cornersOf(triangle))
        {
          low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
          high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
        }
      }
      this->BoxOf[shell] = Box<3>({ low.x, low.y, low.z }, { high.x, high.y, high.z });
      if (this->isContent(shell))
      {
        boxes.emplace_back(this->BoxOf[shell], shell);
      }
    }
    this->ShellBoxes = Boxes<3>(boxes);
  }

  /// By what most of some middles of its triangles say: where shells touch, a few may lie on the
  /// other, or after rounding on either side of it.
  bool isInside(Index shell, Index container)
  {
    constexpr std::size_t kProbes = 16;
    const std::span<const Index> triangles = this->trianglesOf(shell);
    const std::size_t step = std::max<std::size_t>(1, triangles.size() / kProbes);
    int lead = 0; // of inside before outside
    for (std::size_t i = 0; i < triangles.size() && std::abs(lead) < 3; i += step)
    {
      const auto [a, b, c] = this->cornersOf(triangles[i]);
      const Place place = this->placeIn(container, (a + b + c) * (1.0 / 3.0));
      lead += place == Place::inside ? 1 : place == Place::outside ? -1 : 0;
    }
    return lead > 0;
  }

  /// By the winding number of the shell around the point: the triangles above it count.
  Place placeIn(Index shell, const Vec3& point)
  {
    int winding = 0;
    bool isOn = false;
    const auto see = [&](Index triangle)
    {
      const std::array<Vec3, 3> corners = this->cornersOf(triangle);
      const int here = windingAlongZ(corners, point);
      const bool isNear = isInBox(corners, point);
      if (here == 0 && !isNear)
      {
        return;
      }
      const CGAL::Orientation side = sideOfPlane(corners, point);
      isOn = isOn || (isNear && side == CGAL::COPLANAR); // also where the triangle stands upright
      winding += side == (here > 0 ? CGAL::NEGATIVE : CGAL::POSITIVE) ? here : 0;
    };
    constexpr int kFew = 32; // questions that make no search tree worth while
    if (++this->Asked[shell] <= kFew)
    {
      std::ranges::for_each(this->trianglesOf(shell), see);
    }
    else
    {
      const auto seeFound = [&](const std::pair<Box<2>, Index>& found) { see(found.second); };
      const bg::model::point<double, 2, bg::cs::cartesian> place(point.x, point.y);
      this->treeOf(shell).query(
        bg::index::covers(place), boost::make_function_output_iterator(seeFound));
    }
    return isOn ? Place::on : winding != 0 ? Place::inside : Place::outside;
  }

  /// The triangles of a shell, seen along z.
  const Boxes<2>& treeOf(Index shell)
  {
    if (!this->Trees[shell])
    {
      std::vector<std::pair<Box<2>, Index>> boxes;
      for (const Index triangle : this->trianglesOf(shell))
      {
        const auto [a, b, c] = this->cornersOf(triangle);
        boxes.push_back({ Box<2>({ std::min({ a.x, b.x, c.x }), std::min({ a.y, b.y, c.y }) },
                            { std::max({ a.x, b.x, c.x }), std::max({ a.y, b.y, c.y }) }),
          triangle });
      }
      this->Trees[shell] = std::make_unique<Boxes<2>>(boxes);
    }
    return *this->Trees[shell];
  }

  const TriMesh& Mesh;
  const Shells& Pieces;
  std::vector<Index> Begin; // per shell: of its triangles
  std::vector<Index> Triangles;
  std::vector<Box<3>> BoxOf;
  Boxes<3> ShellBoxes; // of closed ones
  std::vector<int> Asked;
  std::vector<std::unique_ptr<Boxes<2>>> Trees;
};

} // namespace

Shells findShells(const TriMesh& mesh, std::span<const Index> mate)
{
  UnionFind sets(mesh.triangles.size());
  for (std::size_t half = 0; half < mate.size(); ++half)
  {
    if (mate[half] != kNone)
    {
      sets.unite(static_cast<Index>(half / 3), mate[half] / 3);
    }
  }
  Shells result;
  result.shellOf.resize(mesh.triangles.size());
  std::vector<double> magnitudes;
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const Index root = sets.root(t); // the first triangle of the shell
    if (root == t)
    {
      result.shellOf[t] = static_cast<Index>(result.shells.size());
      result.shells.push_back({ .firstTriangle = t, .isClosed = true });
    }
    result.shellOf[t] = result.shellOf[root];
    Shell& shell = result.shells[result.shellOf[t]];
    const Vec3& from = mesh.points[mesh.triangles[root][0]];
    ++shell.triangles;
    magnitudes.resize(result.shells.size());
    magnitudes[result.shellOf[t]] += magnitudeOfVolume(mesh, mesh.triangles[t], from);
    shell.volume += sixVolumes<double>(mesh, mesh.triangles[t], from) / 6.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      shell.isClosed = shell.isClosed && mate[3 * std::size_t{ t } + k] != kNone;
    }
  }
  for (Shell& shell : result.shells)
  {
    shell.volume = shell.isClosed ? shell.volume : 0.0;
  }
  correctVolumes(mesh, magnitudes, result);
  return result;
}

void findContainers(const TriMesh& mesh, Shells& shells, Execution& execution)
{
  const auto isClosed = [](const Shell& shell) { return shell.volume != 0.0; };
  if (std::ranges::count_if(shells.shells, isClosed) < 2)
  {
    return;
  }
  constexpr std::size_t kStep = 256;
  ContainerSearch search(mesh, shells);
  std::vector<Index> containers(shells.shells.size());
  for (Index shell = 0; shell < containers.size(); ++shell)
  {
    if (shell % kStep == 0)
    {
      execution.step("shells", shell, containers.size());
    }
    containers[shell] = search.containerOf(shell);
  }
  for (Index shell = 0; shell < containers.size(); ++shell)
  {
    shells.shells[shell].container = containers[shell];
  }
}

Index outermost(const Shells& shells, Index shell)
{
  while (shells.shells[shell].container != kNone) // each is larger than the one before
  {
    shell = shells.shells[shell].container;
  }
  return shell;
}

} // namespace scan
