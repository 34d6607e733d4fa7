// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/angle_repair.h"

#include "filters/geometry/collect.h"
#include "filters/geometry/dihedral_angle.h"
#include "filters/geometry/tet_star.h"

#include <array>
#include <bit>
#include <deque>
#include <numbers>
#include <optional>

namespace scan
{
namespace
{

constexpr int kLargestGroup = 4; // tetrahedra that flip together; more found nothing more

/// A group may bend the surface on its way to a gain, by the bend that its first tetrahedron had.
constexpr double kDetour = 1.0;

/// The edges of a tetrahedron: their ends, then the other two corners.
constexpr std::array<std::array<std::size_t, 4>, 6> kEdges{ { { 0, 1, 2, 3 }, { 0, 2, 1, 3 },
  { 0, 3, 1, 2 }, { 1, 2, 0, 3 }, { 1, 3, 0, 2 }, { 2, 3, 0, 1 } } };

/// Of the edges of a tetrahedron that are on the surface.
struct Bend
{
  int edges = 0;
  double total = 0.0;    ///< sum of length times angle
  double sharpest = 0.0; ///< largest angle
};

/// What a flip does to the edges of its tetrahedron.
struct FlipEffect
{
  Bend before;
  double change;
};

/// The vertices of the triangles of a region.
class RegionVertices
{
public:
  RegionVertices(const DelaunayComplex& complex, std::span<const Facet> triangles)
  {
    for (const Facet triangle : triangles)
    {
      const Triangle v = complex.facetVertices(triangle);
      this->Vertices.insert(v.begin(), v.end());
    }
  }

  bool isEverything() const { return this->Vertices.empty(); }
  bool contains(const Triangle& triangle) const
  {
    return this->isEverything() ||
      std::ranges::all_of(triangle, [&](Index v) { return this->Vertices.contains(v); });
  }

private:
  std::unordered_set<Index> Vertices;
};

/// The surface, on which tetrahedra flip.
class Flips
{
public:
  Flips(WrapComplex& kept, const RegionVertices& region)
    : Kept(kept)
    , Complex(kept.flow().delaunay())
    , Region(region)
  {
  }

  void flip(Index tet)
  {
    if (this->Kept.keepsTet(tet))
    {
      this->Kept.dropTet(tet);
    }
    else
    {
      this->Kept.keepTet(tet);
    }
  }

  Bend bendOf(Index tet) const;

  /// Nothing where the flip is not allowed.
  std::optional<FlipEffect> tryFlip(Index tet);

  /// Calls visit(tet) for the tetrahedra at the edges of a tetrahedron, some several times.
  template <class Visit>
  void forEachAtEdges(Index tet, Visit&& visit) const
  {
    for (const auto& edge : kEdges)
    {
      const Facet triangle = 4 * tet + static_cast<Facet>(edge[2]);
      this->Complex.walkWholeEdge(triangle, this->Complex.tetrahedra[tet][edge[3]],
        [&](Facet entering, Facet, Facet)
        {
          visit(entering / 4);
          return true;
        });
    }
  }

private:
  bool isOffSurface(Index tet, Index vertex) const;

  WrapComplex& Kept;
  const DelaunayComplex& Complex;
  const RegionVertices& Region;
};

/// No bend and seven edges where the surface is no manifold.
Bend Flips::bendOf(Index tet) const
{
  constexpr Bend kNoManifold{ .edges = 7 };
  const auto& v = this->Complex.tetrahedra[tet];
  const auto& p = this->Complex.points;
  Bend bend;
  for (const auto& [i, j, k, l] : kEdges)
  {
    std::array<Index, 2> apex{};
    std::size_t count = 0;
    forEachTriangleAtEdge(this->Complex, { 4 * tet + static_cast<Facet>(k), v[l] },
      [&](Facet at, Index behind)
      {
        if (isOnSurface(this->Kept, at) && ++count <= 2)
        {
          apex[count - 1] = behind;
        }
        return count <= 2;
      });
    if (count != 0 && count != 2)
    {
      return kNoManifold;
    }
    if (count == 2)
    {
      const Vec3 along = p[v[j]] - p[v[i]];
      const double angle =
        std::numbers::pi - dihedralAngle(p[v[i]], p[v[j]], p[apex[0]], p[apex[1]]);
      bend.edges += 1;
      bend.total += std::sqrt(dot(along, along)) * angle;
      bend.sharpest = std::max(bend.sharpest, angle);
    }
  }
  return bend;
}

bool Flips::isOffSurface(Index tet, Index vertex) const
{
  return forEachTetAround(this->Complex, std::array{ vertex }, tet,
    [&](Index around)
    {
      for (Facet facet = 4 * around; facet < 4 * around + 4; ++facet)
      {
        if (this->Complex.tetrahedra[around][facet % 4] != vertex && isOnSurface(this->Kept, facet))
        {
          return false;
        }
      }
      return true;
    });
}

std::optional<FlipEffect> Flips::tryFlip(Index tet)
{
  int triangles = 0;
  Index apex = kNone;
  for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
  {
    if (this->Kept.keptSides(facet) == 1)
    {
      ++triangles;
      apex = this->Complex.tetrahedra[tet][facet % 4];
      if (!this->Region.contains(this->Complex.facetVertices(facet)))
      {
        return {};
      }
    }
    else if (this->Kept.isSheet(facet))
    {
      return {};
    }
  }
  // with three triangles a vertex would be lost
  if ((triangles != 1 && triangles != 2) || (triangles == 1 && !this->isOffSurface(tet, apex)))
  {
    return {};
  }
  const Bend before = this->bendOf(tet);
  this->flip(tet);
  const Bend after = this->bendOf(tet);
  this->flip(tet);
  const bool isAllowed =
    triangles == 1 ? before.edges == 3 && after.edges == 6 : before.edges == 5 && after.edges == 5;
  return isAllowed ? std::optional(FlipEffect{ before, after.total - before.total }) : std::nullopt;
}

/// Finds groups of tetrahedra whose flips straighten the surface, and flips them.
class Repair
{
public:
  Repair(Flips& flips, const AngleRepairOptions& options)
    : Surface(flips)
    , FeatureAngle(options.featureAngle * std::numbers::pi / 180.0)
    , Gain(options.gain)
  {
  }

  bool isAtFeature(Index tet) const { return this->Surface.bendOf(tet).sharpest > FeatureAngle; }

  /// Flips a group of at most `size` that begins with the tetrahedron; empty when there is none.
  std::vector<Index> repairAt(Index tet, int size)
  {
    std::vector<Index> group;
    this->extend(group, tet, size, { .change = 0.0, .scale = 0.0 });
    return group;
  }

private:
  struct Balance
  {
    double change; ///< of the bend, by the group so far
    double scale;  ///< bend of the first tetrahedron
  };

  bool extend(std::vector<Index>& group, Index tet, int size, Balance balance);

  Flips& Surface;
  double FeatureAngle;
  double Gain;
};

/// Flips the tetrahedron and others around it; undoes all that when it does not pay.
bool Repair::extend(std::vector<Index>& group, Index tet, int size, Balance balance)
{
  const std::optional<FlipEffect> effect = this->Surface.tryFlip(tet);
  if (!effect || effect->before.sharpest <= this->FeatureAngle)
  {
    return false;
  }
  balance.scale = group.empty() ? effect->before.total : balance.scale;
  balance.change += effect->change;
  if (balance.change > kDetour * balance.scale)
  {
    return false;
  }
  this->Surface.flip(tet);
  group.push_back(tet);
  if (balance.change < -this->Gain * balance.scale)
  {
    return true;
  }
  std::vector<Index> next;
  if (size > 1)
  {
    this->Surface.forEachAtEdges(tet, [&](Index around) { next.push_back(around); });
    std::ranges::sort(next);
    next.erase(std::unique(next.begin(), next.end()), next.end());
  }
  for (const Index around : next)
  {
    if (std::ranges::find(group, around) == group.end() &&
      this->extend(group, around, size - 1, balance))
    {
      return true;
    }
  }
  this->Surface.flip(tet);
  group.pop_back();
  return false;
}

/// Smaller groups first; what a repair touched is looked at again.
void repairAll(Flips& flips, const WrapComplex& kept, const AngleRepairOptions& options,
  AngleRepairReport& report, Execution& execution)
{
  Repair repair(flips, options);
  for (int size = 1; size <= kLargestGroup; ++size)
  {
    const std::vector<Index> atFeatures =
      collect<Index>(kept.flow().delaunay().tetCount(), execution,
        [&](Index tet, auto& found)
        {
          bool isAtSurface = false;
          for (Facet facet = 4 * tet; facet < 4 * tet + 4; ++facet)
          {
            isAtSurface = isAtSurface || kept.keptSides(facet) == 1;
          }
          if (isAtSurface && repair.isAtFeature(tet))
          {
            found.push_back(tet);
          }
        });
    std::deque<Index> queue(atFeatures.begin(), atFeatures.end());
    for (std::size_t steps = 0; !queue.empty(); ++steps)
    {
      if (steps % 1024 == 0)
      {
        execution.step("repair angles", static_cast<std::size_t>(size - 1), kLargestGroup);
      }
      const std::vector<Index> group = repair.repairAt(queue.front(), size);
      queue.pop_front();
      report.repairs += group.empty() ? 0 : 1;
      report.flips += static_cast<Index>(group.size());
      for (const Index tet : group)
      {
        flips.forEachAtEdges(tet, [&](Index around) { queue.push_back(around); });
      }
    }
  }
}

} // namespace

AngleRepairReport repairAngles(WrapModel& model, std::span<const Facet> triangles,
  const AngleRepairOptions& options, Execution& execution)
{
  execution.step("repair angles", 0, 1);
  const RegionVertices region(model.scan->delaunay(), triangles);
  WrapComplex repaired = *model.current;
  Flips flips(repaired, region);
  AngleRepairReport report;
  repairAll(flips, repaired, options, report, execution);

  ModelEdit edit(model);
  std::vector<Index> gone;
  for (Index tet = 0; tet < model.scan->delaunay().tetCount(); ++tet)
  {
    if (repaired.keepsTet(tet) && !model.current->keepsTet(tet))
    {
      edit.editor().addTet(tet);
    }
    else if (!repaired.keepsTet(tet) && model.current->keepsTet(tet))
    {
      gone.push_back(tet);
    }
  }
  edit.removeWhole(gone);
  static_cast<EditReport&>(report) = edit.finish(execution);
  execution.step("repair angles", 1, 1);
  return report;
}

} // namespace scan
