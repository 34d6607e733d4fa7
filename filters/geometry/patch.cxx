// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/patch.h"

#include "filters/geometry/half_edges.h"
#include "filters/geometry/local_plane.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scan
{
namespace
{

constexpr int kSweeps = 30; // of flips: they end by themselves in a plane, not in space

/// The triangles of a patch with their neighbours, for flips and splits.
class Connections
{
public:
  Connections(Patch& patch, const EdgeSet& taken)
    : P(patch)
    , Mesh(patch.mesh)
    , Taken(taken)
    , Mate(pairEdges(patch.mesh).mate)
  {
  }

  void flipAll(Execution& execution);
  /// Puts a point into a triangle, which becomes three.
  void split(Index triangle, const Vec3& point, double spacing);

private:
  const Vec3& at(Index point) const { return this->Mesh.points[point]; }
  Index cornerOf(Index half) const { return originOf(this->Mesh, half); }
  bool shouldFlip(Index half) const;
  bool hasEdge(Index half, Index other) const;
  void flip(Index half);
  void set(Index triangle, const Triangle& corners, const std::array<Index, 3>& mates);

  Patch& P;
  TriMesh& Mesh;
  const EdgeSet& Taken;
  std::vector<Index> Mate;
};

double angleAt(const Vec3& corner, const Vec3& a, const Vec3& b)
{
  return std::atan2(length(cross(a - corner, b - corner)), dot(a - corner, b - corner));
}

/// Whether the point where `half` begins has an edge to another.
bool Connections::hasEdge(Index half, Index other) const
{
  const auto meets = [&](Index turn) {
    return this->cornerOf(nextHalf(turn)) == other || this->cornerOf(previousHalf(turn)) == other;
  };
  Index turn = half;
  do
  {
    if (meets(turn))
    {
      return true;
    }
    turn = this->Mate[previousHalf(turn)];
  } while (turn != half && turn != kNone);
  for (turn = turn == kNone ? this->Mate[half] : kNone; turn != kNone; turn = this->Mate[turn])
  {
    turn = nextHalf(turn);
    if (meets(turn))
    {
      return true;
    }
  }
  return false;
}

bool Connections::shouldFlip(Index half) const
{
  const Index mate = this->Mate[half];
  const Index c = this->cornerOf(previousHalf(half));
  const Index d = this->cornerOf(previousHalf(mate));
  const Vec3& a = this->at(this->cornerOf(half));
  const Vec3& b = this->at(this->cornerOf(mate));
  constexpr double kSlack = 1e-6;
  if (angleAt(this->at(c), a, b) + angleAt(this->at(d), a, b) < std::numbers::pi + kSlack)
  {
    return false;
  }
  const Vec3 before = cross(b - a, this->at(c) - a) + cross(this->at(d) - a, b - a);
  const Vec3 first = cross(this->at(d) - a, this->at(c) - a);
  const Vec3 second = cross(this->at(c) - b, this->at(d) - b);
  if (!(dot(first, before) > 0.0) || !(dot(second, before) > 0.0))
  {
    return false;
  }
  const bool isTaken = c < this->P.rim() && d < this->P.rim() &&
    this->Taken.contains(this->P.names[c], this->P.names[d]);
  return !isTaken && !this->hasEdge(previousHalf(half), d);
}

void Connections::set(Index triangle, const Triangle& corners, const std::array<Index, 3>& mates)
{
  this->Mesh.triangles[triangle] = corners;
  for (Index k = 0; k < 3; ++k)
  {
    this->Mate[3 * triangle + k] = mates.at(k);
    if (mates.at(k) != kNone)
    {
      this->Mate[mates.at(k)] = 3 * triangle + k;
    }
  }
}

void Connections::flip(Index half)
{
  const Index mate = this->Mate[half];
  const Index a = this->cornerOf(half);
  const Index b = this->cornerOf(mate);
  const Index c = this->cornerOf(previousHalf(half));
  const Index d = this->cornerOf(previousHalf(mate));
  const Index bc = this->Mate[nextHalf(half)];
  const Index ca = this->Mate[previousHalf(half)];
  const Index ad = this->Mate[nextHalf(mate)];
  const Index db = this->Mate[previousHalf(mate)];
  const Index first = half / 3;
  const Index second = mate / 3;
  this->set(first, { a, d, c }, { ad, 3 * second + 2, ca });
  this->set(second, { d, b, c }, { db, bc, 3 * first + 1 });
}

void Connections::flipAll(Execution& execution)
{
  bool isChanged = true;
  for (int sweep = 0; sweep < kSweeps && isChanged; ++sweep)
  {
    execution.step("", 0, 1); // for a cancel
    isChanged = false;
    for (Index half = 0; half < this->Mate.size(); ++half)
    {
      if (this->Mate[half] != kNone && half < this->Mate[half] && this->shouldFlip(half))
      {
        this->flip(half);
        isChanged = true;
      }
    }
  }
}

void Connections::split(Index triangle, const Vec3& point, double spacing)
{
  const Triangle corners = this->Mesh.triangles[triangle];
  const Index half = 3 * triangle;
  const std::array<Index, 3> mates{ this->Mate[half], this->Mate[half + 1], this->Mate[half + 2] };
  const auto fresh = static_cast<Index>(this->Mesh.points.size());
  this->Mesh.points.push_back(point);
  this->P.spacing.push_back(spacing);
  const auto second = static_cast<Index>(this->Mesh.triangles.size());
  const Index third = second + 1;
  this->Mesh.triangles.resize(third + 1);
  this->Mate.resize(3 * this->Mesh.triangles.size());
  this->set(triangle, { corners[0], corners[1], fresh }, { mates[0], 3 * second + 2, kNone });
  this->set(second, { corners[1], corners[2], fresh }, { mates[1], 3 * third + 2, kNone });
  this->set(third, { corners[2], corners[0], fresh }, { mates[2], 3 * triangle + 2, kNone });
  this->Mate[3 * second + 2] = 3 * triangle + 1;
  this->Mate[3 * third + 2] = 3 * second + 1;
  this->Mate[3 * triangle + 2] = 3 * third + 1;
}

} // namespace

void flipEdges(Patch& patch, const EdgeSet& taken, Execution& execution)
{
  Connections(patch, taken).flipAll(execution);
}

void refinePatch(Patch& patch, double growth, const EdgeSet& taken, Execution& execution)
{
  Connections connections(patch, taken);
  connections.flipAll(execution);
  constexpr int kRounds = 100;
  for (int round = 0; round < kRounds; ++round)
  {
    const auto before = static_cast<Index>(patch.mesh.triangles.size());
    for (Index t = 0; t < before; ++t)
    {
      const Triangle corners = patch.mesh.triangles[t];
      Vec3 middle;
      double spacing = 0.0;
      for (const Index corner : corners)
      {
        middle = middle + patch.mesh.points[corner] * (1.0 / 3.0);
        spacing += patch.spacing[corner] / 3.0;
      }
      double apart = 0.0;
      bool isWide = true;
      for (const Index corner : corners)
      {
        const double distance = length(middle - patch.mesh.points[corner]);
        apart += distance / 3.0;
        isWide =
          isWide && std::numbers::sqrt2 * distance > std::max(spacing, patch.spacing[corner]);
      }
      if (isWide)
      {
        connections.split(t, middle, std::min(spacing + growth * apart, apart));
      }
    }
    if (patch.mesh.triangles.size() == before)
    {
      return;
    }
    connections.flipAll(execution);
  }
}

void evenOut(Patch& patch)
{
  std::vector<Vec3>& points = patch.mesh.points;
  std::vector<Vec3> sum(points.size());
  std::vector<double> count(points.size());
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round)
  {
    std::ranges::fill(sum, Vec3{});
    std::ranges::fill(count, 0.0);
    for (const Triangle& t : patch.mesh.triangles)
    {
      for (std::size_t k = 0; k < 3; ++k) // every edge within is met twice
      {
        sum[t[k]] = sum[t[k]] + points[t[(k + 1) % 3]] + points[t[(k + 2) % 3]];
        count[t[k]] += 2.0;
      }
    }
    for (std::size_t i = patch.rim(); i < points.size(); ++i)
    {
      points[i] = sum[i] * (1.0 / count[i]);
    }
  }
}

} // namespace scan
