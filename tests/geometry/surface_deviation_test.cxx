// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_deviation.h"

#include "filters/base/error.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/local_plane.h"
#include "readers/mapped_file.h"
#include "readers/ply.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/mesh_fixtures.h"
#include "tests/geometry/point_fixtures.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <string_view>

namespace
{

using namespace scan;
using namespace scan::test;

constexpr double kSpare = 1.0101; // what the bound may be above what was found

SurfaceDeviation measure(const TriMesh& from, const TriMesh& to, unsigned threads = 2)
{
  Execution run(threads);
  const TriangleTree tree(to, run);
  return deviationFrom(from, tree, run);
}

std::vector<Index> beyond(
  const TriMesh& from, const TriMesh& to, double limit, unsigned threads = 2)
{
  Execution run(threads);
  const TriangleTree tree(to, run);
  return trianglesBeyond(from, tree, limit, run);
}

/// Calls look(triangle, point) for points all over a surface, corners and edges too.
template <class Look>
void forSamples(const TriMesh& mesh, int steps, Look&& look)
{
  for (Index t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [i, j, k] = mesh.triangles[t];
    for (int u = 0; u <= steps; ++u)
    {
      for (int v = 0; u + v <= steps; ++v)
      {
        look(t,
          (mesh.points[i] * u + mesh.points[j] * v + mesh.points[k] * (steps - u - v)) *
            (1.0 / steps));
      }
    }
  }
}

/// Checks a measurement by a dense sample: the bound holds, and what was found is on the surface.
void expectTrue(const TriMesh& from, const TriMesh& to, int steps)
{
  Execution run;
  const TriangleTree tree(to, run);
  const TriangleTree own(from, run);
  const SurfaceDeviation deviation = deviationFrom(from, tree, run);
  double most = 0.0;
  std::vector<double> ofTriangle(from.triangles.size());
  forSamples(from, steps,
    [&](Index t, const Vec3& p)
    {
      const double distance = std::sqrt(tree.nearest(p, t).squaredDistance);
      most = std::max(most, distance);
      ofTriangle[t] = std::max(ofTriangle[t], distance);
    });
  const double size =
    std::max(BoundingBox(from.points).diagonal(), BoundingBox(to.points).diagonal());
  EXPECT_LE(most, deviation.atMost + 1e-14 * size);
  EXPECT_GE(most, 0.97 * deviation.largest); // is near some sample
  EXPECT_LE(deviation.largest, deviation.atMost);
  EXPECT_LE(deviation.atMost, std::max(kSpare * deviation.largest, 1e-6 * size));
  EXPECT_NEAR(
    std::sqrt(tree.nearest(deviation.where).squaredDistance), deviation.largest, 1e-14 * size);
  EXPECT_NEAR(std::sqrt(own.nearest(deviation.where).squaredDistance), 0.0, 1e-14 * size);
  for (const double share : { 0.3, 0.7, 0.95 })
  {
    const double limit = share * deviation.largest;
    const std::vector<Index> found = trianglesBeyond(from, tree, limit, run);
    for (Index t = 0; t < from.triangles.size(); ++t)
    {
      const bool isFound = std::ranges::binary_search(found, t);
      EXPECT_TRUE(isFound || ofTriangle[t] <= limit + 1e-14 * size) << t;
      if (isFound)
      {
        const TriMesh alone{ from.points, { from.triangles[t] } };
        EXPECT_GE(deviationFrom(alone, tree, run).atMost, limit) << t;
      }
    }
  }
  EXPECT_TRUE(trianglesBeyond(from, tree, deviation.atMost * 1.0001, run).empty());
}

TEST(SurfaceDeviation, OfParallelSquaresIsTheirDistance)
{
  const TriMesh low = corpus::square();
  TriMesh high = meshes::ground(7, [](double, double) { return 0.25; });
  for (const SurfaceDeviation& d : { measure(low, high), measure(high, low) })
  {
    EXPECT_DOUBLE_EQ(d.mean, 0.25);
    EXPECT_DOUBLE_EQ(d.rms, 0.25);
    EXPECT_DOUBLE_EQ(d.largest, 0.25);
    EXPECT_NEAR(d.atMost, 0.25, 0.0026);
  }
}

TEST(SurfaceDeviation, OfEqualSurfacesIsNothing)
{
  const TriMesh mesh = corpus::torus(40);
  const SurfaceDeviation deviation = measure(mesh, mesh);
  EXPECT_LT(deviation.largest, 1e-14);
  EXPECT_LT(deviation.atMost, 1e-5);
  EXPECT_TRUE(beyond(mesh, mesh, 1e-12).empty());
}

TEST(SurfaceDeviation, FindsTheLargestInsideATriangle)
{
  // a tent with slopes of 45 degrees over two triangles on the ground: nearest at their corners
  const TriMesh tent = meshes::ground(2, [](double x, double) { return 0.5 - std::abs(x - 0.5); });
  const TriMesh ground = corpus::square();
  const SurfaceDeviation deviation = measure(ground, tent);
  const double ridge = 0.5 / std::sqrt(2.0);
  EXPECT_GE(deviation.atMost, ridge);
  EXPECT_LE(deviation.largest, ridge * (1.0 + 1e-12));
  EXPECT_GE(deviation.largest, ridge / kSpare);
  EXPECT_NEAR(deviation.where.x, 0.5, 0.01);
  EXPECT_EQ(beyond(ground, tent, ridge * 0.999), (std::vector<Index>{ 0, 1 }));
  EXPECT_TRUE(beyond(ground, tent, ridge * 1.001).empty());
}

TEST(SurfaceDeviation, OfACubeFromOneWithoutACornerIsAtThatCorner)
{
  const TriMesh cube = corpus::voxelBorder(1, [](Index, Index, Index) { return true; });
  TriMesh cut = cube;
  for (Vec3& p : cut.points)
  {
    p = p == Vec3{ 1, 1, 1 } ? Vec3{ 0.8, 0.8, 0.8 } : p;
  }
  const SurfaceDeviation deviation = measure(cube, cut);
  EXPECT_EQ(deviation.where, (Vec3{ 1, 1, 1 }));
  expectTrue(cube, cut, 40);
  expectTrue(cut, cube, 40);
}

TEST(SurfaceDeviation, OfSpheresAboutEachOtherIsTheDifferenceOfRadii)
{
  const SurfaceDeviation deviation = measure(meshes::sphere(120, 1.1), meshes::sphere(120, 1.0));
  EXPECT_NEAR(deviation.mean, 0.1, 1e-3);
  EXPECT_NEAR(deviation.rms, 0.1, 1e-3);
  EXPECT_NEAR(deviation.largest, 0.1, 1.5e-3);
}

TEST(SurfaceDeviation, MeansAreThoseOfTheIntegral)
{
  // a slope over the ground: distances rise from 0 to 1, all of them straight below
  const TriMesh slope = meshes::ground(3, [](double x, double) { return x; });
  const TriMesh ground{ { { -9, -9, 0 }, { 9, -9, 0 }, { 9, 9, 0 }, { -9, 9, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  const SurfaceDeviation deviation = measure(slope, ground);
  EXPECT_NEAR(deviation.mean, 0.5, 1e-12);
  EXPECT_NEAR(deviation.rms, std::sqrt(1.0 / 3.0), 1e-12);
  EXPECT_EQ(deviation.largest, 1.0);
}

TEST(SurfaceDeviation, IsWhatADenseSampleSays)
{
  const std::uint64_t seed = pointSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  Random random(seed);
  const auto rough = [&](Index n, double height)
  { return meshes::ground(n, [&](double, double) { return height * meshes::within1(random); }); };
  for (int round = 0; round < 3; ++round)
  {
    const TriMesh coarse = rough(4, 0.03);
    const TriMesh fine = rough(23, 0.01);
    expectTrue(coarse, fine, 60);
    expectTrue(fine, coarse, 12);
    expectTrue(meshes::soup(random, 12, 9, 0), meshes::soup(random, 30, 40, 0), 60);
    expectTrue(meshes::soup(random, 12, 9, 2), meshes::soup(random, 30, 40, 2), 60);
    expectTrue(meshes::soup(random, 9, 6, 0), coarse, 60);
  }
}

TEST(SurfaceDeviation, IsTheSameOnAnyNumberOfThreads)
{
  Random random(pointSeed());
  const TriMesh from = meshes::soup(random, 900, 600, 0);
  const TriMesh to = meshes::soup(random, 900, 800, 0);
  const SurfaceDeviation one = measure(from, to, 1);
  const SurfaceDeviation four = measure(from, to, 4);
  EXPECT_EQ(one.mean, four.mean);
  EXPECT_EQ(one.rms, four.rms);
  EXPECT_EQ(one.largest, four.largest);
  EXPECT_EQ(one.atMost, four.atMost);
  EXPECT_EQ(one.where, four.where);
  EXPECT_EQ(beyond(from, to, 0.5 * one.largest, 1), beyond(from, to, 0.5 * one.largest, 4));
}

TEST(SurfaceDeviation, OneHugeTriangleOverManyIsBoundedToo)
{
  Random random(pointSeed());
  const TriMesh fine =
    meshes::ground(150, [&](double, double) { return 0.002 * meshes::within1(random); });
  const SurfaceDeviation deviation = measure(corpus::square(), fine);
  EXPECT_LE(deviation.atMost, kSpare * deviation.largest);
  EXPECT_GT(deviation.largest, 0.0015);
  EXPECT_LT(deviation.atMost, 0.00203);
}

TEST(SurfaceDeviation, CollapsedTrianglesAndRepeatsDoNoHarm)
{
  TriMesh from = meshes::ground(3, [](double x, double y) { return 0.1 * x * y; });
  TriMesh to = corpus::square();
  meshes::add(to, to);
  to.triangles.push_back({ 0, 0, 0 });
  to.triangles.push_back({ 1, 2, 2 });
  const SurfaceDeviation expected = measure(from, corpus::square());
  from.triangles.push_back({ 3, 3, 3 });
  from.triangles.push_back({ 4, 5, 5 });
  const SurfaceDeviation deviation = measure(from, to);
  EXPECT_EQ(deviation.largest, expected.largest);
  EXPECT_NEAR(deviation.mean, expected.mean, 1e-15);
  EXPECT_LE(deviation.atMost, kSpare * deviation.largest);
}

TEST(SurfaceDeviation, RefusesWhatHasNoDistance)
{
  const TriMesh square = corpus::square();
  EXPECT_THROW(measure(square, {}), Error);
  EXPECT_THROW(beyond(square, {}, 1.0), Error);
  TriMesh bad = square;
  bad.points[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW(measure(bad, square), Error);
  bad.triangles[0][1] = 17;
  EXPECT_THROW(measure(bad, square), Error);
  EXPECT_EQ(measure({}, square).atMost, 0.0);
  EXPECT_TRUE(beyond({}, square, 0.0).empty());
}

TEST(SurfaceDeviation, CancelEndsIt)
{
  const CancelToken token;
  Execution run(2, token);
  const TriMesh mesh = corpus::torus(30);
  const TriangleTree tree(mesh, run);
  token.cancel();
  EXPECT_THROW(deviationFrom(mesh, tree, run), Cancelled);
}

TEST(SurfaceDeviation, AgreesWithTheBoundedDistanceOfCgal)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  const auto surfaceOf = [](const TriMesh& mesh)
  {
    Surface surface;
    for (const Vec3& p : mesh.points)
    {
      surface.add_vertex({ p.x, p.y, p.z });
    }
    for (const auto& [a, b, c] : mesh.triangles)
    {
      surface.add_face(
        Surface::Vertex_index(a), Surface::Vertex_index(b), Surface::Vertex_index(c));
    }
    return surface;
  };
  Random random(pointSeed());
  const auto rough = [&](Index n)
  { return meshes::ground(n, [&](double, double) { return 0.05 * meshes::within1(random); }); };
  const TriMesh torus = corpus::torus(9);
  for (const auto& [from, to] : { std::pair(rough(3), rough(8)), std::pair(rough(8), rough(3)),
         std::pair(torus, corpus::torus(25)), std::pair(meshes::sphere(6, 2.0), torus) })
  {
    constexpr double kError = 1e-3;
    const double theirs =
      CGAL::Polygon_mesh_processing::bounded_error_Hausdorff_distance<CGAL::Sequential_tag>(
        surfaceOf(from), surfaceOf(to), kError);
    const SurfaceDeviation ours = measure(from, to);
    EXPECT_GE(ours.atMost, theirs - kError) << "SCAN_TEST_SEED=" << pointSeed();
    EXPECT_LE(ours.largest, theirs + kError) << "SCAN_TEST_SEED=" << pointSeed();
  }
}

/// The distance of every vertex that Metro wrote beside its coordinates: three floats, four bytes
/// of colour, a float.
std::vector<double> distancesByMetro(const std::string& file, std::size_t vertices)
{
  const MappedFile mapped(file);
  const std::string_view text(mapped.bytes().data(), mapped.bytes().size());
  constexpr std::string_view kEnd = "end_header\n";
  const std::size_t body = text.find(kEnd) + kEnd.size();
  std::vector<double> distances;
  for (std::size_t i = 0; i < vertices; ++i)
  {
    float distance = 0.0F;
    std::memcpy(&distance, text.data() + body + 20 * i + 16, sizeof distance);
    distances.push_back(distance);
  }
  return distances;
}

TEST(SurfaceDeviation, OfTheKnotsOfMetroIsWhatItPublished)
{
  const std::string folder = sharedFile("08_deviation/metro/");
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  const auto load = [&](const char* name)
  {
    const MappedFile mapped(folder + name);
    Execution run;
    return parsePly(mapped.bytes(), mapped.name(), run);
  };
  const TriMesh fine = load("knot_orig.ply");
  const TriMesh coarse = load("knot_subsampled.ply");
  const std::vector<double> published =
    distancesByMetro(folder + "knot_orig_metro.ply", fine.points.size());
  Execution run;
  const TriangleTree tree(coarse, run);
  double sum = 0.0;
  for (std::size_t i = 0; i < published.size(); ++i)
  {
    const double distance = std::sqrt(tree.nearest(fine.points[i]).squaredDistance);
    EXPECT_NEAR(distance, published[i], 1e-5);
    sum += distance;
  }
  EXPECT_NEAR(sum / static_cast<double>(published.size()), 0.722777, 1e-5);
  const SurfaceDeviation deviation = deviationFrom(fine, tree, run);
  std::cout << "largest " << deviation.largest << ", at most " << deviation.atMost << ", mean "
            << deviation.mean << "\n";
  EXPECT_GE(deviation.largest, 2.30059 - 1e-5);
  EXPECT_LE(deviation.atMost, kSpare * deviation.largest);
  EXPECT_NEAR(deviation.largest, 2.30059, 0.03);
}

} // namespace
