// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files against lib3mf (package lib3mf-dev), the reference implementation of the format.
#include "writers/threemf.h"

#include "readers/threemf.h"
#include "tests/writers/assimp.h"

#include <gtest/gtest.h>

#ifdef SCAN_HAS_LIB3MF
#include <Model/COM/NMR_DLLInterfaces.h>

namespace
{

using scan::test::torus;

/// A file in lib3mf.
class Lib3mfModel
{
public:
  explicit Lib3mfModel(const std::string& path)
  {
    NMR::PLib3MFModelReader* reader = nullptr;
    NMR::lib3mf_createmodel(&this->Model);
    NMR::lib3mf_model_queryreader(this->Model, "3mf", &reader);
    this->IsRead = NMR::lib3mf_reader_readfromfileutf8(reader, path.c_str()) == 0;
    NMR::lib3mf_reader_getwarningcount(reader, &this->WarningCount);
    NMR::lib3mf_release(reader);
    NMR::PLib3MFModelResourceIterator* iterator = nullptr;
    NMR::lib3mf_model_getmeshobjects(this->Model, &iterator);
    BOOL isThere = 0;
    NMR::lib3mf_resourceiterator_movenext(iterator, &isThere);
    if (isThere != 0)
    {
      NMR::PLib3MFModelResource* mesh = nullptr;
      NMR::lib3mf_resourceiterator_getcurrent(iterator, &mesh);
      NMR::lib3mf_meshobject_getvertexcount(mesh, &this->VertexCount);
      NMR::lib3mf_meshobject_gettrianglecount(mesh, &this->TriangleCount);
      NMR::lib3mf_meshobject_ismanifoldandoriented(mesh, &this->IsClosed);
      NMR::lib3mf_release(mesh);
    }
    NMR::lib3mf_release(iterator);
  }
  ~Lib3mfModel() { NMR::lib3mf_release(this->Model); }
  Lib3mfModel(const Lib3mfModel&) = delete;
  Lib3mfModel& operator=(const Lib3mfModel&) = delete;

  bool write(const std::string& path) const
  {
    NMR::PLib3MFModelWriter* writer = nullptr;
    NMR::lib3mf_model_querywriter(this->Model, "3mf", &writer);
    const bool isWritten = NMR::lib3mf_writer_writetofileutf8(writer, path.c_str()) == 0;
    NMR::lib3mf_release(writer);
    return isWritten;
  }

  NMR::PLib3MFModel* Model = nullptr;
  bool IsRead = false;
  DWORD WarningCount = 0;
  DWORD VertexCount = 0;
  DWORD TriangleCount = 0;
  BOOL IsClosed = 0;
};

void expectSame(const scan::Model& model, bool isClosed)
{
  const scan::test::TemporaryFolder folder;
  const std::string path = folder.file("ours.3mf");
  scan::test::setContent(path, scan::test::bytesOfModel(scan::writeThreemf, model));
  const Lib3mfModel theirs(path);
  EXPECT_TRUE(theirs.IsRead);
  EXPECT_EQ(theirs.WarningCount, 0U);
  EXPECT_EQ(theirs.VertexCount, model.points.size());
  EXPECT_EQ(theirs.TriangleCount, model.triangles.size());
  EXPECT_EQ(theirs.IsClosed != 0, isClosed);
  ASSERT_TRUE(theirs.write(folder.file("theirs.3mf"))); // with the numbers of zip64
  const scan::Model back =
    scan::test::parse(scan::parseThreemf, scan::test::contentOf(folder.file("theirs.3mf")));
  EXPECT_EQ(back.triangles, model.triangles);
  EXPECT_EQ(back.millimetresPerUnit, model.millimetresPerUnit);
  EXPECT_NEAR(scan::test::volumeOf(back), scan::test::volumeOf(model), 0.1);
}

} // namespace

TEST(Threemf, AgreesWithLib3mf)
{
  scan::Model model = torus(60, {});
  model.millimetresPerUnit = 25.4;
  expectSame(model, true);
  model.triangles.pop_back();
  expectSame(model, false);
}

#else

TEST(Threemf, AgreesWithLib3mf)
{
  GTEST_SKIP() << "lib3mf is missing";
}

#endif
