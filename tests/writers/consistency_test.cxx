// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is written is an oriented manifold, closed or with boundary, without triangles that have no
// area, outwards; in every format, as programs that are not ours read it. IGES: cad_files_test.
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/mesh_checks.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/writers/lib3mf_reading.h"
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"
#include "tests/writers/surfaces.h"
#include "writers/vtkScanAutodesk3dsWriter.h"
#include "writers/vtkScanDxfWriter.h"
#include "writers/vtkScanGlbWriter.h"
#include "writers/vtkScanInventorWriter.h"
#include "writers/vtkScanObjWriter.h"
#include "writers/vtkScanOffWriter.h"
#include "writers/vtkScanPlyWriter.h"
#include "writers/vtkScanStlWriter.h"
#include "writers/vtkScanThreemfWriter.h"
#include "writers/vtkScanVrmlWriter.h"
#include "writers/vtkScanVtpWriter.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCompositeDataIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkSTLReader.h>
#include <vtkVRMLImporter.h>
#include <vtkXMLPolyDataReader.h>

#include <functional>
#include <map>
#include <optional>

namespace
{

using scan::Model;
using scan::TriMesh;
using scan::Vec3;
using scan::test::TemporaryFolder;

/// A program that reads a format.
struct Reader
{
  const char* name;
  bool keepsSharing; ///< triangles share points as they do in the file
  std::function<bool()> isThere;
  std::function<TriMesh(const std::string& path)> read;
  double tolerance = 1e-6; ///< of coordinates, relative
};

/// A format with its options, and who reads it.
struct WrittenFormat
{
  const char* name;
  const char* extension;
  std::function<vtkSmartPointer<vtkScanFileWriter>()> makeWriter;
  std::vector<Reader> readers;
  double unit = 1.0; ///< coordinates are multiplied with it

  friend void PrintTo(const WrittenFormat& format, std::ostream* stream) { *stream << format.name; }
};

template <class Writer>
auto writer(const std::function<void(Writer&)>& configure = {})
{
  return [configure]() -> vtkSmartPointer<vtkScanFileWriter>
  {
    const auto made = vtkSmartPointer<Writer>::New();
    if (configure)
    {
      configure(*made);
    }
    return made;
  };
}

bool always()
{
  return true;
}

template <class VtkReader>
TriMesh readWithVtk(const std::string& path)
{
  vtkNew<VtkReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return scan::bridge::meshOf(*reader->GetOutput());
}

TriMesh readGlbWithVtk(const std::string& path)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* const blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  const auto at = vtk::TakeSmartPointer(blocks->NewIterator());
  at->GoToFirstItem();
  return scan::bridge::meshOf(*vtkPolyData::SafeDownCast(at->GetCurrentDataObject()));
}

TriMesh readVrmlWithVtk(const std::string& path)
{
  vtkNew<vtkVRMLImporter> importer;
  importer->SetFileName(path.c_str());
  importer->Read();
  vtkActorCollection* const actors = importer->GetRenderer()->GetActors();
  actors->InitTraversal();
  vtkMapper* const mapper = actors->GetNextActor()->GetMapper();
  mapper->Update();
  return scan::bridge::meshOf(*vtkPolyData::SafeDownCast(mapper->GetInput()));
}

TriMesh readTurnedWithAssimp(const std::string& path)
{
  TriMesh mesh = scan::test::readWithAssimp(path);
  scan::test::turnBackFromAssimp(mesh);
  return mesh;
}

const Reader kAssimp{ "assimp", false, scan::test::hasAssimp, scan::test::readWithAssimp };
const Reader kTurnedAssimp{ "assimp", false, scan::test::hasAssimp, readTurnedWithAssimp };
const Reader kEzdxf{ "ezdxf", false, scan::test::hasEzdxf,
  [](const std::string& path) { return scan::test::readWithEzdxf(path).mesh; }, 1e-12 };
const Reader kCoin{ "Coin", false, scan::test::hasCoin,
  [](const std::string& path) { return TriMesh(scan::test::readWithCoin(path)); } };
const Reader kSgi{ "SGI Inventor", true, scan::test::hasSgiInventor,
  [](const std::string& path) { return TriMesh(scan::test::readWithSgiInventor(path)); }, 1e-5 };
const Reader kLib3ds{ "lib3ds", true, scan::test::hasLib3ds,
  [](const std::string& path) { return scan::test::readWithLib3ds(path).mesh; }, 1e-5 };

const std::vector<WrittenFormat> kFormats = {
  { "Autodesk3ds", "3ds", writer<vtkScanAutodesk3dsWriter>(), { kTurnedAssimp, kLib3ds } },
  { "DxfFaces", "dxf", writer<vtkScanDxfWriter>(), { kTurnedAssimp, kEzdxf } },
  { "DxfPolyface", "dxf",
    writer<vtkScanDxfWriter>([](auto& w) { w.SetFaces(scan::DxfFaces::polyface); }),
    { kTurnedAssimp, kEzdxf } },
  { "Glb", "glb", writer<vtkScanGlbWriter>(), { kAssimp, { "VTK", true, always, readGlbWithVtk } },
    1e-3 },
  { "Inventor", "iv", writer<vtkScanInventorWriter>(), { kCoin, kSgi } },
  { "Obj", "obj", writer<vtkScanObjWriter>(),
    { kAssimp, { "VTK", true, always, readWithVtk<vtkOBJReader> } } },
  { "Off", "off", writer<vtkScanOffWriter>(), { kAssimp } },
  { "PlyAscii", "ply",
    writer<vtkScanPlyWriter>([](auto& w) { w.SetEncoding(scan::Encoding::ascii); }),
    { kAssimp, { "VTK", true, always, readWithVtk<vtkPLYReader> } } },
  { "PlyBinary", "ply", writer<vtkScanPlyWriter>(),
    { kAssimp, { "VTK", true, always, readWithVtk<vtkPLYReader> } } },
  { "StlAscii", "stl",
    writer<vtkScanStlWriter>([](auto& w) { w.SetEncoding(scan::Encoding::ascii); }),
    { kAssimp, { "VTK", false, always, readWithVtk<vtkSTLReader> } } },
  { "StlBinary", "stl", writer<vtkScanStlWriter>(),
    { kAssimp, { "VTK", false, always, readWithVtk<vtkSTLReader> } } },
  { "Threemf", "3mf", writer<vtkScanThreemfWriter>(), { kAssimp } },
  { "Vrml1", "wrl", writer<vtkScanVrmlWriter>([](auto& w) { w.SetVersion1(true); }),
    { kCoin, kSgi } },
  { "Vrml97", "wrl", writer<vtkScanVrmlWriter>(),
    { kCoin, { "VTK", true, always, readVrmlWithVtk } } },
  { "Vtp", "vtp", writer<vtkScanVtpWriter>(),
    { { "VTK", true, always, readWithVtk<vtkXMLPolyDataReader>, 1e-15 } } },
};

std::string nameOf(const testing::TestParamInfo<WrittenFormat>& info)
{
  return info.param.name;
}

/// Points in one place become one.
TriMesh welded(const TriMesh& mesh)
{
  std::map<std::array<double, 3>, scan::Index> numbers;
  TriMesh result;
  for (const Vec3& p : mesh.points)
  {
    const auto number = static_cast<scan::Index>(result.points.size());
    if (numbers.try_emplace({ p.x, p.y, p.z }, number).second)
    {
      result.points.push_back(p);
    }
  }
  for (scan::Triangle t : mesh.triangles)
  {
    for (scan::Index& corner : t)
    {
      const Vec3& p = mesh.points[corner];
      corner = numbers.at({ p.x, p.y, p.z });
    }
    result.triangles.push_back(t);
  }
  return result;
}

class ConsistentFile : public testing::TestWithParam<WrittenFormat>
{
protected:
  /// The outcome of writing; the file is the format's, in the folder.
  std::string write(const Model& model)
  {
    vtkNew<vtkPolyData> data;
    scan::bridge::setModel(*data, model);
    const auto writer = GetParam().makeWriter();
    writer->SetFileName(this->path().c_str());
    writer->SetInputData(data);
    return writer->Write() == 1 ? "" : writer->GetOutcome().message;
  }

  std::string path() const { return this->Folder.file(std::string("out.") + GetParam().extension); }

  std::size_t fileCount() const { return this->Folder.fileCount(); }

  /// @param expected the surface that the file must hold
  /// @param touches whether sheets of the surface touch, so that points in one place are several
  void expectReadersFind(const TriMesh& expected, bool touches)
  {
    const double unit = GetParam().unit;
    const TriMesh inFile = scan::test::moved(Model{ expected }, {}, unit);
    const scan::MeshReport wanted = scan::describeMesh(expected);
    for (const Reader& reader : GetParam().readers)
    {
      SCOPED_TRACE(reader.name);
      if (!reader.isThere())
      {
        continue;
      }
      const TriMesh read = reader.read(this->path());
      scan::test::expectSame(read, inFile, reader.tolerance);
      const bool isSplit = GetParam().extension == std::string("3ds"); // in parts
      const scan::MeshReport report =
        scan::describeMesh(reader.keepsSharing && !isSplit ? read : welded(read));
      EXPECT_EQ(report.flatTriangles + report.collapsedTriangles, 0U);
      EXPECT_EQ(report.misorientedEdges, 0U);
      EXPECT_EQ(report.isClosed, wanted.isClosed);
      EXPECT_GE(report.volume.value_or(0.0), 0.0);
      if ((reader.keepsSharing && !isSplit) || !touches)
      {
        EXPECT_TRUE(report.isManifold) << report.nonManifoldEdges;
        EXPECT_EQ(report.boundaryEdges, wanted.boundaryEdges);
        EXPECT_EQ(report.components.size(), wanted.components.size());
      }
    }
  }

private:
  TemporaryFolder Folder;
};

} // namespace

TEST_P(ConsistentFile, OfAClosedSurfaceOf178000Triangles)
{
  const Model model = scan::test::grid(356, 250, true);
  ASSERT_EQ(model.triangles.size(), 178000U);
  ASSERT_EQ(this->write(model), "");
  this->expectReadersFind(model, false);
}

TEST_P(ConsistentFile, OfAnOpenSurface)
{
  const Model model = scan::test::grid(60, 40, false);
  ASSERT_EQ(this->write(model), "");
  this->expectReadersFind(model, false);
}

TEST_P(ConsistentFile, OfSurfacesThatAreNoManifold)
{
  for (const TriMesh& mesh : { scan::test::threeSheetsOnOneEdge(), corpus::tetrahedraOnOneEdge(),
         corpus::tetrahedraOnOnePoint() })
  {
    ASSERT_EQ(this->write(Model{ mesh }), "");
    this->expectReadersFind(scan::test::mended(mesh), true);
  }
}

TEST_P(ConsistentFile, OfADamagedSurface)
{
  const scan::test::DamagedSurface damaged = scan::test::damagedGrid();
  ASSERT_EQ(this->write(Model{ damaged.mesh }), "");
  this->expectReadersFind(damaged.mended, false);
}

TEST_P(ConsistentFile, OfNothingIsNotWritten)
{
  EXPECT_NE(this->write({}).find(" to write"), std::string::npos);
  EXPECT_EQ(this->fileCount(), 0U);
}

TEST(ConsistentStl, NeedsNoRepairByAdmesh)
{
  if (!scan::test::hasAdmesh())
  {
    GTEST_SKIP() << "admesh is not installed";
  }
  const TemporaryFolder folder;
  const std::string path = folder.file("a.stl");
  const Model closed = scan::test::grid(356, 250, true);
  const Model open = scan::test::grid(60, 40, false);
  const scan::test::DamagedSurface damaged = scan::test::damagedGrid();
  for (const scan::Encoding encoding : { scan::Encoding::binary, scan::Encoding::ascii })
  {
    const auto read = [&](const TriMesh& mesh)
    {
      vtkNew<vtkPolyData> data;
      vtkNew<vtkScanStlWriter> stl;
      scan::bridge::setModel(*data, Model{ mesh });
      stl->SetFileName(path.c_str());
      stl->SetInputData(data);
      stl->SetEncoding(encoding);
      EXPECT_EQ(stl->Write(), 1);
      return scan::test::readWithAdmesh(path);
    };
    for (const auto& [mesh, expected] :
      { std::pair<const TriMesh&, const TriMesh&>{ closed, closed }, { open, open },
        { damaged.mesh, damaged.mended } })
    {
      const scan::test::AdmeshResult result = read(mesh);
      const scan::test::Summary summary = scan::test::summaryOf(expected);
      EXPECT_EQ(result.facets, expected.triangles.size());
      EXPECT_EQ(result.parts, 1U);
      EXPECT_EQ(result.degenerate + result.backwards + result.wrongNormals, 0U);
      EXPECT_EQ(result.open == 0, scan::describeMesh(expected).isClosed);
      if (result.open == 0)
      {
        EXPECT_NEAR(result.volume, summary.volume, 1e-4 * summary.volume); // summed as float32
      }
      EXPECT_NEAR(result.low.x, summary.lowest.x, 1e-5);
      EXPECT_NEAR(result.high.z, summary.highest.z, 1e-5);
    }
  }
}

TEST(ConsistentThreemf, IsFineForLib3mf)
{
  if (!scan::test::hasLib3mf())
  {
    GTEST_SKIP() << "lib3mf is missing";
  }
  const TemporaryFolder folder;
  const std::string path = folder.file("a.3mf");
  const auto read = [&](const TriMesh& mesh)
  {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkScanThreemfWriter> threemf;
    scan::bridge::setModel(*data, Model{ mesh });
    threemf->SetFileName(path.c_str());
    threemf->SetInputData(data);
    EXPECT_EQ(threemf->Write(), 1);
    return scan::test::readWithLib3mf(path);
  };
  for (const TriMesh& mesh :
    { TriMesh(scan::test::grid(356, 250, true)), TriMesh(scan::test::grid(60, 40, false)),
      scan::test::threeSheetsOnOneEdge(), corpus::tetrahedraOnOneEdge(),
      corpus::tetrahedraOnOnePoint(), scan::test::damagedGrid().mesh })
  {
    const TriMesh expected = scan::test::mended(mesh);
    const scan::test::Lib3mfResult result = read(mesh);
    EXPECT_TRUE(result.isRead);
    EXPECT_EQ(result.warnings, 0U);
    EXPECT_EQ(result.triangles, expected.triangles.size());
    EXPECT_EQ(result.isClosed, scan::describeMesh(expected).isClosed);
  }
}

INSTANTIATE_TEST_SUITE_P(Written, ConsistentFile, testing::ValuesIn(kFormats), nameOf);
