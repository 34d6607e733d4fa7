// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/incidence.h"
#include "filters/geometry/mesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace scan
{

class Neighbours;

/// What a region consists of.
enum class RegionElements
{
  points,
  triangles
};

/// Which elements of a model are next to each other. Elements meet at joints:
/// - triangles at their corners;
/// - points of a mesh in their triangles;
/// - points of a scan at one place and those around it: of the 16 nearest places those within twice
///   the local spacing of both ends, the distance of the 8th nearest. A stray point is next to
///   none.
///
/// Linear in time and memory but for the search on scans, O(n log n). Keeps a reference to the
/// mesh.
class RegionAdjacency
{
public:
  /// @throws Error{badInput} when a triangle names a missing point
  RegionAdjacency(const TriMesh& mesh, RegionElements elements, Execution& execution);

  /// The elements, 1 each, that are at most so many steps from one that is chosen.
  std::vector<std::uint8_t> grow(
    std::vector<std::uint8_t> chosen, std::size_t rings, Execution& execution) const;

  /// Per element one element that stands for its connected part. Triangles are connected by edges.
  std::vector<Index> parts(Execution& execution) const;

  /// Points that suggest the surface around a point, without the point: at most 64, of a mesh ring
  /// by ring until there are 12. Only where the elements are points.
  std::vector<Index> around(Index point) const;

private:
  static constexpr std::size_t kNearest = 16;
  using Nearest = std::array<Index, kNearest>;

  void joinPlaces(Execution& execution);
  void findNearest(const Neighbours& places, Execution& execution);
  bool isScan() const { return this->Mesh.triangles.empty(); }
  std::size_t elements() const;
  std::size_t joints() const;
  template <class Visit>
  void forEachJoint(Index element, Visit&& visit) const;
  template <class Visit>
  void forEachElement(Index joint, Visit&& visit) const;

  const TriMesh& Mesh;
  RegionElements Kind;
  Incidence AtPoint; ///< the triangles at every point of a mesh

  std::vector<Index> PlaceOf;  ///< per point of a scan
  Incidence AtPlace;           ///< the points at every place
  std::vector<Nearest> NearTo; ///< per place others, as far as they are next to it, then kNone
  Incidence NearFrom;          ///< per place those that have it in NearTo
};

} // namespace scan
