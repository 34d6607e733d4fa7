// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/defects.h"

#include "filters/base/error.h"
#include "tests/geometry/mesh_corpus.h"

#include <gtest/gtest.h>

#include <utility>

using namespace scan;

namespace
{

DefectList defectsOf(const TriMesh& mesh, double smallHole = 0.0)
{
  Execution execution(2);
  return findDefects(mesh, { .smallHole = smallHole }, execution);
}

/// Kinds that there are, by their names.
std::string kindsOf(const DefectList& list)
{
  std::string names;
  for (std::size_t kind = 0; kind < kDefectKinds; ++kind)
  {
    if (list.count(static_cast<DefectKind>(kind)) > 0)
    {
      names.append(names.empty() ? "" : " ").append(kDefectNames.at(kind));
    }
  }
  return names;
}

Index addPoint(TriMesh& mesh, const Vec3& point)
{
  mesh.points.push_back(point);
  return static_cast<Index>(mesh.points.size() - 1);
}

} // namespace

TEST(Defects, AreNotFoundInGoodMeshes)
{
  const TriMesh cube = corpus::voxelBorder(1, [](Index, Index, Index) { return true; });
  const TriMesh hollow =
    corpus::voxelBorder(5, [](Index i, Index j, Index k) { return i != 2 || j != 2 || k != 2; });
  for (const TriMesh& mesh : { corpus::torus(8), corpus::torus(30), corpus::square(),
         corpus::tetrahedron(), cube, hollow, TriMesh{ { { 1, 2, 3 } }, {} }, TriMesh{} })
  {
    EXPECT_EQ(kindsOf(defectsOf(mesh, 1.0)), "");
  }
}

TEST(Defects, OfManifoldsAreListed)
{
  const DefectList edge = defectsOf(corpus::tetrahedraOnOneEdge());
  EXPECT_EQ(kindsOf(edge), "non-manifold-edges");
  ASSERT_EQ(edge.defects.size(), 1U);
  EXPECT_EQ(edge.defects[0].place, (Vec3{ 0, 0, 0.5 }));
  EXPECT_EQ(edge.defects[0].triangles.size(), 4U);
  const DefectList point = defectsOf(corpus::tetrahedraOnOnePoint());
  EXPECT_EQ(kindsOf(point), "non-manifold-points");
  ASSERT_EQ(point.defects.size(), 1U);
  EXPECT_EQ(point.defects[0].place, (Vec3{}));
  EXPECT_EQ(point.defects[0].triangles.size(), 6U);
}

TEST(Defects, OfOneSidedStripsAreInverted)
{
  EXPECT_EQ(kindsOf(defectsOf(corpus::moebius())), "inverted");
}

TEST(Defects, OfOrientationAreTheSmallerPart)
{
  TriMesh mesh = corpus::torus(10);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  const DefectList one = defectsOf(mesh);
  EXPECT_EQ(kindsOf(one), "inverted");
  ASSERT_EQ(one.defects.size(), 1U);
  EXPECT_EQ(one.defects[0].triangles, std::vector<Index>{ 7 });
  TriMesh inside = corpus::torus(10);
  for (Triangle& t : inside.triangles)
  {
    std::swap(t[0], t[1]);
  }
  EXPECT_EQ(defectsOf(inside).triangles(DefectKind::inverted), inside.triangles.size());
}

TEST(Defects, OfTrianglesAreListed)
{
  TriMesh mesh = corpus::square();
  mesh.triangles.push_back({ 0, 1, 2 });
  EXPECT_EQ(defectsOf(mesh).count(DefectKind::duplicates), 1U);
  TriMesh flat = corpus::square();
  const Index middle = addPoint(flat, { 0.5, 0, 0 });
  flat.triangles.push_back({ 1, 0, middle });
  flat.triangles.push_back({ 3, 3, 2 });
  EXPECT_EQ(defectsOf(flat).count(DefectKind::degenerate), 2U);
}

TEST(Defects, OfHeightDependOnTheThreshold)
{
  TriMesh mesh = corpus::square();
  const Index low = addPoint(mesh, { 0.5, -1e-4, 0 });
  mesh.triangles.push_back({ 1, 0, low });
  Execution execution(1);
  EXPECT_EQ(
    findDefects(mesh, { .leastHeight = 9e-5 }, execution).count(DefectKind::degenerate), 0U);
  EXPECT_EQ(
    findDefects(mesh, { .leastHeight = 1.1e-4 }, execution).count(DefectKind::degenerate), 1U);
}

TEST(Defects, AreSpikesNotCorners)
{
  TriMesh mesh = corpus::torus(24);
  const Vec3 at = mesh.points[100];
  const Vec3 out = at - Vec3{ at.x, at.y, 0 } * (2.0 / std::hypot(at.x, at.y));
  mesh.points[100] = at + out * 2.0;
  const DefectList list = defectsOf(mesh);
  ASSERT_EQ(list.count(DefectKind::spikes), 1U);
  EXPECT_EQ(list.defects.back().place, mesh.points[100]);
  // a long box, and a pyramid that goes on beyond the neighbours of its tip
  TriMesh box = corpus::voxelBorder(1, [](Index, Index, Index) { return true; });
  for (Vec3& p : box.points)
  {
    p.z *= 100.0;
  }
  EXPECT_EQ(defectsOf(box).count(DefectKind::spikes), 0U);
  TriMesh horn;
  constexpr Index kAround = 8;
  for (Index ring = 0; ring < 4; ++ring)
  {
    for (Index i = 0; i < kAround; ++i)
    {
      const double angle = 2.0 * std::numbers::pi * i / kAround;
      const double radius = ring + 1.0;
      horn.points.push_back({ radius * std::cos(angle), radius * std::sin(angle), -5.0 * radius });
    }
  }
  const Index tip = addPoint(horn, {});
  for (Index i = 0; i < kAround; ++i)
  {
    const Index next = (i + 1) % kAround;
    horn.triangles.push_back({ tip, i, next });
    for (Index ring = 0; ring < 3; ++ring)
    {
      const Index a = ring * kAround;
      horn.triangles.push_back({ a + i, a + kAround + i, a + next });
      horn.triangles.push_back({ a + next, a + kAround + i, a + kAround + next });
    }
  }
  EXPECT_EQ(defectsOf(horn).count(DefectKind::spikes), 0U);
}

TEST(Defects, OfSizeAreListed)
{
  TriMesh mesh = corpus::torus(20);
  corpus::addTetrahedron(mesh, 0.01, { 5, 5, 5 });
  const DefectList list = defectsOf(mesh);
  EXPECT_EQ(kindsOf(list), "small-components");
  EXPECT_EQ(list.triangles(DefectKind::smallComponents), 4U);
  TriMesh holed = corpus::torus(20);
  holed.triangles.erase(holed.triangles.begin() + 5);
  EXPECT_EQ(kindsOf(defectsOf(holed, 0.1)), "");
  EXPECT_EQ(kindsOf(defectsOf(holed, 3.0)), "small-holes");
}

TEST(Defects, AreSeamsWhereTheSurfaceIsTorn)
{
  TriMesh mesh = corpus::torus(12);
  const Triangle at = mesh.triangles[30];
  for (const std::size_t k : { 0U, 1U, 2U })
  {
    mesh.triangles[30][k] = addPoint(mesh, Vec3(mesh.points[at[k]]));
  }
  const DefectList list = defectsOf(mesh);
  EXPECT_EQ(list.count(DefectKind::seams), 1U);
  EXPECT_EQ(list.triangles(DefectKind::seams), 4U);
}

TEST(Defects, OfIntersectionsAreGrouped)
{
  TriMesh mesh;
  corpus::addTetrahedron(mesh, 1.0, { 0, 0, 0 });
  corpus::addTetrahedron(mesh, 1.0, { 0.2, 0.1, 0.05 });
  corpus::addTetrahedron(mesh, 1.0, { 9, 0, 0 });
  corpus::addTetrahedron(mesh, 1.0, { 9.2, 0.1, 0.05 });
  const DefectList list = defectsOf(mesh);
  EXPECT_EQ(kindsOf(list), "self-intersections");
  EXPECT_EQ(list.defects.size(), 2U);
}

TEST(Defects, KindsAreNamed)
{
  EXPECT_TRUE(parseDefectKinds("all").all());
  const DefectKinds two = parseDefectKinds("spikes,small-holes");
  EXPECT_EQ(two.count(), 2U);
  EXPECT_TRUE(has(two, DefectKind::spikes) && has(two, DefectKind::smallHoles));
  for (const char* const wrong : { "", "spike", "spikes,", "spikes, inverted", "all,spikes" })
  {
    EXPECT_THROW(parseDefectKinds(wrong), Error) << wrong;
  }
}
