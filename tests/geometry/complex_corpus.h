// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/flow_complex.h"
#include "filters/geometry/wrap_model.h"

#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace scan::test
{

/// A simplex as its sorted vertices.
using Simplex = std::vector<Index>;
using Intervals = std::map<Simplex, Simplex>; // lower -> upper

/// A named point set with its seed, so that a failure can be repeated.
struct PointSet
{
  std::string name;
  std::uint64_t seed;
  std::vector<Vec3> points;
};

/// Random, grid, cospherical, coplanar-heavy and clustered point sets, with duplicates.
std::vector<PointSet> pointSets(std::uint64_t seed);

/// The seed of this run: SCAN_TEST_SEED or a fixed one.
std::uint64_t testSeed();

Simplex sorted(Simplex simplex);
std::vector<Simplex> facesOf(const Simplex& simplex); ///< all proper faces, vertices upwards
std::vector<Simplex> simplicesOf(const Simplex& lower, const Simplex& upper); ///< of an interval

/// All simplices of the complex, by brute force.
std::set<Simplex> allSimplices(const DelaunayComplex& complex);

/// All intervals, put together from what the flow complex answers.
/// Simplices that two intervals claim are appended to `conflicts`.
Intervals intervalsOf(const FlowComplex& flow, std::vector<Simplex>* conflicts = nullptr);

/// Per simplex the lower face of its interval.
std::map<Simplex, Simplex> lowerFaces(const Intervals& intervals);

/// The simplices of the Wrap complex: kept tetrahedra, triangles and their faces, and lines.
std::set<Simplex> simplicesOf(const WrapComplex& wrap);

/// The same of a wrap that may have been edited: its lines are those of the start.
std::set<Simplex> simplicesOf(const WrapModel& model);

} // namespace scan::test
