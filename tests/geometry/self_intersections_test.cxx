// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/self_intersections.h"

#include "filters/base/error.h"
#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/half_edges.h"
#include "readers/mapped_file.h"
#include "readers/off.h"
#include "readers/ply.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/geometry/mesh_fixtures.h"
#include "tests/geometry/point_fixtures.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/intersections.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <string>

namespace
{

using namespace scan;
using namespace scan::test;
using Pairs = std::vector<TrianglePair>;

Pairs found(const TriMesh& mesh, unsigned threads = 2)
{
  Execution run(threads);
  return selfIntersections(mesh, run);
}

/// Whether triangles meet beyond what they share: by CGAL's exact constructions, which make the
/// whole intersection.
bool meetInExactArithmetic(const TriMesh& mesh, Index first, Index second)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto at = [&](Index point)
  {
    const Vec3& p = mesh.points[point];
    return Exact::Point_3(p.x, p.y, p.z);
  };
  const auto triangle = [&](Index t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    return Exact::Triangle_3(at(a), at(b), at(c));
  };
  std::vector<Index> shared;
  for (const Index corner : mesh.triangles[first])
  {
    if (std::ranges::count(mesh.triangles[second], corner) > 0)
    {
      shared.push_back(corner);
    }
  }
  const auto common = CGAL::intersection(triangle(first), triangle(second));
  if (!common || shared.empty() || shared.size() == 3)
  {
    return static_cast<bool>(common);
  }
  if (shared.size() == 1)
  {
    const auto* point = boost::get<Exact::Point_3>(&*common);
    return point == nullptr || *point != at(shared[0]);
  }
  const auto* segment = boost::get<Exact::Segment_3>(&*common);
  const Exact::Segment_3 edge(at(shared[0]), at(shared[1]));
  return segment == nullptr || (*segment != edge && *segment != edge.opposite());
}

TriMesh withoutFlatTriangles(TriMesh mesh)
{
  std::erase_if(mesh.triangles,
    [&](const Triangle& t)
    { return isCollapsed(t) || isFlat(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]); });
  return mesh;
}

class SelfIntersectionsOfSoups : public testing::TestWithParam<int>
{
};

TEST_P(SelfIntersectionsOfSoups, AreThoseOfExactArithmetic)
{
  Random random(pointSeed());
  for (int round = 0; round < 20; ++round)
  {
    const TriMesh mesh = withoutFlatTriangles(meshes::soup(random, 30, 70, GetParam()));
    Pairs expected;
    for (Index i = 0; i < mesh.triangles.size(); ++i)
    {
      for (Index j = i + 1; j < mesh.triangles.size(); ++j)
      {
        if (meetInExactArithmetic(mesh, i, j))
        {
          expected.push_back({ i, j });
        }
      }
    }
    EXPECT_EQ(found(mesh), expected) << "SCAN_TEST_SEED=" << pointSeed() << " round " << round;
  }
}

TEST_P(SelfIntersectionsOfSoups, OfSomeTrianglesAreThosePairsThatHaveOne)
{
  Random random(pointSeed());
  const TriMesh mesh = meshes::soup(random, 200, 600, GetParam()); // flat ones too
  std::vector<Index> some;
  for (Index t = 0; t < mesh.triangles.size(); t += 1 + t % 7)
  {
    some.push_back(t);
  }
  Pairs expected = found(mesh);
  std::erase_if(expected,
    [&](const TrianglePair& pair)
    {
      return std::ranges::none_of(
        pair, [&](Index t) { return std::ranges::binary_search(some, t); });
    });
  Execution run;
  std::ranges::reverse(some);
  some.push_back(some[0]); // neither order nor repeats matter
  EXPECT_EQ(selfIntersections(mesh, some, run), expected) << "SCAN_TEST_SEED=" << pointSeed();
}

INSTANTIATE_TEST_SUITE_P(Grids, SelfIntersectionsOfSoups, testing::Values(0, 1, 2, 4));

TEST(SelfIntersections, OfCleanSurfacesAreNone)
{
  EXPECT_TRUE(found({}).empty());
  EXPECT_TRUE(found(corpus::tetrahedron()).empty());
  EXPECT_TRUE(found(corpus::square()).empty());
  EXPECT_TRUE(found(corpus::tetrahedraOnOneEdge()).empty());
  EXPECT_TRUE(found(corpus::tetrahedraOnOnePoint()).empty());
  EXPECT_TRUE(found(corpus::torus(60)).empty());
  EXPECT_TRUE(found(meshes::ground(50, [](double, double) { return 0.0; })).empty());
}

TEST(SelfIntersections, AFoldOverASharedEdgeIsOne)
{
  const TriMesh folded{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.2, 0.3, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  EXPECT_EQ(found(folded), (Pairs{ { 0, 1 } }));
  TriMesh opened = folded;
  opened.points[3].z = 1e-300; // hardly, but exactly
  EXPECT_TRUE(found(opened).empty());
}

TEST(SelfIntersections, ATriangleTwiceIsOneWhicheverWayItFaces)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  EXPECT_EQ(found({ points, { { 0, 1, 2 }, { 1, 2, 0 } } }), (Pairs{ { 0, 1 } }));
  EXPECT_EQ(found({ points, { { 0, 1, 2 }, { 1, 0, 2 } } }), (Pairs{ { 0, 1 } }));
}

TEST(SelfIntersections, ATouchIsOneUnlessTheCornerIsShared)
{
  // a corner on the inside, on an edge and in the place of a corner of the other
  for (const Vec3& touched : { Vec3{ 0.25, 0.25, 0 }, Vec3{ 0.5, 0, 0 }, Vec3{ 0, 0, 0 } })
  {
    TriMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, touched, { 0, 0, 1 }, { 1, 1, 1 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } };
    EXPECT_EQ(found(mesh), (Pairs{ { 0, 1 } }));
    mesh.points[3].z = 1e-300;
    EXPECT_TRUE(found(mesh).empty());
  }
  EXPECT_TRUE(found({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } },
                      { { 0, 1, 2 }, { 0, 3, 4 } } })
                .empty());
}

TEST(SelfIntersections, OfTrianglesThatShareACornerCountBeyondIt)
{
  // the far edge of the second through the first; then the first about the second in one plane
  EXPECT_EQ(found({ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.5, 0.5, -1 }, { 0.5, 0.5, 1 } },
              { { 0, 1, 2 }, { 0, 3, 4 } } }),
    (Pairs{ { 0, 1 } }));
  EXPECT_EQ(found({ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.2, 0.1, 0 }, { 0.1, 0.2, 0 } },
              { { 0, 1, 2 }, { 0, 3, 4 } } }),
    (Pairs{ { 0, 1 } }));
}

TEST(SelfIntersections, FlatAndCollapsedTrianglesAreLeftOut)
{
  const TriMesh mesh{ { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0.5, 0.5, -1 }, { 0.5, 0.5, 1 },
                        { 0.5, 0.5, 0 } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 3, 4, 4 } } };
  EXPECT_TRUE(found(mesh).empty());
  Execution run;
  EXPECT_TRUE(selfIntersections(mesh, std::vector<Index>{ 0 }, run).empty());
  EXPECT_TRUE(selfIntersections(mesh, std::vector<Index>{ 1, 2 }, run).empty());
}

TEST(SelfIntersections, OfTwoSpheresAreTheSameOnAnyNumberOfThreads)
{
  TriMesh mesh = meshes::sphere(60, 1.0);
  meshes::add(mesh, meshes::sphere(60, 1.0, { 0.7, 0.1, 0.2 }));
  const Pairs one = found(mesh, 1);
  EXPECT_GT(one.size(), 100U);
  EXPECT_TRUE(std::ranges::is_sorted(one));
  EXPECT_EQ(one, found(mesh, 4));
  for (const TrianglePair& pair : one)
  {
    EXPECT_TRUE(meetInExactArithmetic(mesh, pair[0], pair[1]));
  }
}

TEST(SelfIntersections, RefusesMissingPointsAndThoseThatAreNotFinite)
{
  EXPECT_THROW(found({ { { 0, 0, 0 } }, { { 0, 1, 2 } } }), Error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(found({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, nan, 0 } }, { { 0, 1, 2 } } }), Error);
}

/// The pairs that CGAL finds; none where it cannot hold the mesh.
std::optional<Pairs> byCgal(const TriMesh& mesh)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  for (const Vec3& p : mesh.points)
  {
    surface.add_vertex({ p.x, p.y, p.z });
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    if (surface.add_face(Surface::Vertex_index(a), Surface::Vertex_index(b),
          Surface::Vertex_index(c)) == Surface::null_face())
    {
      return std::nullopt;
    }
  }
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> faces;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(faces));
  Pairs pairs;
  for (const auto& [f, g] : faces)
  {
    const Index first = f;
    const Index second = g;
    pairs.push_back({ std::min(first, second), std::max(first, second) });
  }
  std::ranges::sort(pairs);
  return pairs;
}

TEST(SelfIntersections, OfRealMeshesAreThoseOfCgal)
{
  const std::filesystem::path folder = sharedFile("05_meshes");
  if (!std::filesystem::exists(folder))
  {
    GTEST_SKIP() << folder << " is missing";
  }
  std::size_t compared = 0;
  for (const std::filesystem::path& files : { folder, folder.parent_path() / "09_bad" })
  {
    for (const auto& file : std::filesystem::recursive_directory_iterator(files))
    {
      const std::string extension = file.path().extension();
      if (extension != ".off" && extension != ".ply")
      {
        continue;
      }
      TriMesh mesh;
      try
      {
        const MappedFile mapped(file.path());
        Execution run;
        mesh = extension == ".off" ? parseOff(mapped.bytes(), mapped.name(), run)
                                   : parsePly(mapped.bytes(), mapped.name(), run);
      }
      catch (const Error&)
      {
        continue; // it is there to be refused
      }
      const TriMesh solid = withoutFlatTriangles(mesh);
      if (const std::optional<Pairs> expected = byCgal(solid))
      {
        const Pairs pairs = found(solid);
        EXPECT_EQ(pairs, *expected) << file.path();
        std::cout << file.path().filename() << ": " << solid.triangles.size() << " triangles, "
                  << pairs.size() << " pairs\n";
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20U);
}

} // namespace
