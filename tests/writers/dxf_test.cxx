// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/dxf.h"

#include "tests/writers/models.h"
#include "tests/writers/other_programs.h"

#include <functional>

namespace scan
{

static void PrintTo(DxfFaces faces, std::ostream* stream)
{
  *stream << (faces == DxfFaces::polyface ? "polyface" : "face3d");
}

} // namespace scan

namespace
{

using scan::DxfFaces;
using scan::Model;
using scan::TriMesh;
using scan::Vec3;
using scan::test::EzdxfResult;
using scan::test::modelBytes;
using scan::test::readWithEzdxf;

auto dxf(DxfFaces faces)
{
  return [faces](const Model& model, scan::OutputFile& file, scan::Execution& execution)
  { scan::writeDxf(model, { .faces = faces }, file, execution); };
}

class DxfFile : public testing::TestWithParam<DxfFaces>
{
protected:
  std::string write(const Model& model)
  {
    scan::test::writeModel(this->Folder.file("out.dxf"), model, dxf(this->GetParam()));
    return this->Folder.file("out.dxf");
  }

private:
  scan::test::TemporaryFolder Folder;
};

const std::string kHeader = "999\nDXF by Scanwrap\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n"
                            "9\n$EXTMIN\n10\n0\n20\n-0.125\n30\n0\n"
                            "9\n$EXTMAX\n10\n2.5\n20\n0\n30\n1e-07\n"
                            "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
const std::string kEnd = "0\nENDSEC\n0\nEOF\n";

} // namespace

TEST(WrittenDxf, HasA3dFaceATriangle)
{
  EXPECT_EQ(modelBytes(scan::test::oneTriangle(), dxf(DxfFaces::face3d)),
    kHeader +
      "0\n3DFACE\n8\n0\n10\n0\n20\n0\n30\n0\n11\n2.5\n21\n0\n31\n0\n"
      "12\n0\n22\n-0.125\n32\n1e-07\n13\n0\n23\n-0.125\n33\n1e-07\n" +
      kEnd);
}

TEST(WrittenDxf, HasVerticesAndFacesOfAPolyface)
{
  EXPECT_EQ(modelBytes(scan::test::oneTriangle(), dxf(DxfFaces::polyface)),
    kHeader +
      "0\nPOLYLINE\n8\n0\n66\n1\n10\n0\n20\n0\n30\n0\n70\n64\n71\n3\n72\n1\n"
      "0\nVERTEX\n8\n0\n10\n0\n20\n0\n30\n0\n70\n192\n"
      "0\nVERTEX\n8\n0\n10\n2.5\n20\n0\n30\n0\n70\n192\n"
      "0\nVERTEX\n8\n0\n10\n0\n20\n-0.125\n30\n1e-07\n70\n192\n"
      "0\nVERTEX\n8\n0\n10\n0\n20\n0\n30\n0\n70\n128\n71\n1\n72\n2\n73\n3\n"
      "0\nSEQEND\n8\n0\n" +
      kEnd);
}

TEST_P(DxfFile, HasAPointForAPointOfAScan)
{
  EXPECT_EQ(modelBytes(scan::test::threePoints(), dxf(this->GetParam())),
    kHeader +
      "0\nPOINT\n8\n0\n10\n0\n20\n0\n30\n0\n0\nPOINT\n8\n0\n10\n2.5\n20\n0\n30\n0\n"
      "0\nPOINT\n8\n0\n10\n0\n20\n-0.125\n30\n1e-07\n" +
      kEnd);
}

TEST_P(DxfFile, RefusesAnEmptyModel)
{
  EXPECT_EQ(scan::test::writeError({}, dxf(this->GetParam())), scan::ErrorCode::badInput);
}

TEST_P(DxfFile, StopsWhenCancelled)
{
  scan::test::expectCancels(scan::test::oneTriangle(), dxf(this->GetParam()));
  scan::test::expectCancels(scan::test::threePoints(), dxf(this->GetParam()));
}

TEST_P(DxfFile, IsReadByAssimp)
{
  if (!scan::test::hasAssimp())
  {
    GTEST_SKIP() << "assimp is not installed";
  }
  for (const Model& model : { scan::test::grid(356, 250, true), scan::test::grid(60, 40, false),
         scan::test::nonManifold() })
  {
    TriMesh read = scan::test::readWithAssimp(this->write(model));
    scan::test::turnBackFromAssimp(read);
    scan::test::expectSame(read, model);
  }
}

TEST_P(DxfFile, PassesTheAuditOfEzdxf)
{
  if (!scan::test::hasEzdxf())
  {
    GTEST_SKIP() << "python3-ezdxf is not installed";
  }
  for (Model model : { scan::test::grid(130, 127, true), scan::test::grid(60, 40, false),
         scan::test::nonManifold() })
  {
    for (Vec3& p : model.points)
    {
      p = p * (1.0 / 3.0) + Vec3{ 665187.522077, -5648349.895035, 1e-20 };
    }
    const EzdxfResult read = readWithEzdxf(this->write(model));
    EXPECT_EQ(read.complaints, 0);
    ASSERT_EQ(read.mesh.points.size(), 3 * model.triangles.size());
    for (std::size_t i = 0; i < read.mesh.points.size(); ++i)
    {
      ASSERT_EQ(read.mesh.points[i], model.points[model.triangles[i / 3][i % 3]]);
    }
    const bool isPolyface = this->GetParam() == DxfFaces::polyface;
    const int most = 32767;
    const int count = static_cast<int>(model.triangles.size());
    EXPECT_EQ(read.meshes, isPolyface ? (count + most - 1) / most : 0);
    model.triangles.clear();
    EXPECT_EQ(readWithEzdxf(this->write(model)).mesh.points, model.points);
  }
}

TEST_P(DxfFile, HasCurvesForEzdxf)
{
  if (!scan::test::hasEzdxf())
  {
    GTEST_SKIP() << "python3-ezdxf is not installed";
  }
  Model model = scan::test::withCurves(scan::test::grid(6, 4, true));
  for (int i = 0; i < 2; ++i)
  {
    const EzdxfResult read = readWithEzdxf(this->write(model));
    EXPECT_EQ(read.complaints, 0);
    EXPECT_EQ(read.mesh.points.size(), 3 * model.triangles.size());
    EXPECT_EQ(read.curves, scan::test::placesOf(model));
    model.triangles.clear(); // curves alone
  }
}

INSTANTIATE_TEST_SUITE_P(Written, DxfFile, testing::Values(DxfFaces::face3d, DxfFaces::polyface));

TEST(WrittenDxf, SplitsPolyfacesWithManyPoints)
{
  const std::string text = modelBytes(scan::test::scattered(30000), dxf(DxfFaces::polyface));
  EXPECT_NE(text.find("\n71\n32766\n72\n10922\n"), std::string::npos);
  EXPECT_NE(text.find("\n71\n24468\n72\n8156\n"), std::string::npos);
}
