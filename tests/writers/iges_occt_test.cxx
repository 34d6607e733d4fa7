// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/bounding_box.h"
#include "filters/geometry/mesh_checks.h"
#include "filters/geometry/wrap.h"
#include "readers/points_text.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/readers/parsing.h"
#include "tests/writers/iges_format.h"
#include "tests/writers/models.h"
#include "tests/writers/occt_reading.h"
#include "tests/writers/surfaces.h"
#include "writers/vtkScanIgesWriter.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace
{

using scan::IgesEntities;
using scan::TriMesh;
using scan::Vec3;
using scan::test::CadContent;
using scan::test::igesFormat;

/// What another program finds in the file.
CadContent readBack(const TriMesh& mesh, const scan::IgesOptions& options)
{
  const scan::test::TemporaryFolder folder;
  scan::test::writeModel(folder.file("x.igs"), scan::Model{ mesh }, igesFormat(options));
  return scan::test::readIgesWithOcct(folder.file("x.igs"));
}

CadContent readBack(const TriMesh& mesh, IgesEntities entities)
{
  return readBack(mesh, scan::IgesOptions{ .entities = entities });
}

TriMesh moved(TriMesh mesh, const Vec3& by)
{
  for (Vec3& p : mesh.points)
  {
    p = p + by;
  }
  return mesh;
}

void append(TriMesh& mesh, const TriMesh& piece)
{
  const auto first = static_cast<scan::Index>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), piece.points.begin(), piece.points.end());
  for (const auto& [a, b, c] : piece.triangles)
  {
    mesh.triangles.push_back({ first + a, first + b, first + c });
  }
}

/// The same corners to the last bit, repeated or not.
void expectSamePoints(std::vector<Vec3> found, std::vector<Vec3> expected)
{
  for (auto* const points : { &found, &expected })
  {
    const auto key = [](const Vec3& p) { return std::array{ p.x, p.y, p.z }; };
    std::ranges::sort(*points, {}, key);
    points->erase(std::unique(points->begin(), points->end()), points->end());
  }
  EXPECT_EQ(found.size(), expected.size());
  EXPECT_TRUE(found == expected);
}

void expectFaces(const TriMesh& mesh, IgesEntities entities, double tolerance = 1e-12)
{
  SCOPED_TRACE(static_cast<int>(entities));
  const CadContent content = readBack(mesh, entities);
  const double area = scan::describeMesh(mesh).area;
  EXPECT_EQ(content.faces, mesh.triangles.size());
  EXPECT_NEAR(content.area, area, tolerance * area);
  if (const auto volume = scan::describeMesh(mesh).volume; volume && tolerance < 1e-9)
  {
    EXPECT_NEAR(content.volume, *volume, tolerance * *volume);
  }
  EXPECT_TRUE(content.isValid);
  expectSamePoints(content.vertices, mesh.points);
}

void expectSolid(const TriMesh& mesh, double tolerance = 1e-12)
{
  const CadContent content = readBack(mesh, IgesEntities::solid);
  const scan::MeshReport report = scan::describeMesh(mesh);
  EXPECT_EQ(content.solids, report.components.size());
  EXPECT_EQ(content.faces, mesh.triangles.size());
  EXPECT_EQ(content.vertices.size(), mesh.points.size());
  EXPECT_NEAR(content.area, report.area, tolerance * report.area);
  EXPECT_NEAR(content.volume, *report.volume, tolerance * *report.volume);
  EXPECT_TRUE(content.isValid);
  expectSamePoints(content.vertices, mesh.points);
}

} // namespace

TEST(IgesInOcct, HasAFaceForEachTriangle)
{
  for (const IgesEntities entities : { IgesEntities::faces, IgesEntities::nurbs })
  {
    expectFaces(corpus::torus(20), entities);
    expectFaces(corpus::square(), entities);
    expectFaces(corpus::tetrahedraOnOneEdge(), entities);
    expectFaces(corpus::moebius(), entities);
  }
  expectFaces(corpus::torus(42), IgesEntities::faces);
}

TEST(IgesInOcct, IsAValidSolid)
{
  expectSolid(corpus::tetrahedron());
  expectSolid(corpus::torus(42));
  TriMesh two = corpus::torus(10);
  append(two, moved(corpus::torus(8), { 0, 0, 20 }));
  expectSolid(two);
}

TEST(IgesInOcct, HasVoids)
{
  TriMesh mesh = corpus::torus(16);
  TriMesh hollow = corpus::tetrahedron();
  for (Vec3& p : hollow.points)
  {
    p = (p - Vec3{ 0.5, 0.5, 0.5 }) * 0.5 + Vec3{ 2, 0, 0 };
  }
  for (scan::Triangle& triangle : hollow.triangles)
  {
    std::swap(triangle[0], triangle[1]);
  }
  append(mesh, hollow);
  const CadContent content = readBack(mesh, IgesEntities::solid);
  EXPECT_EQ(content.solids, 1);
  EXPECT_EQ(content.shells, 2);
  EXPECT_NEAR(content.volume, *scan::describeMesh(mesh).volume, 1e-12);
  EXPECT_TRUE(content.isValid);
}

TEST(IgesInOcct, KeepsModelsFarFromTheOrigin)
{
  const TriMesh far = moved(corpus::torus(12), { 5e9, -3e9, 1e9 }); // 5,000 km in mm
  expectFaces(far, IgesEntities::faces, 1e-6);
  expectFaces(far, IgesEntities::nurbs, 1e-6);
  expectSolid(far, 1e-6);
}

TEST(IgesInOcct, HasLinesAndPoints)
{
  const TriMesh mesh = scan::test::bentStrip(50);
  const CadContent lines = readBack(mesh, IgesEntities::wireframe);
  EXPECT_EQ(lines.faces, 0);
  expectSamePoints(lines.vertices, mesh.points);
  double length = 0.0;
  for (const scan::Triangle& triangle : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3 edge = mesh.points[triangle[(k + 1) % 3]] - mesh.points[triangle[k]];
      length += std::sqrt(dot(edge, edge));
    }
  }
  EXPECT_NEAR(lines.length, length, 1e-12 * length);
  expectSamePoints(readBack(mesh, IgesEntities::points).vertices, mesh.points);
}

TEST(IgesInOcct, HasCurves)
{
  scan::Model model = scan::test::withCurves(scan::Model{ corpus::torus(8) });
  double length = 0.0;
  for (const std::vector<Vec3>& curve : scan::test::placesOf(model))
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      length += std::sqrt(dot(curve[i] - curve[i - 1], curve[i] - curve[i - 1]));
    }
  }
  const auto contentOf = [](const scan::Model& written, IgesEntities entities)
  {
    const scan::test::TemporaryFolder folder;
    scan::test::writeModel(folder.file("x.igs"), written, igesFormat(entities));
    return scan::test::readIgesWithOcct(folder.file("x.igs"));
  };
  scan::Model plain = model;
  plain.curves = {};
  for (const IgesEntities entities : { IgesEntities::faces, IgesEntities::solid })
  {
    const CadContent with = contentOf(model, entities);
    const CadContent without = contentOf(plain, entities);
    EXPECT_EQ(with.faces, static_cast<int>(model.triangles.size()));
    EXPECT_NEAR(with.length - without.length, length, 1e-9);
  }
  model.triangles.clear();
  EXPECT_NEAR(contentOf(model, IgesEntities::faces).length, length, 1e-12);
}

TEST(IgesInOcct, HasTheUnit)
{
  const auto widthOf = [](double millimetresPerUnit)
  {
    const scan::test::TemporaryFolder folder;
    scan::test::writeModel(folder.file("x.igs"), scan::Model{ corpus::tetrahedron() },
      igesFormat({ .entities = IgesEntities::solid }, millimetresPerUnit));
    const CadContent content = scan::test::readIgesWithOcct(folder.file("x.igs"));
    const scan::BoundingBox box(content.vertices);
    return box.high.x - box.low.x;
  };
  EXPECT_DOUBLE_EQ(widthOf(0.0), 1.0);
  EXPECT_DOUBLE_EQ(widthOf(10.0), 10.0);
  EXPECT_DOUBLE_EQ(widthOf(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(widthOf(25.4), 25.4);
  EXPECT_DOUBLE_EQ(widthOf(1200.0 / 3937.0 * 1000.0), 1200.0 / 3937.0 * 1000.0);
}

/// What the promise of consistency_test.cxx comes to in IGES.
class ConsistentIges : public testing::TestWithParam<IgesEntities>
{
protected:
  std::string write(const TriMesh& mesh)
  {
    vtkNew<vtkPolyData> data;
    scan::bridge::setModel(*data, scan::Model{ mesh });
    vtkNew<vtkScanIgesWriter> writer;
    writer->SetFileName(this->path().c_str());
    writer->SetInputData(data);
    writer->SetEntities(GetParam());
    return writer->Write() == 1 ? "" : writer->GetOutcome().message;
  }

  void expectOcctFinds(const TriMesh& expected)
  {
    const CadContent content = scan::test::readIgesWithOcct(this->path());
    const scan::MeshReport report = scan::describeMesh(expected);
    const scan::BoundingBox box(expected.points);
    const scan::BoundingBox found(content.vertices);
    EXPECT_EQ(content.faces, expected.triangles.size());
    EXPECT_NEAR(content.area, report.area, 1e-6 * report.area);
    EXPECT_TRUE(content.isValid);
    EXPECT_NEAR(content.volume, scan::test::summaryOf(expected).volume,
      1e-6 * std::abs(content.volume) + (report.isClosed ? 0.0 : 1e9));
    EXPECT_EQ(found.low, box.low);
    EXPECT_EQ(found.high, box.high);
    if (GetParam() == IgesEntities::solid)
    {
      EXPECT_EQ(content.solids, static_cast<int>(report.components.size()));
    }
  }

  std::string path() const { return this->Folder.file("out.igs"); }
  std::size_t fileCount() const { return this->Folder.fileCount(); }

private:
  scan::test::TemporaryFolder Folder;
};

TEST_P(ConsistentIges, OfAClosedSurfaceOf20000Triangles)
{
  const TriMesh mesh = scan::test::grid(100, 100, true);
  ASSERT_EQ(mesh.triangles.size(), 20000U);
  ASSERT_EQ(this->write(mesh), "");
  this->expectOcctFinds(mesh);
}

TEST_P(ConsistentIges, OfAnOpenSurface)
{
  const TriMesh mesh = scan::test::grid(20, 15, false);
  if (GetParam() == IgesEntities::solid)
  {
    EXPECT_NE(this->write(mesh).find("boundary edges"), std::string::npos);
    EXPECT_EQ(this->fileCount(), 0U);
    return;
  }
  ASSERT_EQ(this->write(mesh), "");
  this->expectOcctFinds(mesh);
}

TEST_P(ConsistentIges, OfSurfacesThatAreNoManifold)
{
  for (const TriMesh& mesh : { corpus::tetrahedraOnOneEdge(), corpus::tetrahedraOnOnePoint() })
  {
    ASSERT_EQ(this->write(mesh), "");
    this->expectOcctFinds(scan::test::mended(mesh));
  }
}

TEST_P(ConsistentIges, OfADamagedSurface)
{
  const scan::test::DamagedSurface damaged = scan::test::damagedGrid();
  ASSERT_EQ(this->write(damaged.mesh), "");
  this->expectOcctFinds(damaged.mended);
}

TEST_P(ConsistentIges, OfASurfaceWithATriangleBelowItsResolution)
{
  // the wrap of this scan has a triangle of height 1.2e-25
  scan::Execution execution;
  const scan::Model scan =
    scan::test::parse(scan::parsePointsText, scan::test::contentOf(SCAN_DATA_DIR "/helix.xyz"));
  const TriMesh mesh = scan::wrap(scan.points, {}, execution).surface;
  ASSERT_TRUE(scan::describeMesh(mesh).isClosed);
  ASSERT_EQ(this->write(mesh), "");
  const CadContent content = scan::test::readIgesWithOcct(this->path());
  EXPECT_TRUE(content.isValid);
  EXPECT_EQ(content.faces, mesh.triangles.size()); // one less, and its neighbour is two
  EXPECT_NEAR(content.volume, *scan::describeMesh(mesh).volume, 1e-9);
}

TEST_P(ConsistentIges, OfNothingIsNotWritten)
{
  EXPECT_NE(this->write({}).find("no points to write"), std::string::npos);
  EXPECT_EQ(this->fileCount(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Written, ConsistentIges,
  testing::Values(IgesEntities::faces, IgesEntities::solid, IgesEntities::nurbs));
