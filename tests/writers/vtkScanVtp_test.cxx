// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's own files: what is written, read by VTK and by ours; what is read, whoever wrote it.
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "readers/polydata.h"
#include "readers/vtkScanVtpReader.h"
#include "tests/readers/temporary_folder.h"
#include "tests/writers/written.h"
#include "writers/vtkScanVtpWriter.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

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

Reading read(const std::string& path, const CancelToken& token = {})
{
  vtkNew<vtkScanVtpReader> reader;
  vtkNew<vtkCallbackCommand> silent; // errors would be printed
  silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
  reader->SetFileName(path.c_str());
  reader->SetCancelToken(token);
  reader->Update();
  return { bridge::modelOf(*reader->GetOutput()), reader->GetOutcome() };
}

Reading readBytes(const std::string& bytes)
{
  const TemporaryFolder folder;
  setContent(folder.file("file"), bytes);
  return read(folder.file("file"));
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

const std::string kAsciiLegacy = "# vtk DataFile Version 3.0\nA quad\nASCII\nDATASET POLYDATA\n"
                                 "POINTS 4 double\n0 0 0 1 0 0 1 1 0.1 0 1 0\n"
                                 "POLYGONS 1 5\n4 0 1 2 3\n";

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
  ASSERT_EQ(write(folder.file("a.vtp"), dataOf(scan)), 1);
  expectSame(read(folder.file("a.vtp")).model, scan);
}

TEST(Vtp, IsReadByVtkWithAllItsArrays)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> data = dataOf(colouredStrip());
  vtkNew<vtkIdTypeArray> blocks;
  blocks->SetName(arrays::kBlock);
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
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

TEST(Vtp, OfAnEmptySurfaceIsValid)
{
  const TemporaryFolder folder;
  vtkNew<vtkPolyData> empty;
  ASSERT_EQ(write(folder.file("a.vtp"), empty), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.file("a.vtp").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(errorOf(contentOf(folder.file("a.vtp"))),
    "no points found; give a file of PolyData with points");
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

TEST(VtpReader, ReadsLegacyFilesOfBothVersions)
{
  const Model model = colouredStrip();
  const vtkSmartPointer<vtkPolyData> data = dataOf(model);
  for (const int version :
    { vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2, vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1 })
  {
    expectSame(readBytes(legacyBytes(data, true, version)).model, model);
    EXPECT_EQ(readBytes(legacyBytes(data, false, version)).model.triangles, model.triangles);
  }
  const std::vector<Triangle> quad = { { 0, 1, 2 }, { 0, 2, 3 } };
  EXPECT_EQ(readBytes(kAsciiLegacy).model.triangles, quad);
}

TEST(VtpReader, RecognisesItsFormats)
{
  EXPECT_TRUE(looksLikeVtp(kAsciiXml));
  EXPECT_TRUE(looksLikeVtp("<VTKFile version='1' type='PolyData'>"));
  EXPECT_TRUE(looksLikeLegacyVtk(kAsciiLegacy));
  EXPECT_FALSE(looksLikeVtp(kAsciiLegacy));
  EXPECT_FALSE(looksLikeLegacyVtk(kAsciiXml));
  for (const std::string text : { "", "<", "<!--", "<!-- <VTKFile type=\"PolyData\"",
         "<VTKFile type=\"UnstructuredGrid\">", "<svg/>", "1 2 3\n<VTKFile type=\"PolyData\">" })
  {
    EXPECT_FALSE(looksLikeVtp(text)) << text;
  }
}

TEST(VtpReader, SaysWhatIsWrong)
{
  EXPECT_EQ(errorOf("solid a\n"),
    "neither XML PolyData of VTK nor a legacy VTK file; write the file again");
  EXPECT_NE(errorOf(kAsciiXml.substr(0, kAsciiXml.size() / 2)), "");
  EXPECT_NE(errorOf(kAsciiLegacy.substr(0, 90)), "");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "0 1 2 3", "0 1 2 4")),
    "cell 0 names point 4 of 4; repair the mesh first");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, "0 1 2 3", "0 1 2 -3")),
    "cell 0 names point -3 of 4; repair the mesh first");
  EXPECT_EQ(errorOf(replaced(kAsciiXml, ">4<", ">400<")),
    "the offsets of the faces are malformed; write the file again");
  EXPECT_EQ(errorOf(replaced(kAsciiLegacy, "4 0 1 2 3", "4 0 1 2 9")),
    "cell 0 names point 9 of 4; repair the mesh first");
  EXPECT_EQ(errorOf(replaced(kAsciiLegacy, "0.1", "nan")),
    "1 of 4 points have coordinates that are not finite or exceed 1e50; remove them");
  EXPECT_NE(errorOf(replaced(kAsciiLegacy, "POLYDATA", "UNSTRUCTURED_GRID")), "");
  EXPECT_NE(errorOf(replaced(kAsciiLegacy, "POINTS 4", "POINTS 40000000")), "");
  EXPECT_NE(errorOf(replaced(kAsciiXml, "Points=\"4\"", "Points=\"40000000000\"")), "");
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
  const std::string files[] = { kAsciiXml, kAsciiLegacy,
    xmlBytes(data, vtkXMLWriterBase::Appended, vtkXMLWriterBase::ZLIB),
    xmlBytes(data, vtkXMLWriterBase::Binary, vtkXMLWriterBase::NONE),
    legacyBytes(data, true, vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2),
    legacyBytes(data, true, vtkDataWriter::VTK_LEGACY_READER_VERSION_5_1) };
  for (const std::string& bytes : files)
  {
    ASSERT_EQ(errorOf(bytes), "");
    for (std::size_t size = 0; size + 64 < bytes.size(); size += 64)
    {
      errorOf(bytes.substr(0, size));
    }
    for (std::size_t at = 0; at < bytes.size(); at += 97)
    {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ (at % 2 == 0 ? 0x01 : 0x95));
      errorOf(changed);
    }
  }
}
