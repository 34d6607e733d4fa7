// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's own files: what is written, read by VTK and by ours; what is read, whoever wrote it.
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "readers/vtkScanLegacyVtkReader.h"
#include "readers/vtkScanVtpReader.h"
#include "readers/vtp.h"
#include "tests/readers/temporary_folder.h"
#include "tests/writers/written.h"
#include "writers/vtkScanVtpWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

namespace
{

using namespace scan;
using namespace scan::test;
using State = vtkScanOutcome::State;

Model colouredStrip()
{
  Model model{ bentStrip(50) };
  for (std::size_t i = 0; i < model.points.size(); ++i)
  {
    model.colors.push_back({ static_cast<std::uint8_t>(i), 7, 255 });
    model.normals.push_back({ 0.6, 0.0, i % 2 == 0 ? 0.8 : -0.8 });
  }
  model.curves = { { 3, 1, 4, 0, 2, 3, 0 }, { 3, 7 } };
  model.millimetresPerUnit = 25.4;
  return model;
}

vtkSmartPointer<vtkPolyData> dataOf(const Model& model)
{
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  bridge::setModel(*data, model);
  return data;
}

int write(const std::string& path, vtkPolyData* data)
{
  vtkNew<vtkScanVtpWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  return writer->Write();
}

struct Reading
{
  Model model;
  vtkScanOutcome outcome;
};

template <class Reader = vtkScanVtpReader>
Reading read(const std::string& path, const CancelToken& token = {})
{
  vtkNew<Reader> reader;
  vtkNew<vtkCallbackCommand> silent; // errors would be printed
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->SetFileName(path.c_str());
  reader->SetCancelToken(token);
  reader->Update();
  return { bridge::modelOf(*reader->GetOutput()), reader->GetOutcome() };
}

template <class Reader = vtkScanVtpReader>
Reading readBytes(const std::string& bytes)
{
  const TemporaryFolder folder;
  setContent(folder.file("file"), bytes);
  return read<Reader>(folder.file("file"));
}

/// The message behind the name of the file; empty when it is accepted.
std::string errorOf(const std::string& bytes)
{
  const Reading reading = readBytes(bytes);
  if (reading.outcome.state == State::ok)
  {
    return {};
  }
  EXPECT_EQ(reading.outcome.code, ErrorCode::parse) << reading.outcome.message;
  EXPECT_TRUE(reading.model.points.empty());
  EXPECT_EQ(reading.outcome.message.find('\n'), std::string::npos);
  const std::size_t name = reading.outcome.message.find("/file: ");
  return name == std::string::npos ? reading.outcome.message
                                   : reading.outcome.message.substr(name + 7);
}

void expectSame(const Model& a, const Model& b)
{
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.curves, b.curves);
  EXPECT_EQ(a.colors, b.colors);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.millimetresPerUnit, b.millimetresPerUnit);
}

/// The file of VTK's own writer.
std::string xmlBytes(vtkPolyData* data, int mode, int compressor)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetDataMode(mode);
  writer->SetCompressorType(compressor);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

std::string legacyBytes(vtkPolyData* data, bool isBinary, int version)
{
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileType(isBinary ? VTK_BINARY : VTK_ASCII);
  writer->SetFileVersion(version);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputStdString();
}

const std::string kAsciiXml =
  R"(<?xml version="1.0"?>
<!-- "a comment" -->
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
<PolyData><Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="1" NumberOfPolys="1">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1 0 0 1 1 0.1 0 1 0</DataArray></Points>
<Strips><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Strips>
<Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray></Polys>
</Piece></PolyData></VTKFile>
)";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
  return text.replace(text.find(from), from.size(), to);
}

} // namespace

TEST(Vtp, ComesBackExactly)
{
  const TemporaryFolder folder;
  const Model model = colouredStrip();
  ASSERT_EQ(write(folder.file("a.vtp"), dataOf(model)), 1);
  const Reading reading = read(folder.file("a.vtp"));
  EXPECT_EQ(reading.outcome.state, State::ok) << reading.outcome.message;
  expectSame(reading.model, model);
}

TEST(Vtp, KeepsScans)
{
  const TemporaryFolder folder;
  Model scan = colouredStrip();
  scan.triangles.clear();
  scan.curves = {};
  ASSERT_EQ(write(folder.file("a.vtp"), dataOf(scan)), 1);
  expectSame(read(folder.file("a.vtp")).model, scan);
}

TEST(Vtp, IsReadByVtkWithAllItsArrays)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> data = dataOf(colouredStrip());
  vtkNew<vtkIdTypeArray> blocks;
  blocks->SetName(arrays::kBlock);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    blocks->InsertNextValue(i / 3);
  }
  data->GetCellData()->AddArray(blocks);
  ASSERT_EQ(write(folder.file("a.vtp"), data), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("a.vtp").c_str());
  reader->Update();
  vtkPolyData& found = *reader->GetOutput();
  EXPECT_EQ(found.GetPoints()->GetDataType(), VTK_DOUBLE);
  expectSame(bridge::modelOf(found), colouredStrip());
  vtkDataArray* const array = found.GetCellData()->GetArray(arrays::kBlock);
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetTuple1(91), 30.0);
}

TEST(Vtp, KeepsArraysOfMendedSurfaces)
{
  Model model; // three triangles on an edge, one that names a point twice, and a curve
  model.points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { -1, 1, 0 }, { -1, -1, 0 } };
  model.triangles = { { 0, 1, 2 }, { 3, 3, 4 }, { 0, 1, 3 }, { 0, 1, 4 } };
  model.curves = { { 0, 4 }, { 2 } };
  const vtkSmartPointer<vtkPolyData> data = dataOf(model);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Id");
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName("Cell");
  for (vtkIdType i = 0; i < 5; ++i) // five points; a line and four triangles
  {
    ids->InsertNextValue(10 + i);
    cells->InsertNextValue(20 + i);
  }
  data->GetPointData()->AddArray(ids);
  data->GetCellData()->AddArray(cells);
  const TemporaryFolder folder;
  vtkNew<vtkScanVtpWriter> writer;
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->SetInputData(data);
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_NE(writer->GetNote().find("1 triangle without area left out"), std::string::npos);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("a.vtp").c_str());
  reader->Update();
  vtkPolyData* const read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPolys(), 3);
  ASSERT_EQ(read->GetNumberOfLines(), 1);
  for (vtkIdType i = 0; i < read->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(read->GetPointData()->GetArray("Id")->GetTuple1(i));
    std::array<double, 3> place{};
    std::array<double, 3> original{};
    read->GetPoint(i, place.data());
    data->GetPoint(id - 10, original.data());
    EXPECT_EQ(place, original);
  }
  vtkDataArray* const cell = read->GetCellData()->GetArray("Cell");
  ASSERT_EQ(cell->GetNumberOfTuples(), 4);
  for (const int i : { 0, 1, 2, 3 })
  {
    EXPECT_EQ(cell->GetTuple1(i), i < 2 ? 20.0 + i : 21.0 + i);
  }
}

TEST(Vtp, TurnsNormalsWithTheirTriangles)
{
  Model model{ TriMesh{ { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 }, { 9, 9, 9 } },
    { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 3 }, { 1, 2, 3 } } } }; // inwards
  for (const Vec3& p : model.points)
  {
    model.normals.push_back(Vec3{ 0.5, 0.5, 0.5 } - p);
  }
  const vtkSmartPointer<vtkPolyData> data = dataOf(model);
  vtkNew<vtkDoubleArray> sides;
  sides->SetNumberOfComponents(3);
  for (const Triangle& t : model.triangles)
  {
    const Vec3 n =
      cross(model.points[t[1]] - model.points[t[0]], model.points[t[2]] - model.points[t[0]]);
    sides->InsertNextTuple3(n.x, n.y, n.z);
  }
  data->GetCellData()->SetNormals(sides);
  const TemporaryFolder folder;
  vtkNew<vtkScanVtpWriter> writer;
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->SetInputData(data);
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetNote(), "the surface is mended: 4 triangles turned over");
  const Model back = read(folder.file("a.vtp")).model;
  for (std::size_t i = 0; i < 5; ++i)
  {
    EXPECT_EQ(back.normals[i], model.normals[i] * (i < 4 ? -1.0 : 1.0));
  }
  vtkNew<vtkXMLPolyDataReader> theirs;
  theirs->SetFileName(folder.file("a.vtp").c_str());
  theirs->Update();
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(theirs->GetOutput()->GetCellData()->GetNormals()->GetComponent(i, 0),
      -sides->GetComponent(i, 0));
  }
}

TEST(Vtp, IsTheSameFileEveryTime)
{
  const TemporaryFolder folder;
  write(folder.file("a.vtp"), dataOf(colouredStrip()));
  write(folder.file("b.vtp"), dataOf(colouredStrip()));
  const std::string bytes = contentOf(folder.file("a.vtp"));
  EXPECT_EQ(bytes, contentOf(folder.file("b.vtp")));
  EXPECT_TRUE(looksLikeVtp(bytes));
  EXPECT_NE(bytes.find("vtkZLibDataCompressor"), std::string::npos);
}

TEST(Vtp, AppearsOnlyWhenItIsComplete)
{
  const TemporaryFolder folder;
  CancelToken token;
  token.cancel();
  vtkNew<vtkScanVtpWriter> writer;
  writer->SetCancelToken(token);
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->SetInputData(dataOf(colouredStrip()));
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetOutcome().state, State::cancelled);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Vtp, IsNotWrittenOfNothing)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkScanVtpWriter> writer;
  vtkNew<vtkCallbackCommand> silent;
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  writer->AddObserver(vtkCommand::ErrorEvent, silent);
  writer->SetFileName(folder.file("a.vtp").c_str());
  writer->SetInputData(empty);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetOutcome().code, ErrorCode::badInput);
  EXPECT_NE(writer->GetOutcome().message.find("no points to write"), std::string::npos);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(VtpReader, ReadsEveryEncoding)
{
  using Writer = vtkXMLWriterBase;
  const Model model = colouredStrip();
  const vtkSmartPointer<vtkPolyData> data = dataOf(model);
  for (const int compressor : { Writer::NONE, Writer::ZLIB, Writer::LZ4, Writer::LZMA })
  {
    for (const int mode : { Writer::Ascii, Writer::Binary, Writer::Appended })
    {
      const Reading reading = readBytes(xmlBytes(data, mode, compressor));
      EXPECT_EQ(reading.outcome.state, State::ok) << reading.outcome.message;
      EXPECT_EQ(reading.model.triangles, model.triangles) << compressor << " " << mode;
      EXPECT_EQ(reading.model.colors, model.colors);
    }
  }
}

TEST(VtpReader, ReadsPolygonsAndStrips)
{
  const Model model = readBytes(kAsciiXml).model;
  const std::vector<Triangle> expected = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 2 }, { 2, 1, 3 } };
  EXPECT_EQ(model.triangles, expected);
  EXPECT_EQ(model.points[2], (Vec3{ 1.0, 1.0, 0.1 }));
}

TEST(LegacyVtkReader, ReadsWhatVtkWrites)
{
  Model model = colouredStrip();
  for (Vec3& normal : model.normals)
  {
    normal = { 0.0, 0.0, 1.0 };
  }
  const vtkSmartPointer<vtkPolyData> data = dataOf(model);
  for (const int version :
    { vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2, vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1 })
  {
    const Reading binary = readBytes<vtkScanLegacyVtkReader>(legacyBytes(data, true, version));
    EXPECT_EQ(binary.outcome.state, State::ok) << binary.outcome.message;
    expectSame(binary.model, model);
    const Reading text = readBytes<vtkScanLegacyVtkReader>(legacyBytes(data, false, version));
    EXPECT_EQ(text.outcome.state, State::ok) << text.outcome.message;
    EXPECT_EQ(text.model.triangles, model.triangles);
    EXPECT_EQ(text.model.colors, model.colors);
    EXPECT_EQ(text.model.normals, model.normals);
  }
}

TEST(VtpReader, RecognisesItsFormat)
{
  EXPECT_TRUE(looksLikeVtp(kAsciiXml));
  EXPECT_TRUE(looksLikeVtp("<VTKFile version='1' type='PolyData'>"));
  for (const std::string text : { "", "<", "<!--", "<!-- <VTKFile type=\"PolyData\"",
         "<VTKFile type=\"UnstructuredGrid\">", "<svg/>", "1 2 3\n<VTKFile type=\"PolyData\">" })
  {
    EXPECT_FALSE(looksLikeVtp(text)) << text;
  }
}

TEST(VtpReader, SaysWhatIsWrong)
{
  EXPECT_EQ(
    errorOf("solid a\n"), "not XML PolyData of VTK: its first element is not VTKFile of that type");
  EXPECT_EQ(errorOf(kAsciiXml.substr(0, kAsciiXml.size() / 2)),
    "the file ends early: </VTKFile> is missing; copy or write it again");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "</Strips>", "</Stripes>")),
    "Error parsing XML in stream at line 8, column 69, byte index 495: mismatched tag");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "0 1 2 3", "0 1 2 4")),
    "cell 0 names point 4 of 4; repair the mesh first");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "0 1 2 3", "0 1 2 -3")),
    "cell 0 names point -3 of 4; repair the mesh first");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, ">4<", ">400<")),
    "Cannot read cell connectivity from Strips in piece 0 because the \"connectivity\" array is "
    "not long enough.");
  EXPECT_NE(
    errorOf(replaced(replaced(kAsciiXml, "Strips=\"1\"", "Strips=\"2\""), ">4<", ">6 4<")), "");
  EXPECT_NE(errorOf(replaced(kAsciiXml, "0 0 0 1", "0")), ""); // too few coordinates
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "1 1 0.1", "1 1 1e99")),
    "1 of 4 points have coordinates that are not finite or exceed 1e50; remove them");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "Points=\"4\"", "Points=\"40000000000\"")),
    "byte 126: 'NumberOfPoints=\"40000000000\"' is more than the file can hold; write the file "
    "again");
}

TEST(VtpReader, StopsWhenCancelled)
{
  const TemporaryFolder folder;
  write(folder.file("a.vtp"), dataOf(colouredStrip()));
  CancelToken token;
  token.cancel();
  EXPECT_EQ(read(folder.file("a.vtp"), token).outcome.state, State::cancelled);
}

TEST(VtpReader, EndsInErrorOrModelWhenCutOrChanged)
{
  const vtkSmartPointer<vtkPolyData> data = dataOf(colouredStrip());
  const std::string files[] = { kAsciiXml,
    xmlBytes(data, vtkXMLWriterBase::Appended, vtkXMLWriterBase::ZLIB),
    xmlBytes(data, vtkXMLWriterBase::Binary, vtkXMLWriterBase::NONE) };
  for (const std::string& bytes : files)
  {
    ASSERT_EQ(errorOf(bytes), "");
    for (std::size_t size = 1; size + 12 < bytes.size(); size += 64)
    {
      EXPECT_NE(errorOf(bytes.substr(0, size)), "") << size;
    }
    for (std::size_t at = 0; at < bytes.size(); at += 97)
    {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x01 : 0x95));
      errorOf(changed);
    }
  }
}
