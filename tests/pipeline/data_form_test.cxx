// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/data_form.h"

#include "pipeline/project_file.h"
#include "tests/pipeline/document_fixtures.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

using namespace scan;

namespace
{

/// Stores a model in a project and reads it back.
class StoredModel : public ::testing::Test
{
protected:
  void expectSame(vtkPolyData& model)
  {
    const std::string path = testFolder() + "/a.wrp";
    Execution execution;
    ProjectFile::create(path);
    {
      ProjectFile project(path);
      Step step;
      step.verb = "open";
      project.addStep(step, model, execution);
      EXPECT_EQ(step.id, 1);
      EXPECT_EQ(step.resultHash.size(), 32U);
    }
    LoadedComplexes complexes;
    const auto read = ProjectFile(path).readResult(1, complexes, execution);
    EXPECT_EQ(DataDump(*read).text(), DataDump(model).text());
  }

  void expectSame(const std::vector<std::string>& files, const std::string& verb,
    const ParameterTexts& parameters)
  {
    Document document;
    expectOk(import(document, files));
    expectOk(apply(document, verb, parameters));
    this->expectSame(*document.result(document.current(), {}));
  }
};

template <class Array>
void addArray(vtkFieldData& data, const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < components * tuples; ++i)
  {
    array->SetValue(i, static_cast<typename Array::ValueType>(i * 7 % 251));
  }
  data.AddArray(array);
}

} // namespace

TEST_F(StoredModel, KeepsEveryArrayOfEveryType)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(70, 90);
  plane->Update();
  vtkPolyData& model = *plane->GetOutput();
  const vtkIdType points = model.GetNumberOfPoints();
  addArray<vtkUnsignedCharArray>(*model.GetPointData(), "Colors", 3, points);
  addArray<vtkDoubleArray>(*model.GetPointData(), "odd: name", 2, points);
  addArray<vtkIdTypeArray>(*model.GetPointData(), "ids", 1, points);
  addArray<vtkFloatArray>(*model.GetCellData(), "floats", 1, model.GetNumberOfCells());
  addArray<vtkUnsignedShortArray>(*model.GetFieldData(), "shorts", 5, 3);
  addArray<vtkDoubleArray>(*model.GetFieldData(), "empty", 1, 0);
  vtkNew<vtkStringArray> texts;
  texts->SetName("texts");
  for (const char* text : { "a", "", "two words", "ä" })
  {
    texts->InsertNextValue(text);
  }
  model.GetFieldData()->AddArray(texts);
  model.GetPointData()->SetActiveScalars("Colors");
  this->expectSame(model);
}

TEST_F(StoredModel, MayBeEmpty)
{
  vtkNew<vtkPolyData> model;
  this->expectSame(*model);
}

TEST_F(StoredModel, MayHaveSeveralChunks)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(400, 300); // 2.9 MB of points
  plane->Update();
  this->expectSame(*plane->GetOutput());
}

TEST_F(StoredModel, KeepsScansWithColoursAndUnits)
{
  Document document;
  expectOk(import(document, { sampleFile("multiview_scan.ply") }));
  this->expectSame(*document.result(1, {}));
}

TEST_F(StoredModel, KeepsTheClassicWrap)
{
  this->expectSame(
    { sampleFile("plate_hole.xyz"), sampleFile("helix.xyz") }, "wrap", { { "mode", "classic" } });
}

TEST_F(StoredModel, KeepsTheWrapThatWasOpened)
{
  this->expectSame(
    { sampleFile("helix.xyz") }, "wrap", { { "mode", "classic" }, { "size", "0.3" } });
}

TEST_F(StoredModel, KeepsTheClosedWrap)
{
  this->expectSame({ sampleFile("torus.xyz") }, "wrap", {});
}

TEST_F(StoredModel, KeepsTheOpenWrap)
{
  this->expectSame({ sampleFile("monkey_saddle.xyz") }, "wrap", {});
}

TEST_F(StoredModel, KeepsTheWrapThatIsNotSplit)
{
  this->expectSame({ sampleFile("monkey_saddle.xyz") }, "wrap",
    { { "mode", "classic" }, { "manifold", "false" } });
}

TEST_F(StoredModel, KeepsTheFront)
{
  this->expectSame({ sampleFile("torus.xyz") }, "wrap", { { "mode", "front" } });
}

TEST_F(StoredModel, KeepsEdits)
{
  Document document;
  openPlate(document);
  expectOk(apply(document, "repair-angles"));
  this->expectSame(*document.result(document.current(), {}));
}
