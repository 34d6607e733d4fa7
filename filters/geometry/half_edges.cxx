// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/half_edges.h"

#include "filters/base/error.h"
#include "filters/geometry/large_array.h"

#include <algorithm>
#include <span>
#include <string>

namespace scan
{
namespace
{

/// Half-edges filed under the smaller end of their edge.
struct Buckets
{
  std::vector<std::uint32_t> begin;  // per point, and the end
  LargeArray<std::uint64_t> entries; // larger end in the upper half, half-edge in the lower
};

/// Every thread meets all half-edges and files those of its own points.
Buckets fileUnderSmallerEnd(const TriMesh& mesh, Execution& execution)
{
  Buckets buckets;
  buckets.begin.assign(mesh.points.size() + 2, 0);
  const auto forEachHalf = [&](auto&& body)
  {
    execution.parallelFor(mesh.points.size(), mesh.points.size() / execution.threads() + 1,
      [&](std::size_t first, std::size_t last)
      {
        for (Index t = 0; t < mesh.triangles.size(); ++t)
        {
          const Triangle& corner = mesh.triangles[t];
          for (Index k = 0; k < 3 && !isCollapsed(corner); ++k)
          {
            const auto [low, high] = std::minmax(corner[k], corner[(k + 1) % 3]);
            if (first <= low && low < last)
            {
              body(low, high, 3 * t + k);
            }
          }
        }
      });
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

/// What a thread finds at the points of a chunk, but for the mates.
class Pairing
{
public:
  Pairing(const TriMesh& mesh, std::vector<Index>& mate)
    : Mesh(mesh)
    , Mate(mate)
  {
    this->Found.crowdedBegin.clear();
  }

  /// @param bucket the half-edges of a point, in any order
  void addPoint(std::span<std::uint64_t> bucket)
  {
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t first = 0, last = 0; first < bucket.size(); first = last)
    {
      while (last < bucket.size() && bucket[last] >> 32 == bucket[first] >> 32)
      {
        ++last;
      }
      this->addEdge(bucket.subspan(first, last - first));
    }
  }

  /// Appends all that was found.
  void moveTo(EdgePairs& pairs)
  {
    const auto begin = static_cast<Index>(pairs.crowded.size());
    append(this->Found.crowded, pairs.crowded);
    for (const Index end : this->Found.crowdedBegin)
    {
      pairs.crowdedBegin.push_back(begin + end);
    }
    append(this->Found.misoriented, pairs.misoriented);
    pairs.edges += this->Found.edges;
    pairs.boundaryEdges += this->Found.boundaryEdges;
  }

private:
  static void append(const std::vector<Index>& items, std::vector<Index>& all)
  {
    all.insert(all.end(), items.begin(), items.end());
  }

  void addEdge(std::span<const std::uint64_t> entries)
  {
    const auto half = [&](std::size_t i) { return static_cast<Index>(entries[i]); };
    ++this->Found.edges;
    if (entries.size() == 1)
    {
      ++this->Found.boundaryEdges;
    }
    else if (entries.size() == 2)
    {
      this->Mate[half(0)] = half(1);
      this->Mate[half(1)] = half(0);
      if (originOf(this->Mesh, half(0)) == originOf(this->Mesh, half(1)))
      {
        this->Found.misoriented.push_back(half(0));
      }
    }
    else
    {
      for (std::size_t i = 0; i < entries.size(); ++i)
      {
        this->Found.crowded.push_back(half(i));
      }
      this->Found.crowdedBegin.push_back(static_cast<Index>(this->Found.crowded.size()));
    }
  }

  const TriMesh& Mesh;
  std::vector<Index>& Mate;
  EdgePairs Found;
};

} // namespace

void requireCorners(const TriMesh& mesh)
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

std::vector<std::uint8_t> oddHalves(const EdgePairs& pairs)
{
  std::vector<std::uint8_t> isOdd(pairs.mate.size(), 0);
  for (const Index half : pairs.crowded)
  {
    isOdd[half] = 1;
  }
  for (const Index half : pairs.misoriented)
  {
    isOdd[half] = isOdd[pairs.mate[half]] = 1;
  }
  return isOdd;
}

EdgePairs pairEdges(const TriMesh& mesh, Execution& execution)
{
  requireCorners(mesh);
  Buckets buckets = fileUnderSmallerEnd(mesh, execution);
  EdgePairs pairs;
  pairs.mate.assign(3 * mesh.triangles.size(), kNone);
  constexpr std::size_t kChunk = 1 << 14;
  std::vector<Pairing> chunks(
    (mesh.points.size() + kChunk - 1) / kChunk, Pairing(mesh, pairs.mate));
  execution.parallelFor(chunks.size(), 1,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t chunk = begin; chunk < end; ++chunk)
      {
        const std::size_t last = std::min(kChunk * (chunk + 1), mesh.points.size());
        for (std::size_t point = kChunk * chunk; point < last; ++point)
        {
          chunks[chunk].addPoint({ buckets.entries.data() + buckets.begin[point],
            buckets.entries.data() + buckets.begin[point + 1] });
        }
      }
    });
  for (Pairing& chunk : chunks)
  {
    chunk.moveTo(pairs);
  }
  std::ranges::sort(pairs.misoriented);
  return pairs;
}

EdgePairs pairEdges(const TriMesh& mesh)
{
  Execution oneThread(1);
  return pairEdges(mesh, oneThread);
}

} // namespace scan
