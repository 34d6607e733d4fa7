// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The VTK readers and writers of the project, against each other and against VTK's own.
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/flat_triangles.h"
#include "readers/vtkScanGltfReader.h"
#include "readers/vtkScanObjReader.h"
#include "readers/vtkScanPlyReader.h"
#include "readers/vtkScanPointsReader.h"
#include "readers/vtkScanStlReader.h"
#include "readers/vtkScanThreemfReader.h"
#include "tests/readers/temporary_folder.h"
#include "tests/writers/written.h"
#include "writers/vtkScanAutodesk3dsWriter.h"
#include "writers/vtkScanDxfWriter.h"
#include "writers/vtkScanGlbWriter.h"
#include "writers/vtkScanIgesWriter.h"
#include "writers/vtkScanObjWriter.h"
#include "writers/vtkScanPlyWriter.h"
#include "writers/vtkScanPngWriter.h"
#include "writers/vtkScanStlWriter.h"
#include "writers/vtkScanThreemfWriter.h"
#include "writers/vtkScanXyzWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPNGReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>

namespace
{

using scan::Encoding;
using State = vtkScanOutcome::State;
using scan::test::TemporaryFolder;

vtkSmartPointer<vtkPolyData> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(1.0 / 3.0, 20.0, -7.5);
  source->SetPhiResolution(20);
  source->SetThetaResolution(30);
  source->Update();
  return source->GetOutput();
}

void expectSameShape(vtkPolyData& found, vtkPolyData& expected, double tolerance)
{
  EXPECT_EQ(found.GetNumberOfPoints(), expected.GetNumberOfPoints());
  EXPECT_EQ(found.GetNumberOfPolys(), expected.GetNumberOfPolys());
  std::array<double, 6> a = {};
  std::array<double, 6> b = {};
  found.GetBounds(a.data());
  expected.GetBounds(b.data());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_NEAR(a[i], b[i], tolerance);
  }
}

template <class Writer>
int write(const std::string& path, vtkPolyData* data, Encoding encoding)
{
  vtkNew<Writer> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  writer->SetEncoding(encoding);
  return writer->Write();
}

template <class Writer, class Ours, class Theirs>
void expectReadable(const std::string& path, Encoding encoding, double tolerance)
{
  const vtkSmartPointer<vtkPolyData> expected = sphere();
  ASSERT_EQ((write<Writer>(path, expected, encoding)), 1);
  vtkNew<Ours> ours;
  ours->SetFileName(path.c_str());
  ours->Update();
  expectSameShape(*ours->GetOutput(), *expected, tolerance);
  EXPECT_EQ(ours->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkNew<Theirs> theirs;
  theirs->SetFileName(path.c_str());
  theirs->Update();
  expectSameShape(*theirs->GetOutput(), *expected, 1e-6);
}

std::string pointsFile(const TemporaryFolder& folder, const std::string& content)
{
  const std::string path = folder.file("scan.xyz");
  scan::test::setContent(path, content);
  return path;
}

/// The text of the error event, once; empty when there was none.
class ErrorText
{
public:
  explicit ErrorText(vtkObject& object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        static_cast<ErrorText*>(self)->Text += static_cast<const char*>(text);
        ++static_cast<ErrorText*>(self)->Count;
      });
    object.AddObserver(vtkCommand::ErrorEvent, this->Command);
  }

  std::string Text;
  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
};

struct Written
{
  std::string note;
  std::string error; ///< behind the name of the file
};

Written writtenBy(vtkScanFileWriter& writer, const scan::Model& model, const std::string& path = {})
{
  const TemporaryFolder folder;
  const std::string name = path.empty() ? folder.file("file") : path;
  vtkNew<vtkPolyData> data;
  scan::bridge::setModel(*data, model);
  const ErrorText error(writer);
  writer.SetFileName(name.c_str());
  writer.SetInputData(data);
  writer.Write();
  const std::string message = writer.GetOutcome().message;
  return { writer.GetNote(), message.substr(std::min(message.size(), name.size())) };
}

template <class Writer>
Written written(const scan::Model& model, Encoding encoding = Encoding::binary)
{
  vtkNew<Writer> writer;
  writer->SetEncoding(encoding);
  return writtenBy(*writer, model);
}

} // namespace

TEST(WrittenFile, IsReadByVtkToo)
{
  const TemporaryFolder folder;
  for (const Encoding encoding : { Encoding::binary, Encoding::ascii })
  {
    expectReadable<vtkScanStlWriter, vtkScanStlReader, vtkSTLReader>(
      folder.file("a.stl"), encoding, 1e-6);
    expectReadable<vtkScanPlyWriter, vtkScanPlyReader, vtkPLYReader>(
      folder.file("a.ply"), encoding, 0.0);
  }
  expectReadable<vtkScanObjWriter, vtkScanObjReader, vtkOBJReader>(
    folder.file("a.obj"), Encoding::ascii, 0.0);
}

TEST(WrittenFile, HasColorsAndNormalsForVtkToo)
{
  const TemporaryFolder folder;
  scan::Model model{ scan::test::bentStrip(20) };
  for (std::uint8_t i = 0; i < 40; ++i)
  {
    model.colors.push_back({ i, static_cast<std::uint8_t>(255 - i), 7 });
    const double angle = 0.1 * i;
    model.normals.push_back({ 0.0, std::cos(angle), std::sin(angle) });
  }
  for (const Encoding encoding : { Encoding::binary, Encoding::ascii })
  {
    scan::Execution execution;
    scan::OutputFile file(folder.file("a.ply"));
    scan::writePly(model, { .encoding = encoding }, file, execution);
    file.commit();
    vtkNew<vtkPLYReader> reader;
    reader->SetFileName(folder.file("a.ply").c_str());
    reader->Update();
    vtkDataArray* const colors = reader->GetOutput()->GetPointData()->GetArray("RGB");
    vtkDataArray* const normals = reader->GetOutput()->GetPointData()->GetNormals();
    ASSERT_NE(colors, nullptr);
    ASSERT_NE(normals, nullptr);
    ASSERT_EQ(colors->GetNumberOfTuples(), 40);
    for (std::size_t i = 0; i < 40; ++i)
    {
      const double* const color = colors->GetTuple3(static_cast<vtkIdType>(i));
      const scan::Color found = { static_cast<std::uint8_t>(color[0]),
        static_cast<std::uint8_t>(color[1]), static_cast<std::uint8_t>(color[2]) };
      EXPECT_EQ(found, model.colors[i]);
      const double* const normal = normals->GetTuple3(static_cast<vtkIdType>(i));
      EXPECT_NEAR(normal[0], model.normals[i].x, 1e-7); // VTK reads floats
      EXPECT_NEAR(normal[1], model.normals[i].y, 1e-7);
      EXPECT_NEAR(normal[2], model.normals[i].z, 1e-7);
    }
  }
}

TEST(VtkScanReader, GivesScansAVertexPerPoint)
{
  const TemporaryFolder folder;
  vtkNew<vtkScanPointsReader> reader;
  reader->SetFileName(pointsFile(folder, "1 2 3\n4 5 6\n").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfVerts(), 2);
}

TEST(VtkScanReader, TakesWhatItIsAskedFor)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("a.ply");
  write<vtkScanPlyWriter>(path, sphere(), Encoding::binary);
  vtkNew<vtkScanPlyReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetReadAs(vtkScanReader::Content::points);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), sphere()->GetNumberOfPoints());

  vtkNew<vtkScanPointsReader> points;
  ErrorText error(*points);
  points->SetFileName(pointsFile(folder, "1 2 3\n").c_str());
  points->SetReadAs(vtkScanReader::Content::mesh);
  EXPECT_EQ(points->GetExecutive()->Update(), 0);
  EXPECT_NE(error.Text.find("no triangles"), std::string::npos) << error.Text;
}

TEST(VtkScanReader, FailsWithOneClearLineAndAnEmptyOutput)
{
  const TemporaryFolder folder;
  vtkNew<vtkScanPointsReader> reader;
  ErrorText error(*reader);
  reader->SetFileName(pointsFile(folder, "1 2 3\n4 5\n").c_str());
  EXPECT_EQ(reader->GetExecutive()->Update(), 0);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(reader->GetOutcome().state, State::failed);
  EXPECT_EQ(reader->GetOutcome().code, scan::ErrorCode::parse);
  EXPECT_NE(reader->GetOutcome().message.find("scan.xyz: line 2"), std::string::npos);
  EXPECT_EQ(error.Count, 1) << error.Text;
}

TEST(VtkScanReader, StopsWhenCancelled)
{
  const TemporaryFolder folder;
  vtkNew<vtkScanPointsReader> reader;
  reader->SetFileName(pointsFile(folder, "1 2 3\n").c_str());
  scan::CancelToken token;
  token.cancel();
  reader->SetCancelToken(token);
  reader->Update();
  EXPECT_EQ(reader->GetOutcome().state, State::cancelled);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(VtkScanWriter, FailsWithOneClearLineAndNoFile)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkScanStlWriter> writer;
  ErrorText error(*writer);
  writer->SetFileName(folder.file("a.stl").c_str());
  writer->SetInputData(empty);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetOutcome().code, scan::ErrorCode::badInput);
  EXPECT_NE(error.Text.find("no triangles to write"), std::string::npos) << error.Text;
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(VtkScanPngWriter, WritesWhatVtkReads)
{
  const TemporaryFolder folder;
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(3, 2, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 18; ++i)
  {
    static_cast<unsigned char*>(picture->GetScalarPointer())[i] = static_cast<unsigned char>(9 * i);
  }
  vtkNew<vtkScanPngWriter> writer;
  writer->SetFileName(folder.file("a.png").c_str());
  writer->SetInputData(picture);
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(folder.file("a.png").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), 6);
  for (int i = 0; i < 18; ++i)
  {
    EXPECT_EQ(static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer())[i], 9 * i);
  }
}

TEST(VtkScanPngWriter, RefusesWhatPngCannotHold)
{
  const TemporaryFolder folder;
  for (const bool hasScalars : { true, false })
  {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(3, 2, 1);
    if (hasScalars)
    {
      picture->AllocateScalars(VTK_FLOAT, 1);
    }
    vtkNew<vtkScanPngWriter> writer;
    ErrorText error(*writer);
    writer->SetFileName(folder.file("a.png").c_str());
    writer->SetInputData(picture);
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_NE(error.Text.find("8 or 16 bits"), std::string::npos) << error.Text;
  }
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(3, 2, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  vtkNew<vtkScanPngWriter> writer;
  ErrorText error(*writer);
  writer->SetFileName(folder.file("nowhere/a.png").c_str());
  writer->SetInputData(picture);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(VtkScanWriter, SaysWhatItMends)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> data;
  scan::Model model{ { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5, 0, 0 } },
    { { 0, 1, 2 }, { 0, 1, 1 }, { 0, 3, 1 }, { 1, 2, 0 } } } };
  model.normals.assign(4, { 0, 0, 1 });
  scan::bridge::setModel(*data, model);
  vtkNew<vtkScanPlyWriter> writer;
  writer->SetFileName(folder.file("a.ply").c_str());
  writer->SetInputData(data);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetNote(),
    "the surface is mended: 2 triangles without area left out, 1 repeated triangle left out, 1 "
    "triangle cut");
  vtkNew<vtkScanPlyWriter> raw;
  raw->SetFileName(folder.file("b.ply").c_str());
  raw->SetInputData(data);
  raw->ConsistentOff();
  EXPECT_EQ(raw->Write(), 1);
  EXPECT_EQ(raw->GetNote(), "");
  vtkNew<vtkScanPlyReader> reader;
  reader->SetFileName(folder.file("b.ply").c_str());
  reader->Update();
  EXPECT_EQ(scan::bridge::modelOf(*reader->GetOutput()).triangles, model.triangles);
}

TEST(VtkScanWriter, TurnsNormalsWithTheirTriangles)
{
  vtkNew<vtkPolyData> data;
  scan::Model model{ scan::TriMesh{ { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } } } };
  for (const scan::Vec3& p : model.points)
  {
    const scan::Vec3 inwards = scan::Vec3{ 0.5, 0.5, 0.5 } - p;
    model.normals.push_back(inwards * (1.0 / std::sqrt(0.75)));
  }
  scan::bridge::setModel(*data, model);
  const TemporaryFolder folder;
  vtkNew<vtkScanPlyWriter> writer;
  writer->SetFileName(folder.file("a.ply").c_str());
  writer->SetInputData(data);
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetNote(), "the surface is mended: 4 triangles turned over");
  vtkNew<vtkScanPlyReader> reader;
  reader->SetFileName(folder.file("a.ply").c_str());
  reader->Update();
  const scan::Model read = scan::bridge::modelOf(*reader->GetOutput());
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_LT(dot(read.normals[i], model.normals[i]), -0.99);
  }
}

TEST(VtkScanWriter, WarnsOfManyTrianglesInIgesAndOfMissingUnits)
{
  const TemporaryFolder folder;
  const auto noteOn = [&](const scan::Model& model)
  {
    vtkNew<vtkPolyData> data;
    scan::bridge::setModel(*data, model);
    vtkNew<vtkScanIgesWriter> writer;
    writer->SetFileName(folder.file("a.igs").c_str());
    writer->SetInputData(data);
    EXPECT_EQ(writer->Write(), 1);
    return writer->GetNote();
  };
  scan::Model model{ scan::test::grid(160, 156, true) };
  ASSERT_EQ(model.triangles.size(), 49920U);
  EXPECT_EQ(noteOn(model), "the model has no unit, millimetres are written; --unit tells it");
  model.millimetresPerUnit = 25.4;
  EXPECT_EQ(noteOn(model), "");
  model = scan::test::grid(160, 157, true);
  model.millimetresPerUnit = 25.4;
  EXPECT_NE(noteOn(model).find("50240 triangles are as many surfaces"), std::string::npos);
}

TEST(VtkScanWriter, WarnsOfDigitsThatAreLost)
{
  const TemporaryFolder folder;
  const auto noteOn = [&](const scan::Model& model, Encoding encoding)
  {
    vtkNew<vtkPolyData> data;
    scan::bridge::setModel(*data, model);
    vtkNew<vtkScanStlWriter> writer;
    writer->SetFileName(folder.file("a.stl").c_str());
    writer->SetInputData(data);
    writer->SetEncoding(encoding);
    writer->ConsistentOff();
    EXPECT_EQ(writer->Write(), 1);
    return writer->GetNote();
  };
  const scan::Model near = scan::test::grid(20, 20, true);
  const scan::Model far = scan::test::moved(near, { 5e6 + 0.1, 4e6, 0 });
  EXPECT_EQ(noteOn(near, Encoding::binary), "");
  EXPECT_EQ(noteOn(far, Encoding::ascii), "");
  EXPECT_NE(
    noteOn(far, Encoding::binary).find("points of this model, which is far"), std::string::npos);
}

TEST(VtkScanWriter, DropsWhatRoundingMakesFlat)
{
  scan::Model model{
    { { { 10000000.1, 10000000.2, 0 }, { 10000000.3, 10000000.3, 0 }, { 10000005, 10000005.3, 3 } },
      { { 0, 1, 2 } } }
  };
  EXPECT_EQ(written<vtkScanAutodesk3dsWriter>(model).error,
    ": none of the 1 triangles has an area in the digits of the format; write PLY, OBJ or ascii "
    "STL");
  model.points.push_back({ 10000100, 10000000, 0 });
  model.triangles.push_back({ 0, 2, 3 });
  EXPECT_NE(written<vtkScanAutodesk3dsWriter>(model).note.find(
              "1 triangle without area left out; the format holds 7 digits"),
    std::string::npos);
  EXPECT_EQ(written<vtkScanPlyWriter>(model).note, "");
}

TEST(VtkScanWriter, AgreesWithEveryReaderOfText)
{
  // flat as float32, and what mends that is flat as float64
  const scan::Model model{
    { { { 0, 1, 0 }, { 2, 1, 0 }, { 1, 1.0000000009313226, 0 }, { 256, 1.0000002384185791, 0 } },
      { { 0, 2, 1 }, { 0, 1, 3 } } }
  };
  const TemporaryFolder folder;
  vtkNew<vtkScanThreemfWriter> writer;
  writtenBy(*writer, model, folder.file("a.3mf"));
  vtkNew<vtkScanThreemfReader> reader;
  reader->SetFileName(folder.file("a.3mf").c_str());
  reader->Update();
  const scan::Model read = scan::bridge::modelOf(*reader->GetOutput());
  EXPECT_FALSE(read.triangles.empty());
  for (const auto& [a, b, c] : read.triangles)
  {
    const std::vector<scan::Vec3> single = scan::roundedToFloat(read.points);
    EXPECT_FALSE(scan::isFlat(read.points[a], read.points[b], read.points[c]));
    EXPECT_FALSE(scan::isFlat(single[a], single[b], single[c]));
  }
}

TEST(VtkScanWriter, KeepsThePointsOfASurfaceWithoutArea)
{
  const scan::Model model{ { { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { { 0, 1, 2 } } } };
  const Written ply = written<vtkScanPlyWriter>(model);
  EXPECT_EQ(ply.note, "the surface is mended: 1 triangle without area left out");
  EXPECT_EQ(ply.error, "");
  const Written stl = written<vtkScanStlWriter>(model, Encoding::ascii);
  EXPECT_EQ(stl.error,
    ": no triangles to write; STL holds surfaces, write points as PLY or OBJ (the surface is "
    "mended: 1 triangle without area left out)");
}

TEST(VtkScanWriter, LeavesPointsAlone)
{
  // three triangles on an edge: a surface would be parted there
  const scan::Model fan{ { { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } },
    { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } } } };
  EXPECT_NE(written<vtkScanPlyWriter>(fan).note.find("repeated"), std::string::npos);
  EXPECT_EQ(written<vtkScanXyzWriter>(fan).note, "");
  vtkNew<vtkScanIgesWriter> iges;
  iges->SetEntities(scan::IgesEntities::points);
  scan::Model inches = fan;
  inches.millimetresPerUnit = 25.4;
  EXPECT_EQ(
    writtenBy(*iges, inches).note, "points alone are written, as asked, no triangles and curves");
}

TEST(VtkScanWriter, SaysWhichPointsHaveNoPlace)
{
  scan::Model model = scan::test::grid(3, 3, true);
  model.millimetresPerUnit = 1.0;
  model.points.push_back({ 1e12, 0, 0 }); // of no influence on origins and resolutions
  model.points.push_back({ 1, 1, 1 });
  const std::string note = "2 points that nothing uses left out";
  EXPECT_EQ(written<vtkScanStlWriter>(model).note, note);
  EXPECT_EQ(written<vtkScanStlWriter>(model, Encoding::ascii).note, note);
  EXPECT_EQ(written<vtkScanAutodesk3dsWriter>(model).note, note);
  EXPECT_EQ(written<vtkScanDxfWriter>(model).note, note);
  EXPECT_EQ(written<vtkScanIgesWriter>(model).note, note);
  EXPECT_EQ(written<vtkScanThreemfWriter>(model).note, note);
  EXPECT_EQ(written<vtkScanPlyWriter>(model).note, "");
  EXPECT_EQ(written<vtkScanGlbWriter>(model).note, "");
}

TEST(VtkScanWriter, KeepsTinyBodiesClosedInIges)
{
  // edges and heights near the resolution: what is left must still bound a solid
  std::mt19937 random(7);
  std::uniform_real_distribution<double> tiny(-3e-8, 3e-8);
  int solids = 0;
  for (int i = 0; i < 200; ++i)
  {
    scan::Model model = scan::test::grid(4, 5, true);
    model.millimetresPerUnit = 1.0;
    const scan::Vec3 size{ 40.0, 40.0, 10.0 };
    for (scan::Vec3& p : model.points)
    {
      p = { p.x / size.x, p.y / size.y, p.z / size.z };
    }
    for (int k = 0; k < 10; ++k) // several points to nearly one place
    {
      const std::size_t from = random() % model.points.size();
      const std::size_t to = random() % model.points.size();
      model.points[to] =
        model.points[from] + scan::Vec3{ tiny(random), tiny(random), tiny(random) };
    }
    vtkNew<vtkScanIgesWriter> iges;
    iges->SetEntities(scan::IgesEntities::solid);
    const Written result = writtenBy(*iges, model);
    solids += result.error.empty() ? 1 : 0;
    EXPECT_EQ(result.error, "") << i;
  }
  EXPECT_EQ(solids, 200);
}

TEST(VtkScanWriter, WritesManyCurvesAsSegments)
{
  scan::Model model;
  model.millimetresPerUnit = 1000.0;
  for (scan::Index i = 0; i < 10001; ++i)
  {
    for (scan::Index k = 0; k < 3; ++k)
    {
      model.points.push_back({ static_cast<double>(k), static_cast<double>(i), 0.0 });
      model.curves.corners.push_back(3 * i + k);
    }
    model.curves.endLine();
  }
  vtkNew<vtkScanGlbWriter> writer;
  const TemporaryFolder folder;
  const Written result = writtenBy(*writer, model, folder.file("a.glb"));
  EXPECT_EQ(
    result.note, "10001 curves are written as loose segments, which glTF programs draw faster");
  vtkNew<vtkScanGltfReader> reader;
  reader->SetFileName(folder.file("a.glb").c_str());
  reader->Update();
  const scan::Model read = scan::bridge::modelOf(*reader->GetOutput());
  EXPECT_EQ(read.points, model.points);
  EXPECT_EQ(read.curves, model.curves); // joined again
  EXPECT_LT(std::filesystem::file_size(folder.file("a.glb")), 1000000U);
}

TEST(VtkScanWriter, StlNormalsAreThoseOfTheStoredTriangle)
{
  const scan::Model model{ { { { 4000000.1, 0, 0 }, { 4000000.7, 0.3, 0 }, { 4000000.2, 1, 0.4 } },
    { { 0, 1, 2 } } } };
  const TemporaryFolder folder;
  vtkNew<vtkScanStlWriter> writer;
  writtenBy(*writer, model, folder.file("a.stl"));
  const std::string bytes = scan::test::contentOf(folder.file("a.stl"));
  std::array<std::array<float, 3>, 4> v = {};
  std::memcpy(v.data(), bytes.data() + 84, sizeof(v));
  for (const std::size_t k : { 2U, 3U })
  {
    double along = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      along += static_cast<double>(v[0][i]) * (static_cast<double>(v[k][i]) - v[1][i]);
    }
    EXPECT_NEAR(along, 0.0, 1e-7);
  }
}
