// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/half_edges.h"

#include "filters/base/error.h"

#include <algorithm>
#include <span>
#include <string>

namespace scan
{
namespace
{

void requireValidIndices(const TriMesh& mesh)
{
  if (mesh.triangles.size() >= kNone / 3 || mesh.points.size() >= kNone)
  {
    throw Error(ErrorCode::limit,
      "mesh: more than 1,431,655,764 triangles or 4,294,967,294 points; work on parts of the "
      "model");
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (const Index point : mesh.triangles[t])
    {
      if (point >= mesh.points.size())
      {
        throw Error(ErrorCode::badInput,
          "mesh: triangle " + std::to_string(t) + " names point " + std::to_string(point) +
            " but there are only " + std::to_string(mesh.points.size()) + " points");
      }
    }
  }
}

/// Half-edges filed under the smaller end of their edge.
struct Buckets
{
  std::vector<std::uint32_t> begin;   // per point, and the end
  std::vector<std::uint64_t> entries; // larger end in the upper half, half-edge in the lower
};

Buckets fileUnderSmallerEnd(const TriMesh& mesh)
{
  Buckets buckets;
  buckets.begin.assign(mesh.points.size() + 2, 0);
  const auto forEachHalf = [&](auto&& body)
  {
    for (Index t = 0; t < mesh.triangles.size(); ++t)
    {
      const Triangle& corner = mesh.triangles[t];
      for (Index k = 0; k < 3 && !isCollapsed(corner); ++k)
      {
        const auto [low, high] = std::minmax(corner[k], corner[(k + 1) % 3]);
        body(low, high, 3 * t + k);
      }
    }
  };
  // counted two places ahead, so that filling leaves begin[] right where it belongs
  forEachHalf([&](Index low, Index, Index) { ++buckets.begin[low + 2]; });
  for (std::size_t i = 2; i < buckets.begin.size(); ++i)
  {
    buckets.begin[i] += buckets.begin[i - 1];
  }
  buckets.entries.resize(buckets.begin.back());
  forEachHalf([&](Index low, Index high, Index half)
    { buckets.entries[buckets.begin[low + 1]++] = (std::uint64_t{ high } << 32) | half; });
  return buckets;
}

void addEdge(EdgePairs& pairs, std::span<const std::uint64_t> entries)
{
  const auto half = [&](std::size_t i) { return static_cast<Index>(entries[i]); };
  ++pairs.edges;
  if (entries.size() == 1)
  {
    ++pairs.boundaryEdges;
  }
  else if (entries.size() == 2)
  {
    pairs.mate[half(0)] = half(1);
    pairs.mate[half(1)] = half(0);
  }
  else
  {
    for (std::size_t i = 0; i < entries.size(); ++i)
    {
      pairs.crowded.push_back(half(i));
    }
    pairs.crowdedBegin.push_back(static_cast<Index>(pairs.crowded.size()));
  }
}

} // namespace

EdgePairs pairEdges(const TriMesh& mesh)
{
  requireValidIndices(mesh);
  Buckets buckets = fileUnderSmallerEnd(mesh);
  EdgePairs pairs;
  pairs.mate.assign(3 * mesh.triangles.size(), kNone);
  for (std::size_t point = 0; point < mesh.points.size(); ++point)
  {
    const std::span bucket(buckets.entries.data() + buckets.begin[point],
      buckets.entries.data() + buckets.begin[point + 1]);
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t first = 0, last = 0; first < bucket.size(); first = last)
    {
      while (last < bucket.size() && bucket[last] >> 32 == bucket[first] >> 32)
      {
        ++last;
      }
      addEdge(pairs, bucket.subspan(first, last - first));
    }
  }
  return pairs;
}

} // namespace scan
