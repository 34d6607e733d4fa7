// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"
#include "writers/inventor.h"
#include "writers/vrml97.h"

#include <functional>

namespace
{

using scan::Model;
using scan::Vec3;
using scan::test::modelBytes;
using SceneFormat = std::function<void(const Model&, scan::OutputFile&, scan::Execution&)>;

SceneFormat inventor(scan::InventorVersion version)
{
  return [version](const Model& model, scan::OutputFile& file, scan::Execution& execution)
  { scan::writeInventor(model, { .version = version }, file, execution); };
}

const SceneFormat kInventor = inventor(scan::InventorVersion::inventor);
const SceneFormat kVrml1 = inventor(scan::InventorVersion::vrml1);
const SceneFormat kVrml97 = scan::writeVrml97;

Model reread(Model (*read)(const std::string&), const Model& model, const SceneFormat& format)
{
  const scan::test::TemporaryFolder folder;
  scan::test::writeModel(folder.file("out.wrl"), model, format);
  return read(folder.file("out.wrl"));
}

struct NamedFormat
{
  const char* name;
  SceneFormat format;

  friend void PrintTo(const NamedFormat& format, std::ostream* stream) { *stream << format.name; }
};

class SceneFile : public testing::TestWithParam<NamedFormat>
{
};

} // namespace

TEST(WrittenInventor, HasNodesForASurface)
{
  const std::string nodes =
    "Separator {\n"
    "ShapeHints { vertexOrdering COUNTERCLOCKWISE faceType CONVEX creaseAngle 0.5 }\n"
    "Coordinate3 { point [\n0 0 0,\n2.5 0 0,\n0 -0.125 1e-07,\n] }\n"
    "IndexedFaceSet { coordIndex [\n0, 1, 2, -1,\n] }\n}\n";
  const Model model = scan::test::oneTriangle();
  EXPECT_EQ(modelBytes(model, kInventor), "#Inventor V2.1 ascii\n" + nodes);
  EXPECT_EQ(modelBytes(model, kVrml1), "#VRML V1.0 ascii\n" + nodes);
}

TEST(WrittenInventor, HasNodesForColoredPoints)
{
  EXPECT_EQ(modelBytes(scan::test::colored(scan::test::threePoints()), kInventor),
    "#Inventor V2.1 ascii\nSeparator {\n"
    "Material { diffuseColor [\n"
    " 0.0000 0.0000 1.0000,\n 0.0040 0.0000 0.9961,\n 0.0079 0.0000 0.9922,\n] }\n"
    "MaterialBinding { value PER_VERTEX }\n"
    "Coordinate3 { point [\n0 0 0,\n2.5 0 0,\n0 -0.125 1e-07,\n] }\nPointSet { }\n}\n");
}

TEST(WrittenVrml97, HasOneShape)
{
  EXPECT_EQ(modelBytes(scan::test::colored(scan::test::oneTriangle()), kVrml97),
    "#VRML V2.0 utf8\nShape {\nappearance Appearance { material Material { } }\n"
    "geometry IndexedFaceSet {\nsolid FALSE\ncreaseAngle 0.5\n"
    "color Color { color [\n"
    " 0.0000 0.0000 1.0000,\n 0.0040 0.0000 0.9961,\n 0.0079 0.0000 0.9922,\n] }\n"
    "coord Coordinate { point [\n0 0 0,\n2.5 0 0,\n0 -0.125 1e-07,\n] }\n"
    "coordIndex [\n0, 1, 2, -1,\n]\n}\n}\n");
  EXPECT_EQ(modelBytes(scan::test::threePoints(), kVrml97),
    "#VRML V2.0 utf8\nShape {\ngeometry PointSet {\n"
    "coord Coordinate { point [\n0 0 0,\n2.5 0 0,\n0 -0.125 1e-07,\n] }\n}\n}\n");
}

TEST_P(SceneFile, RefusesWhatItCannotHold)
{
  EXPECT_EQ(scan::test::writeError({}, this->GetParam().format), scan::ErrorCode::badInput);
  Model model = scan::test::oneTriangle();
  model.points[2].z = -3.5e38;
  EXPECT_EQ(scan::test::writeError(model, this->GetParam().format), scan::ErrorCode::limit);
  model.points[2].z = -3.4e38;
  EXPECT_FALSE(modelBytes(model, this->GetParam().format).empty());
}

TEST_P(SceneFile, StopsWhenCancelled)
{
  scan::test::expectCancels(
    scan::test::colored(scan::test::oneTriangle()), this->GetParam().format);
}

TEST_P(SceneFile, IsDrawnByCoin)
{
  if (!scan::test::hasCoin())
  {
    GTEST_SKIP() << "Coin is not installed";
  }
  for (const Model& model : { scan::test::grid(60, 40, true), scan::test::grid(60, 40, false),
         scan::test::nonManifold(), scan::test::colored(scan::test::grid(300, 200, true)) })
  {
    scan::test::expectSame(reread(scan::test::readWithCoin, model, this->GetParam().format), model);
  }
}

TEST_P(SceneFile, IsDrawnByCoinInItsColors)
{
  if (!scan::test::hasCoin())
  {
    GTEST_SKIP() << "Coin is not installed";
  }
  const Model model = scan::test::colored(scan::test::grid(30, 20, true));
  const Model surface = reread(scan::test::readWithCoin, model, this->GetParam().format);
  ASSERT_EQ(surface.points.size(), 3 * model.triangles.size());
  for (std::size_t i = 0; i < surface.points.size(); ++i)
  {
    const scan::Index corner = model.triangles[i / 3][i % 3];
    EXPECT_EQ(surface.points[i], model.points[corner]);
    EXPECT_EQ(surface.colors[i], model.colors[corner]);
  }
  Model points = model;
  points.triangles.clear();
  const Model scan = reread(scan::test::readWithCoin, points, this->GetParam().format);
  EXPECT_TRUE(scan.points == points.points);
  EXPECT_TRUE(scan.colors == points.colors);
}

TEST_P(SceneFile, IsDrawnByCoinWithItsCurves)
{
  if (!scan::test::hasCoin())
  {
    GTEST_SKIP() << "Coin is not installed";
  }
  const Model plain = scan::test::withCurves(scan::test::grid(6, 4, true));
  Model alone = scan::test::colored(plain);
  alone.triangles.clear();
  for (const Model& model : { plain, scan::test::colored(plain), alone })
  {
    const Model read = reread(scan::test::readWithCoin, model, this->GetParam().format);
    EXPECT_EQ(read.triangles.size(), model.triangles.size());
    std::vector<std::vector<Vec3>> segments;
    for (const std::vector<Vec3>& curve : scan::test::placesOf(model))
    {
      for (std::size_t i = 1; i < curve.size(); ++i)
      {
        segments.push_back({ curve[i - 1], curve[i] });
      }
    }
    EXPECT_EQ(scan::test::placesOf(read), segments);
    for (std::size_t i = 0; i < read.curves.corners.size() && !model.colors.empty(); ++i)
    {
      const scan::Index end = read.curves.corners[i];
      const auto at = std::ranges::find(model.points, read.points[end]) - model.points.begin();
      EXPECT_EQ(read.colors[end], model.colors[static_cast<std::size_t>(at)]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Written, SceneFile,
  testing::Values(NamedFormat{ "Inventor", kInventor }, NamedFormat{ "Vrml1", kVrml1 },
    NamedFormat{ "Vrml97", kVrml97 }));

TEST(WrittenInventor, IsReadBySgiInventor)
{
  if (!scan::test::hasSgiInventor())
  {
    GTEST_SKIP() << "ivcat of Open Inventor is not installed";
  }
  for (const SceneFormat& format : { kInventor, kVrml1 })
  {
    for (const Model& model :
      { scan::test::grid(40, 30, true), scan::test::colored(scan::test::grid(60, 40, false)) })
    {
      const Model read = reread(scan::test::readWithSgiInventor, model, format);
      EXPECT_EQ(read.triangles, model.triangles);
      ASSERT_EQ(read.points.size(), model.points.size());
      for (std::size_t i = 0; i < read.points.size(); ++i)
      {
        const Vec3 off = read.points[i] - model.points[i];
        EXPECT_LE(std::sqrt(dot(off, off)), 1e-4); // ivcat prints six digits
      }
    }
  }
}
