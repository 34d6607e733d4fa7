// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/autodesk_3ds.h"

#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

namespace
{

using scan::Model;
using scan::TriMesh;
using scan::Vec3;
using scan::test::Lib3dsPart;
using scan::test::readWithLib3ds;

class Written3ds : public testing::Test
{
protected:
  std::string write(const Model& model)
  {
    scan::test::writeModel(this->Folder.file("out.3ds"), model, scan::writeAutodesk3ds);
    return this->Folder.file("out.3ds");
  }

  void expectLib3dsReads(Model model)
  {
    const TriMesh read = readWithLib3ds(this->write(model)).mesh;
    for (Vec3& p : model.points) // as the dump prints them
    {
      for (double* const value : { &p.x, &p.y, &p.z })
      {
        *value = std::stod(std::to_string(*value));
      }
    }
    scan::test::expectSame(read, model);
  }

  void expectAssimpReads(const Model& model)
  {
    TriMesh read = scan::test::readWithAssimp(this->write(model));
    scan::test::turnBackFromAssimp(read);
    scan::test::expectSame(read, model);
  }

private:
  scan::test::TemporaryFolder Folder;
};

std::string bytes(std::initializer_list<int> values)
{
  std::string text;
  for (const int value : values)
  {
    text.push_back(static_cast<char>(value));
  }
  return text;
}

} // namespace

TEST_F(Written3ds, HasNestedChunks)
{
  Model model;
  model.points = { { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, -2 } };
  model.triangles = { { 1, 2, 3 } };
  const std::string zeros(4, '\0');
  const std::string one = bytes({ 0, 0, 0x80, 0x3f });
  const std::string axes =
    one + zeros + zeros + zeros + one + zeros + zeros + zeros + one + zeros + zeros + zeros;
  EXPECT_EQ(scan::test::modelBytes(model, scan::writeAutodesk3ds),
    bytes({ 0x4d, 0x4d, 176, 0, 0, 0 }) + bytes({ 2, 0, 10, 0, 0, 0, 3, 0, 0, 0 }) +
      bytes({ 0x3d, 0x3d, 160, 0, 0, 0 }) + bytes({ 0x3e, 0x3d, 10, 0, 0, 0, 3, 0, 0, 0 }) +
      bytes({ 0, 1, 10, 0, 0, 0 }) + one + bytes({ 0, 0x40, 134, 0, 0, 0 }) +
      std::string("part001\0", 8) + bytes({ 0, 0x41, 120, 0, 0, 0 }) +
      bytes({ 0x10, 0x41, 44, 0, 0, 0, 3, 0 }) + zeros + zeros + zeros + one + zeros + zeros +
      zeros + one + bytes({ 0, 0, 0, 0xc0 }) + bytes({ 0x60, 0x41, 54, 0, 0, 0 }) + axes +
      bytes({ 0x20, 0x41, 16, 0, 0, 0, 1, 0 }) + bytes({ 0, 0, 1, 0, 2, 0, 7, 0 }));
}

TEST_F(Written3ds, RefusesWhatItCannotHold)
{
  using scan::test::writeError;
  EXPECT_EQ(writeError({}, scan::writeAutodesk3ds), scan::ErrorCode::badInput);
  EXPECT_EQ(
    writeError(scan::test::threePoints(), scan::writeAutodesk3ds), scan::ErrorCode::badInput);
  Model model = scan::test::oneTriangle();
  model.points[1].y = 1e39;
  EXPECT_EQ(writeError(model, scan::writeAutodesk3ds), scan::ErrorCode::limit);
}

TEST_F(Written3ds, StopsWhenCancelled)
{
  scan::test::expectCancels(scan::test::oneTriangle(), scan::writeAutodesk3ds);
}

TEST_F(Written3ds, IsReadByAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is not installed";
  }
  this->expectAssimpReads(scan::test::grid(356, 250, true));
  this->expectAssimpReads(scan::test::grid(60, 40, false));
  this->expectAssimpReads(scan::test::nonManifold());
  this->expectAssimpReads(scan::test::scattered(30000));
}

TEST_F(Written3ds, IsReadByLib3ds)
{
  if (!scan::test::isInstalled("command -v 3dsdump"))
  {
    GTEST_SKIP() << "3dsdump of lib3ds is not installed";
  }
  this->expectLib3dsReads(scan::test::grid(356, 250, true));
  this->expectLib3dsReads(scan::test::grid(60, 40, false));
  this->expectLib3dsReads(scan::test::nonManifold());
}

TEST_F(Written3ds, SplitsAtTheLimitsOfAnObject)
{
  if (!scan::test::isInstalled("command -v 3dsdump"))
  {
    GTEST_SKIP() << "3dsdump of lib3ds is not installed";
  }
  const auto manyFaces = readWithLib3ds(this->write(scan::test::grid(356, 250, true))).parts;
  ASSERT_EQ(manyFaces.size(), 3U);
  EXPECT_EQ(manyFaces[0].name, "part001");
  EXPECT_EQ(manyFaces[0].faces, 65535U);
  EXPECT_EQ(manyFaces[2].name, "part003");
  EXPECT_EQ(manyFaces[2].faces, 178000U - 2 * 65535U);
  const auto manyPoints = readWithLib3ds(this->write(scan::test::scattered(30000))).parts;
  ASSERT_EQ(manyPoints.size(), 2U);
  EXPECT_EQ(manyPoints[0].points, 65535U);
  EXPECT_EQ(manyPoints[0].faces, 21845U);
  EXPECT_EQ(manyPoints[1].points, 90000U - 65535U);
}
