// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/consistent_surface.h"

#include "filters/base/error.h"
#include "filters/geometry/flat_triangles.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <random>

using namespace scan;

namespace
{

ConsistentSurface consistent(TriMesh mesh)
{
  Execution execution(2);
  return makeConsistent(std::move(mesh), 0.0, execution);
}

double areaOf(const TriMesh& mesh, const Triangle& t)
{
  const Vec3 n =
    cross(mesh.points[t[1]] - mesh.points[t[0]], mesh.points[t[2]] - mesh.points[t[0]]);
  return 0.5 * std::sqrt(dot(n, n));
}

/// What the header promises for every input.
void expectPromise(const TriMesh& input, const ConsistentSurface& surface)
{
  const MeshReport report = describeMesh(surface.mesh);
  EXPECT_TRUE(report.isManifold) << report.nonManifoldEdges << ' ' << report.nonManifoldVertices;
  EXPECT_TRUE(report.isOriented);
  EXPECT_EQ(report.flatTriangles + report.collapsedTriangles, 0U);
  ASSERT_EQ(surface.pointOrigin.size(), surface.mesh.points.size());
  for (std::size_t p = 0; p < surface.mesh.points.size(); ++p)
  {
    ASSERT_EQ(surface.mesh.points[p], input.points[surface.pointOrigin[p]]);
    ASSERT_TRUE(p >= input.points.size() || surface.pointOrigin[p] == p);
  }
  // triangles stay where they are: parts of each have its area together
  ASSERT_EQ(surface.triangleOrigin.size(), surface.mesh.triangles.size());
  std::vector<double> rest;
  for (const Triangle& t : input.triangles)
  {
    rest.push_back(areaOf(input, t));
  }
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t)
  {
    rest[surface.triangleOrigin[t]] -= areaOf(surface.mesh, surface.mesh.triangles[t]);
  }
  for (const double area : rest)
  {
    EXPECT_NEAR(area, 0.0, 1e-12);
  }
}

/// Ways to damage a surface that leave its shape as it was.
class Damage
{
public:
  Damage(TriMesh mesh, unsigned seed)
    : Mesh(std::move(mesh))
    , Random(seed)
  {
  }

  const TriMesh& mesh() const { return this->Mesh; }

  void doSomething()
  {
    const std::size_t t = this->Random() % this->Mesh.triangles.size();
    switch (this->Random() % 5)
    {
      case 0:
        std::swap(this->Mesh.triangles[t][0], this->Mesh.triangles[t][1]);
        break;
      case 1:
        this->Mesh.triangles.push_back(
          { this->Mesh.triangles[t][0], this->Mesh.triangles[t][0], this->Mesh.triangles[t][1] });
        break;
      case 2:
        this->addFlat(t);
        break;
      case 3:
        this->openNeedle(t);
        break;
      default:
        this->cutWithFlat(t);
    }
  }

private:
  Index add(const Vec3& point)
  {
    this->Mesh.points.push_back(point);
    return static_cast<Index>(this->Mesh.points.size() - 1);
  }

  /// A flat triangle on an edge; alone, with one point of its own.
  void addFlat(std::size_t t)
  {
    const Triangle& at = this->Mesh.triangles[t];
    const Vec3 from = this->Mesh.points[at[0]];
    const Vec3 along = this->Mesh.points[at[1]] - from;
    const Index own = this->add(from + along * 2.0);
    if (isFlat(from, from + along, this->Mesh.points[own]))
    {
      this->Mesh.triangles.push_back({ at[0], at[1], own });
    }
  }

  /// A triangle gets its own copy of a corner, and the gap a needle without width.
  void openNeedle(std::size_t t)
  {
    const Triangle at = this->Mesh.triangles[t];
    const Index copy = this->add(Vec3(this->Mesh.points[at[0]]));
    this->Mesh.triangles[t][0] = copy;
    this->Mesh.triangles.push_back({ at[0], at[1], copy });
    this->Mesh.triangles.push_back({ at[2], at[0], copy });
  }

  /// A triangle is cut at a point on its edge, where the neighbour gets a flat triangle.
  void cutWithFlat(std::size_t t)
  {
    const Triangle at = this->Mesh.triangles[t];
    const Vec3& from = this->Mesh.points[at[0]];
    const Vec3 middle = (from + this->Mesh.points[at[1]]) * 0.5;
    if (!isFlat(from, this->Mesh.points[at[1]], middle))
    {
      return;
    }
    const Index own = this->add(middle);
    this->Mesh.triangles[t] = { at[0], own, at[2] };
    this->Mesh.triangles.push_back({ own, at[1], at[2] });
    this->Mesh.triangles.push_back({ own, at[0], at[1] });
  }

  TriMesh Mesh;
  std::mt19937 Random;
};

/// Coordinates whose sums of two have no rounding.
TriMesh rounded(TriMesh mesh)
{
  for (Vec3& p : mesh.points)
  {
    for (double* const x : { &p.x, &p.y, &p.z })
    {
      *x = std::round(*x * 1024.0) / 1024.0;
    }
  }
  return mesh;
}

} // namespace

TEST(ConsistentSurface, LeavesAGoodOneAlone)
{
  for (const TriMesh& mesh : { corpus::torus(8), corpus::square(), TriMesh{ { { 1, 2, 3 } }, {} } })
  {
    const ConsistentSurface surface = consistent(mesh);
    EXPECT_EQ(surface.mesh.triangles, mesh.triangles);
    EXPECT_EQ(surface.mesh.points, mesh.points);
    EXPECT_FALSE(surface.changes.any());
    expectPromise(mesh, surface);
  }
}

TEST(ConsistentSurface, MendsDamagedClosedOnes)
{
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TriMesh torus = rounded(corpus::torus(12));
    Damage damage(torus, seed);
    for (unsigned i = 0; i < 3 * seed; ++i)
    {
      damage.doSomething();
    }
    const ConsistentSurface surface = consistent(damage.mesh());
    expectPromise(damage.mesh(), surface);
    const MeshReport report = describeMesh(surface.mesh);
    EXPECT_TRUE(report.isClosed) << report.boundaryEdges;
    EXPECT_NEAR(report.volume.value_or(0.0), *describeMesh(torus).volume, 1e-12);
    EXPECT_TRUE(surface.changes.any());
  }
}

TEST(ConsistentSurface, PartsWhatIsNoManifold)
{
  for (const TriMesh& mesh :
    { corpus::tetrahedraOnOneEdge(), corpus::tetrahedraOnOnePoint(), corpus::moebius(),
      corpus::voxelBorder(5, [](Index i, Index j, Index k) { return (i * j + k) % 2 == 0; }) })
  {
    const ConsistentSurface surface = consistent(mesh);
    expectPromise(mesh, surface);
    EXPECT_TRUE(surface.changes.any());
  }
}

TEST(ConsistentSurface, FacesOutwards)
{
  TriMesh inward = corpus::torus(8);
  for (Triangle& t : inward.triangles)
  {
    std::swap(t[0], t[1]);
  }
  const ConsistentSurface surface = consistent(inward);
  EXPECT_GT(*describeMesh(surface.mesh).volume, 0.0);
  EXPECT_EQ(surface.changes.turned, inward.triangles.size());
}

TEST(ConsistentSurface, KeepsVoids)
{
  TriMesh mesh =
    corpus::voxelBorder(5, [](Index i, Index j, Index k) { return !(i == 2 && j == 2 && k == 2); });
  const ConsistentSurface surface = consistent(mesh);
  EXPECT_FALSE(surface.changes.any());
  EXPECT_NEAR(*describeMesh(surface.mesh).volume, 124.0, 1e-12);
}

TEST(ConsistentSurface, TurnsHollowBodiesWithTheirVoids)
{
  // all of it inside out: the border faces inwards, that of the void outwards
  const TriMesh good = corpus::voxelBorder(
    5, [](Index i, Index j, Index k) { return !(i % 4 != 0 && j % 4 != 0 && k % 4 != 0); });
  ASSERT_NEAR(*describeMesh(good).volume, 98.0, 1e-12);
  TriMesh mesh = good;
  for (Triangle& t : mesh.triangles)
  {
    std::swap(t[1], t[2]);
  }
  const ConsistentSurface surface = consistent(mesh);
  EXPECT_NEAR(*describeMesh(surface.mesh).volume, 98.0, 1e-12);
  EXPECT_EQ(surface.changes.turned, mesh.triangles.size());
}

TEST(ConsistentSurface, KeepsTheFirstOfRepeatedTriangles)
{
  const TriMesh good = corpus::torus(8);
  const double volume = *describeMesh(good).volume;
  for (const std::size_t last : { std::size_t{ 1 }, std::size_t{ 2 }, good.triangles.size() })
  {
    for (const bool isReversed : { false, true })
    {
      TriMesh mesh = good;
      for (std::size_t t = 0; t < last; ++t) // neighbours, and all
      {
        const auto& [a, b, c] = good.triangles[t];
        mesh.triangles.push_back(isReversed ? Triangle{ a, c, b } : Triangle{ b, c, a });
      }
      const ConsistentSurface surface = consistent(mesh);
      EXPECT_EQ(surface.mesh.triangles, good.triangles);
      EXPECT_EQ(surface.changes.repeats, last);
      EXPECT_EQ(*describeMesh(surface.mesh).volume, volume);
    }
  }
}

TEST(ConsistentSurface, KeepsWallsBetweenBodies)
{
  // a cell of space that is full, with a wall of two layers to the next one, which is full, too
  TriMesh mesh;
  const TriMesh cube = corpus::voxelBorder(1, [](Index, Index, Index) { return true; });
  std::map<std::array<double, 3>, Index> known;
  for (const double shift : { 0.0, 1.0 })
  {
    for (const Triangle& t : cube.triangles)
    {
      Triangle moved = {};
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Vec3 p = cube.points[t[k]] + Vec3{ shift, 0, 0 };
        const auto [at, isNew] =
          known.emplace(std::array{ p.x, p.y, p.z }, static_cast<Index>(mesh.points.size()));
        if (isNew)
        {
          mesh.points.push_back(p);
        }
        moved[k] = at->second;
      }
      mesh.triangles.push_back(moved);
    }
  }
  ASSERT_EQ(mesh.points.size(), 12U);
  const ConsistentSurface surface = consistent(mesh);
  expectPromise(mesh, surface);
  const MeshReport report = describeMesh(surface.mesh);
  EXPECT_TRUE(report.isClosed);
  EXPECT_EQ(*report.volume, 2.0);
  EXPECT_EQ(report.components.size(), 2U);
  EXPECT_EQ(surface.changes.repeats, 0U);
}

TEST(ConsistentSurface, KeepsBodiesWithFinsClosed)
{
  // a fin of two layers on an edge, and a triangle that is there three times, once reversed
  TriMesh mesh = corpus::torus(8);
  const double volume = *describeMesh(mesh).volume;
  const auto [a, b, c] = mesh.triangles[0];
  mesh.points.push_back({ 9, 9, 9 });
  const auto tip = static_cast<Index>(mesh.points.size() - 1);
  mesh.triangles.push_back({ a, b, tip });
  mesh.triangles.push_back({ b, a, tip });
  mesh.triangles.push_back({ b, c, a });
  mesh.triangles.push_back({ a, c, b });
  const ConsistentSurface surface = consistent(mesh);
  const MeshReport report = describeMesh(surface.mesh);
  EXPECT_TRUE(report.isClosed && report.isManifold && report.isOriented);
  EXPECT_NEAR(*report.volume, volume, 1e-12);
  EXPECT_EQ(report.components.size(), 1U);
}

TEST(ConsistentSurface, MakesOneOfTwoLayers)
{
  // an open sheet that is there from both sides
  TriMesh mesh = corpus::square();
  const std::vector<Triangle> front = mesh.triangles;
  for (const Triangle& t : front)
  {
    mesh.triangles.push_back({ t[0], t[2], t[1] });
  }
  const ConsistentSurface surface = consistent(mesh);
  EXPECT_EQ(surface.mesh.triangles, front);
  EXPECT_EQ(surface.changes.repeats, 2U);
}

TEST(ConsistentSurface, LeavesSliversThatFaceOutwards)
{
  // it encloses 1.5e-19, less than the rounding of that
  const TriMesh sliver = { { { 0.5, 0.2, 0.29 }, { 0.6, 0, 0.18 }, { 0.1, 0.8, 0.59 },
                             { 0.1, 0.5, 0.38 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } } };
  EXPECT_FALSE(consistent(sliver).changes.any());
  TriMesh inward = sliver;
  for (Triangle& t : inward.triangles)
  {
    std::swap(t[1], t[2]);
  }
  EXPECT_EQ(consistent(inward).mesh.triangles, sliver.triangles);
}

TEST(ConsistentSurface, TurnsTheSmallerPart)
{
  TriMesh mesh = corpus::torus(8);
  const std::vector<Triangle> good = mesh.triangles;
  for (std::size_t t = 0; t < 5; ++t) // the first ones: it is not they who decide
  {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  const ConsistentSurface surface = consistent(mesh);
  EXPECT_EQ(surface.mesh.triangles, good);
  EXPECT_EQ(surface.changes.turned, 5U);
}

TEST(ConsistentSurface, RefusesMissingPoints)
{
  EXPECT_THROW(consistent({ { { 0, 0, 0 } }, { { 0, 0, 1 } } }), Error);
}
