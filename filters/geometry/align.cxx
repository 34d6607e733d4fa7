// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/align.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/local_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kNeighbours = 12;
constexpr double kBorder = 0.35;  // of the way to the farthest neighbour: their middle is aside
constexpr double kSameWay = 0.7;  // cosine between the normals of partners, at least
constexpr double kFarAway = 3.0;  // medians
constexpr double kSliding = 1e-9; // of the largest eigenvalue: nothing holds the surface
constexpr double kRest = 1e-13;   // of the size of the scan: a motion that is none
constexpr double kSwaying = 1e-5; // the same, once it no longer falls
constexpr std::size_t kGrain = 1U << 8U;

Eigen::Vector3d toEigen(const Vec3& v)
{
  return { v.x, v.y, v.z };
}

Vec3 toVec3(const Eigen::Vector3d& v)
{
  return { v[0], v[1], v[2] };
}

Affine affineOf(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& shift)
{
  return { toVec3(rotation.col(0)), toVec3(rotation.col(1)), toVec3(rotation.col(2)),
    toVec3(shift) };
}

Eigen::Matrix3d rotationOf(const Affine& motion)
{
  Eigen::Matrix3d rotation;
  rotation << toEigen(motion.x), toEigen(motion.y), toEigen(motion.z);
  return rotation;
}

void refuseLine(const Eigen::Matrix3Xd& places, const std::string& option)
{
  constexpr double kLine = 1e-6;
  const Eigen::Matrix3Xd centred = places.colwise() - places.rowwise().mean();
  const Eigen::Vector3d sizes = centred.jacobiSvd().singularValues();
  if (!(sizes[1] > kLine * sizes[0]))
  {
    throw Error(ErrorCode::badParameter,
      "the points of " + option +
        " are on one line, so the scan could turn around it; pick three "
        "that make a triangle");
  }
}

/// Where the picked places come onto each other.
Affine placementOf(const AlignOptions& options)
{
  const auto count = static_cast<Eigen::Index>(options.from.size());
  if (options.onto.size() != options.from.size() || count < 3)
  {
    throw Error(ErrorCode::badParameter,
      std::to_string(options.from.size()) + " points to move from and " +
        std::to_string(options.onto.size()) +
        " to move onto; pick three pairs or more, as many of each");
  }
  Eigen::Matrix3Xd from(3, count);
  Eigen::Matrix3Xd onto(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    from.col(i) = toEigen(options.from[static_cast<std::size_t>(i)]);
    onto.col(i) = toEigen(options.onto[static_cast<std::size_t>(i)]);
  }
  refuseLine(from, "--from");
  refuseLine(onto, "--onto");
  const Eigen::Matrix4d placed = Eigen::umeyama(from, onto, false);
  return affineOf(placed.topLeftCorner<3, 3>(), placed.topRightCorner<3, 1>());
}

/// The fixed scan, with the planes of those places that were asked for.
class FixedScan
{
public:
  FixedScan(std::span<const Vec3> points, Execution& execution)
    : Places(points, execution)
    , Planes(this->Places.size())
    , IsKnown(this->Places.size(), 0)
  {
  }

  const Neighbours& places() const { return this->Places; }
  const Vec3& normalAt(Index place) const { return this->Planes[place]; }

  void findPlanes(std::vector<Index> asked, Execution& execution)
  {
    std::erase_if(asked, [&](Index place) { return this->IsKnown[place] != 0; });
    std::ranges::sort(asked);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    execution.parallelFor(asked.size(), kGrain,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          this->Planes[asked[i]] = this->innerNormal(asked[i]);
          this->IsKnown[asked[i]] = 1;
        }
      });
  }

private:
  /// Of the plane around a place; (0, 0, 0) on a border.
  Vec3 innerNormal(Index place) const
  {
    std::vector<Neighbour> found;
    this->Places.nearest(this->Places[place], kNeighbours, found);
    const LocalPlane plane = fitPlane(this->Places, found);
    const double reach = std::sqrt(found.back().squaredDistance);
    const bool isBorder = length(plane.middle - this->Places[place]) > kBorder * reach;
    return isBorder ? Vec3{} : plane.normal;
  }

  Neighbours Places;
  std::vector<Vec3> Planes;
  std::vector<std::uint8_t> IsKnown;
};

/// A sample of the moving scan and its partner.
struct Sample
{
  Vec3 start;
  Vec3 normal; // at the start
  Vec3 place;  // where it is now
  Index partner = 0;
  double distance = 0.0;
  bool isUsed = false;
};

std::vector<Sample> samplesOf(std::span<const Vec3> moving, std::size_t most, Execution& execution)
{
  const Neighbours places(moving, execution);
  std::vector<Sample> samples(std::min<std::size_t>(most, places.size()));
  execution.parallelFor(samples.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3& start = places[static_cast<Index>(i * places.size() / samples.size())];
        places.nearest(start, kNeighbours, found);
        samples[i].start = start;
        samples[i].normal = fitPlane(places, found).normal;
      }
    });
  return samples;
}

/// Finds the partners of the samples, where the motion brings them; returns how many count.
std::size_t findPartners(
  std::vector<Sample>& samples, const Affine& motion, FixedScan& fixed, Execution& execution)
{
  execution.parallelFor(samples.size(), kGrain,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<Neighbour> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        Sample& sample = samples[i];
        sample.place = motion.point(sample.start);
        fixed.places().nearest(sample.place, 1, found);
        sample.partner = found.front().place;
        sample.distance = std::sqrt(found.front().squaredDistance);
      }
    });
  std::vector<Index> partners(samples.size());
  std::ranges::transform(samples, partners.begin(), &Sample::partner);
  fixed.findPlanes(partners, execution);
  std::vector<double> distances;
  for (Sample& sample : samples)
  {
    const double cosine = dot(motion.direction(sample.normal), fixed.normalAt(sample.partner));
    sample.isUsed = std::abs(cosine) > kSameWay;
    if (sample.isUsed)
    {
      distances.push_back(sample.distance);
    }
  }
  if (distances.empty())
  {
    return 0;
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  std::size_t used = 0;
  for (Sample& sample : samples)
  {
    sample.isUsed = sample.isUsed && sample.distance <= kFarAway * *middle;
    used += sample.isUsed ? 1 : 0;
  }
  return used;
}

/// The small motion, about a middle, that brings the samples nearest to the planes of their
/// partners.
Affine bestMotion(const std::vector<Sample>& samples, const FixedScan& fixed, double size)
{
  std::vector<const Sample*> used;
  Vec3 middle;
  for (const Sample& sample : samples)
  {
    if (sample.isUsed)
    {
      used.push_back(&sample);
      middle = middle + (sample.place - samples.front().place);
    }
  }
  middle = samples.front().place + middle * (1.0 / static_cast<double>(used.size()));
  using Vector6d = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  for (const Sample* sample : used)
  {
    const Vec3& normal = fixed.normalAt(sample->partner);
    const Vec3 arm = (sample->place - middle) * (1.0 / size);
    Vector6d row;
    row << toEigen(cross(arm, normal)), toEigen(normal);
    matrix += row * row.transpose();
    right += row * (dot(fixed.places()[sample->partner] - sample->place, normal) / size);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> solver(matrix);
  Vector6d motion = Vector6d::Zero();
  for (Eigen::Index i = 0; i < 6; ++i)
  {
    if (solver.eigenvalues()[i] > kSliding * solver.eigenvalues()[5])
    {
      const Vector6d axis = solver.eigenvectors().col(i);
      motion += axis * (axis.dot(right) / solver.eigenvalues()[i]);
    }
  }
  const Eigen::Vector3d turn = motion.head<3>();
  const Eigen::Matrix3d rotation = turn.norm() > 0.0
    ? Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix()
    : Eigen::Matrix3d::Identity();
  const Eigen::Vector3d about = toEigen(middle);
  return affineOf(rotation, about - rotation * about + motion.tail<3>() * size);
}

/// The product, with a rotation that repeated products would not keep.
Affine rigid(const Affine& motion)
{
  const Eigen::Quaterniond turn(rotationOf(motion));
  return affineOf(turn.normalized().toRotationMatrix(), toEigen(motion.origin));
}

void fitScan(AlignResult& result, std::span<const Vec3> moving, std::span<const Vec3> points,
  const AlignOptions& options, Execution& execution)
{
  FixedScan fixed(points, execution);
  std::vector<Sample> samples = samplesOf(moving, options.samples, execution);
  const double size = BoundingBox(moving).diagonal();
  result.samples = samples.size();
  const auto steps = static_cast<std::size_t>(options.iterations);
  double lastChange = size;
  while (true)
  {
    execution.step("fit", static_cast<std::size_t>(result.iterations), steps);
    result.used = samples.empty() || fixed.places().size() == 0
      ? 0
      : findPartners(samples, result.motion, fixed, execution);
    if (result.used == 0 || !(size > 0.0))
    {
      throw Error(ErrorCode::badInput,
        "the scans have no surface in common where they are; pick three pairs or more with --from "
        "and --onto");
    }
    if (result.isSettled || result.iterations == options.iterations)
    {
      break;
    }
    const Affine more = bestMotion(samples, fixed, size);
    const Affine next = rigid(more * result.motion);
    double change = 0.0;
    for (const Vec3 corner :
      { samples.front().start, samples.back().start, samples[samples.size() / 2].start })
    {
      change = std::max(change, length(next.point(corner) - result.motion.point(corner)));
    }
    // where samples change their partners to and fro a fit never comes to full rest
    result.isSettled =
      change <= kRest * size || (change <= kSwaying * size && change >= lastChange);
    lastChange = change;
    result.motion = next;
    ++result.iterations;
  }
  for (const Sample& sample : samples)
  {
    if (sample.isUsed)
    {
      const double off = std::abs(
        dot(fixed.places()[sample.partner] - sample.place, fixed.normalAt(sample.partner)));
      result.rms += off * off;
      result.mean += off;
      result.largest = std::max(result.largest, off);
    }
  }
  result.rms = std::sqrt(result.rms / static_cast<double>(result.used));
  result.mean /= static_cast<double>(result.used);
}

} // namespace

AlignResult align(std::span<const Vec3> moving, std::span<const Vec3> fixed,
  const AlignOptions& options, Execution& execution)
{
  execution.step("fit", 0, 1);
  AlignResult result;
  if (!options.from.empty() || !options.onto.empty())
  {
    result.motion = placementOf(options);
    for (std::size_t i = 0; i < options.from.size(); ++i)
    {
      const Vec3 off = result.motion.point(options.from[i]) - options.onto[i];
      result.pairRms += dot(off, off) / static_cast<double>(options.from.size());
    }
    result.pairRms = std::sqrt(result.pairRms);
  }
  if (options.fit)
  {
    fitScan(result, moving, fixed, options, execution);
  }
  const double angle = Eigen::AngleAxisd(rotationOf(result.motion)).angle();
  result.angleDegrees = angle * 180.0 / std::numbers::pi;
  const BoundingBox box(moving);
  const Vec3 middle = box.low + (box.high - box.low) * 0.5;
  result.shift = length(result.motion.point(middle) - middle);
  execution.step("fit", 1, 1);
  return result;
}

} // namespace scan
