// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/format_registry.h"

#include "filters/base/error.h"
#include "pipeline/output_files.h"

#include <vtkAlgorithm.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace scan;

namespace
{

const std::string kPly = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                         "property float y\nproperty float z\nend_header\n1 2 3\n";

/// A file of the test's own with that content, gone with it.
class File
{
public:
  File(const std::string& name, const std::string& content)
    : Path(testing::TempDir() + name)
  {
    std::filesystem::remove(this->Path);
    writeText(this->Path, content);
  }
  ~File() { std::filesystem::remove(this->Path); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const std::string& path() const { return this->Path; }

private:
  std::string Path;
};

std::string formatOf(const std::string& name, const std::string& content)
{
  const File file(name, content);
  return formatToRead(file.path(), {}).name;
}

} // namespace

TEST(FormatRegistry, ContentDecidesBeforeTheExtension)
{
  EXPECT_EQ(formatOf("scan.ply", kPly), "PLY");
  EXPECT_EQ(formatOf("scan.stl", kPly), "PLY");
  EXPECT_EQ(formatOf("scan", kPly), "PLY");
  EXPECT_EQ(formatOf("scan.dat", "1 2 3\n4 5 6\n"), "points as text");
  EXPECT_EQ(formatOf("scan.OBJ", "v 1 2 3\nv 4 5 6\n"), "OBJ");
  EXPECT_EQ(formatOf("scan.dat", "ISO-10303-21;\nHEADER;\n"), "STEP");
  EXPECT_EQ(formatOf("scan.dat", std::string(72, ' ') + "S      1\n"), "IGES");
  EXPECT_EQ(formatOf("scan.dat", "# vtk DataFile Version 3.0\nt\nASCII\n"), "legacy VTK");
  EXPECT_EQ(formatOf("scan.dat", "<VTKFile type=\"PolyData\">\n"), "VTK XML PolyData");
  EXPECT_EQ(formatOf("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\n"), "STL");
}

TEST(FormatRegistry, BrokenContentGoesToTheParserOfTheExtension)
{
  EXPECT_EQ(formatOf("broken.ply", "plx\n"), "PLY");
}

TEST(FormatRegistry, RefusesWhatNobodyCanRead)
{
  EXPECT_THROW(formatOf("noise.bin", std::string(999, '\0')), Error);
  EXPECT_THROW(formatOf("empty.ply", ""), Error);
  EXPECT_THROW(formatOf("picture.png", "\x89PNG\r\n\x1a\n"), Error);
  EXPECT_THROW(formatToRead(testing::TempDir(), {}), Error);
  EXPECT_THROW(formatToRead("no-such-file.ply", {}), Error);
}

TEST(FormatRegistry, WritesByExtensionOfAnyCase)
{
  EXPECT_EQ(formatToWrite("out.stl").name, "STL");
  EXPECT_EQ(formatToWrite("a.b/out.PLY").name, "PLY");
  EXPECT_EQ(formatToWrite("-").name, "PLY");
  EXPECT_EQ(formatToWrite("out.xyz").name, "points as text");
  EXPECT_TRUE(formatToWrite("out.png").isPicture);
  for (const char* path : { "out", "out.", "out.foo", "out.csv", "out.las", ".stl", "stl" })
  {
    EXPECT_THROW(formatToWrite(path), Error) << path;
  }
}

TEST(FormatRegistry, EveryFormatCanBeRecognisedAndReadOrWritten)
{
  for (const Format& format : formats())
  {
    EXPECT_FALSE(format.extensions.empty()) << format.name;
    EXPECT_TRUE(format.makeReader != nullptr || format.makeWriter != nullptr) << format.name;
    EXPECT_EQ(format.makeReader == nullptr, format.looksLike == nullptr) << format.name;
  }
}
