// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/contraction_mesh.h"
#include "filters/geometry/large_array.h"
#include "filters/geometry/quadric.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace scan
{

/// Contracts edges in about the order of their costs (Garland, Heckbert 1997): sweeps over all
/// edges, each up to a threshold that rises from sweep to sweep, in the order of memory instead of
/// a heap.
///
/// The cost of an edge is w d^3, where w is the weight of the planes around its ends and d the root
/// mean square of their distances from the best place: between the sum of squares, which leaves
/// single places far off, and d alone, which wastes triangles. Edges at boundaries and sharp
/// creases add planes across. A contraction that takes the surface farther from one of its ends
/// than the threshold allows waits, so thin fins stay; one that turns a triangle over, makes a
/// needle or changes the topology does not happen.
class QuadricDecimation
{
public:
  /// @param isFixed per point 1 where it stays in its place
  QuadricDecimation(const TriMesh& mesh, std::span<const std::uint8_t> isFixed, double creaseAngle,
    Execution& execution);

  /// Per point the largest cost of a contraction that it may take part in.
  std::vector<float> costLimits;

  /// The thresholds of the sweeps. Those that are given are used again, and none beyond: then all
  /// is as it was far from where limits are new. But the last one is repeated while it helps.
  std::vector<float> thresholds;

  /// Contracts until so many triangles are left, or until no edge is left whose planes are on
  /// average (root mean square) within a distance.
  void run(std::size_t triangles, double meanDistance, Execution& execution);

  const ContractionMesh& mesh() const { return this->Mesh; }

  /// Per triangle of mesh() its number in the input.
  const std::vector<Index>& triangleNames() const { return this->TriangleNames; }

  /// The point that an input point was contracted into, at last.
  Index survivorOf(Index point);

  /// The largest cost of a contraction that made a point what it is; 0 for one without.
  float costOf(Index point) const { return this->Costs[point]; }

private:
  static constexpr float kNever = std::numeric_limits<float>::infinity();

  /// What contracting an edge gives.
  struct Contraction
  {
    Vec3 place;
    double weight = 0.0;
    float cost = kNever;
  };

  void addPlanes(double creaseAngle);
  void addPlanesAcross(Index half, const Vec3& normal, double creaseCosine);
  Contraction contraction(Index half, Quadric::Precision precision) const;
  Vec3 bestPlace(
    const Quadric& sum, const Vec3& a, const Vec3& b, Quadric::Precision precision) const;
  bool keepsShapes(Index half, const Vec3& place) const;
  double squaredLoss(Index half, const Vec3& place, double enough) const;
  float threshold(std::size_t triangles);
  void sweep(float threshold, std::size_t triangles, Execution& execution);
  void fetch(Index half) const;
  float tryContraction(Index half, float threshold);
  void contract(Index half, const Contraction& contraction);
  void updateCosts(Index point);
  void compact();

  ContractionMesh Mesh;
  std::vector<std::uint8_t> IsFixed;
  LargeArray<Quadric> Quadrics; // per point
  LargeArray<float> EdgeCosts;  // per half-edge, at the smaller one of each edge
  std::vector<float> Costs;     // per point
  std::vector<Index> Into;      // per point the one that it was contracted into, or itself
  std::vector<Index> TriangleNames;
  std::vector<float> Sample;
  double MeanDistance = 0.0;
};

} // namespace scan
