// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/input_models.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "tests/readers/temporary_folder.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

using namespace scan;

namespace
{

InputModel inputOf(const std::string& name, const Model& model)
{
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  bridge::setModel(*data, model);
  return { data, name, "" };
}

Model modelOf(const InputModel& input)
{
  return bridge::modelOf(*input.data);
}

/// One triangle that faces +z, and a curve along two of its sides.
Model triangle(double millimetresPerUnit = 0.0)
{
  Model model;
  model.points = { { 1, 0, 0 }, { 2, 0, 0 }, { 1, 3, 0 } };
  model.triangles = { { 0, 1, 2 } };
  model.curves = { { 0, 1, 2 }, { 3 } };
  model.millimetresPerUnit = millimetresPerUnit;
  return model;
}

ErrorCode codeOf(const std::vector<InputModel>& parts)
{
  try
  {
    mergeModels(parts);
  }
  catch (const Error& error)
  {
    return error.code();
  }
  return ErrorCode::internal;
}

} // namespace

TEST(InputModels, GetAUnitUnlessTheyHaveOne)
{
  const InputModel bare = inputOf("a", triangle());
  const Model inches = modelOf(withUnit(bare, 25.4));
  EXPECT_EQ(inches.millimetresPerUnit, 25.4);
  EXPECT_EQ(inches.points, triangle().points);
  EXPECT_EQ(modelOf(bare).millimetresPerUnit, 0.0); // nobody changes the data
  EXPECT_EQ(withUnit(inputOf("a", triangle(25.4)), 25.4).note, "");
  const InputModel metres = withUnit(inputOf("a", triangle(1000.0)), 25.4);
  EXPECT_EQ(metres.note, "says itself that its unit is metre");
  EXPECT_EQ(modelOf(metres).millimetresPerUnit, 1000.0);
}

TEST(InputModels, AreTurnedAndMovedWithTheirNormals)
{
  Model model = triangle();
  model.normals.assign(3, { 0, 0.6, 0.8 });
  model.colors.assign(3, { 1, 2, 3 });
  const Affine quarterTurn = { { 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, 1 }, { 10, 0, 0 } };
  const InputModel before = inputOf("a", model);
  const Model after = modelOf(placed(before, quarterTurn));
  EXPECT_EQ(after.points, (std::vector<Vec3>{ { 10, 1, 0 }, { 10, 2, 0 }, { 7, 1, 0 } }));
  EXPECT_EQ(after.normals[0], (Vec3{ -0.6, 0, 0.8 }));
  EXPECT_EQ(after.triangles, model.triangles);
  EXPECT_EQ(after.curves, model.curves);
  EXPECT_EQ(after.colors, model.colors);
  EXPECT_EQ(modelOf(before).points, model.points);
}

TEST(InputModels, AreTurnedOverByMirrors)
{
  const Affine mirror = { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, {} };
  const Model after = modelOf(placed(inputOf("a", triangle(25.4)), mirror));
  EXPECT_EQ(after.millimetresPerUnit, 25.4);
  ASSERT_EQ(after.triangles.size(), 1U);
  const auto& [a, b, c] = after.triangles[0];
  EXPECT_GT(cross(after.points[b] - after.points[a], after.points[c] - after.points[a]).z, 0.0);
}

TEST(InputModels, KeepTheirOrderNamesCellsAndDigits)
{
  Model second = triangle();
  second.points[1].x = 665187.522077123;
  const InputModel merged =
    mergeModels({ inputOf("in/first.ply", triangle()), inputOf("second.ply", second) });
  const Model model = modelOf(merged);
  ASSERT_EQ(model.points.size(), 6U);
  EXPECT_EQ(model.points[4].x, 665187.522077123);
  EXPECT_EQ(model.triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 3, 4, 5 } }));
  EXPECT_EQ(model.curves, (Polylines{ { 0, 1, 2, 3, 4, 5 }, { 3, 6 } }));
  const std::vector<bridge::ScanFile> files = bridge::scanFilesOf(*merged.data);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "first.ply");
  EXPECT_EQ(files[1].name, "second.ply");
  EXPECT_EQ(files[1].points, 3U);
}

TEST(InputModels, AreConvertedToTheUnitOfTheFirst)
{
  const InputModel merged =
    mergeModels({ inputOf("a", triangle(1.0)), inputOf("b", triangle(1000.0)) });
  const Model model = modelOf(merged);
  EXPECT_EQ(model.millimetresPerUnit, 1.0);
  EXPECT_EQ(model.points[1], (Vec3{ 2, 0, 0 }));
  EXPECT_EQ(model.points[4], (Vec3{ 2000, 0, 0 }));
  EXPECT_EQ(merged.note, "b is converted from metre to millimetre");
  EXPECT_EQ(mergeModels({ inputOf("a", triangle(1.0)), inputOf("b", triangle(1.0)) }).note, "");
}

TEST(InputModels, AreNotMergedWhenOnlySomeHaveAUnit)
{
  EXPECT_EQ(codeOf({ inputOf("a", triangle(1.0)), inputOf("b", triangle()) }), ErrorCode::badInput);
  EXPECT_EQ(codeOf({ inputOf("a", triangle()), inputOf("b", triangle(1.0)) }), ErrorCode::badInput);
}

TEST(InputModels, WithoutColoursOrNormalsAreWhiteBesideOthers)
{
  Model colored = triangle();
  colored.colors.assign(3, { 1, 2, 3 });
  Model shaded = triangle();
  shaded.normals.assign(3, { 0, 0, 1 });
  const Model model = modelOf(mergeModels({ inputOf("a", colored), inputOf("b", shaded) }));
  ASSERT_EQ(model.colors.size(), 6U);
  EXPECT_EQ(model.colors[2], (Color{ 1, 2, 3 }));
  EXPECT_EQ(model.colors[3], (Color{ 255, 255, 255 }));
  ASSERT_EQ(model.normals.size(), 6U);
  EXPECT_EQ(model.normals[2], (Vec3{}));
  EXPECT_EQ(model.normals[3], (Vec3{ 0, 0, 1 }));
}

TEST(InputModels, OfOneFileStayAsTheyAre)
{
  const InputModel only = inputOf("a", triangle());
  EXPECT_EQ(mergeModels({ only }).data, only.data);
}

TEST(InputModels, ArePlacedByALineOfTheirOwn)
{
  const test::TemporaryFolder folder;
  test::setContent(folder.file("list"), "a.ply 1 2 3 0 0 0 1\n\"b c.ply\" 4 5 6 0 0 0 1\n");
  const TransformList list(folder.file("list"));
  EXPECT_EQ(list.placeOf("in/a.ply").point({}), (Vec3{ 1, 2, 3 }));
  EXPECT_EQ(list.placeOf("b c.ply").point({}), (Vec3{ 4, 5, 6 }));
  EXPECT_THROW(list.placeOf("c.ply"), Error);
  EXPECT_THROW(TransformList(folder.file("none")), Error);
}

TEST(InputModels, AreAppendedBehindWhatWasMergedAddedAndRemoved)
{
  InputModel model = mergeModels({ inputOf("a.ply", triangle()), inputOf("b.ply", triangle()) });
  // the last point of b is gone, one was added
  bridge::setScanPointIds(*model.data, std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 6 });
  const InputModel appended = appendModel(model, inputOf("in/c.ply", triangle()));
  EXPECT_EQ(
    bridge::scanPointIdsOf(*appended.data), (std::vector<vtkIdType>{ 0, 1, 2, 3, 4, 6, 7, 8, 9 }));
  const std::vector<bridge::ScanFile> files = bridge::scanFilesOf(*appended.data);
  ASSERT_EQ(files.size(), 4U);
  EXPECT_EQ(files[1].name, "b.ply");
  EXPECT_EQ(files[1].points, 2U);
  EXPECT_EQ(files[2].name, "added points");
  EXPECT_EQ(files[2].points, 1U);
  EXPECT_EQ(files[3].name, "c.ply");
  EXPECT_EQ(files[3].points, 3U);
  EXPECT_EQ(modelOf(appended).triangles.size(), 3U);
}

TEST(InputModels, AreAppendedToAModelOfASingleFile)
{
  Model thinned = triangle(25.4);
  const InputModel model = inputOf("", thinned);
  bridge::setScanPointIds(*model.data, std::vector<vtkIdType>{ 5, 1, 3 });
  const InputModel appended = appendModel(model, inputOf("b.ply", triangle()));
  EXPECT_EQ(bridge::scanPointIdsOf(*appended.data), (std::vector<vtkIdType>{ 5, 1, 3, 6, 7, 8 }));
  const std::vector<bridge::ScanFile> files = bridge::scanFilesOf(*appended.data);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "model");
  EXPECT_EQ(files[0].points, 3U);
  EXPECT_EQ(files[1].points, 3U);
  EXPECT_EQ(modelOf(appended).millimetresPerUnit, 25.4);
  EXPECT_THROW(appendModel(inputOf("", triangle()), inputOf("b.ply", triangle(1.0))), Error);
}
