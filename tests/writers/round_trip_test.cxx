// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/stl.h"
#include "tests/readers/parsing.h"
#include "tests/writers/written.h"
#include "writers/obj.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <locale>
#include <random>

namespace
{

using scan::Encoding;
using scan::TriMesh;
using scan::Vec3;
using scan::test::bentStrip;
using scan::test::bytesOf;
using scan::test::parse;

/// Finite numbers of every size, -0 and denormals too.
TriMesh wildPoints(unsigned seed)
{
  std::mt19937_64 random(seed);
  const auto coordinate = [&]
  {
    double value = 0.0;
    do
    {
      value = std::bit_cast<double>(random());
    } while (!(std::abs(value) <= 1e50));
    return value;
  };
  TriMesh mesh;
  for (int i = 0; i < 5000; ++i)
  {
    mesh.points.push_back({ coordinate(), coordinate(), coordinate() });
  }
  mesh.points.push_back({ -0.0, std::numeric_limits<double>::denorm_min(), 1e50 });
  mesh.triangles = { { 0, 1, 2 }, { 5000, 4999, 4998 } };
  return mesh;
}

void expectSameBits(const TriMesh& mesh, const TriMesh& expected)
{
  ASSERT_EQ(mesh.points.size(), expected.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    using Bits = std::array<std::uint64_t, 3>;
    ASSERT_EQ(std::bit_cast<Bits>(mesh.points[i]), std::bit_cast<Bits>(expected.points[i])) << i;
  }
  EXPECT_EQ(mesh.triangles, expected.triangles);
}

struct CommaPoint : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

} // namespace

TEST(RoundTrip, KeepsEveryBitInPlyAndObj)
{
  const unsigned seed = 99;
  SCOPED_TRACE("seed " + std::to_string(seed));
  const TriMesh mesh = wildPoints(seed);
  using namespace scan::test;
  expectSameBits(parse(scan::parsePly, bytesOf(mesh, plyFormat(Encoding::binary))), mesh);
  expectSameBits(parse(scan::parsePly, bytesOf(mesh, plyFormat(Encoding::ascii))), mesh);
  expectSameBits(parse(scan::parseObj, bytesOf(mesh, scan::writeObj)), mesh);
}

TEST(RoundTrip, KeepsCurvesInObj)
{
  scan::Model model{ bentStrip(20) };
  model.curves = { { 3, 1, 4, 0, 2, 3, 0 }, { 3, 7 } };
  const std::string text = scan::test::modelBytes(model, scan::writeObj);
  EXPECT_EQ(parse(scan::parseObj, text).curves, model.curves);
  EXPECT_NE(text.find("\nl 4 2 5\nl 1 3 4 1\n"), std::string::npos);
}

TEST(RoundTrip, KeepsPlyWithFloatCoordinates)
{
  const TriMesh mesh = scan::test::rounded(bentStrip(100));
  const std::string bytes = bytesOf(mesh, scan::test::plyFormat(Encoding::binary));
  EXPECT_NE(bytes.find("property float x"), std::string::npos);
  expectSameBits(parse(scan::parsePly, bytes), mesh);
  const std::string precise = bytesOf(bentStrip(100), scan::test::plyFormat(Encoding::binary));
  EXPECT_NE(precise.find("property double x"), std::string::npos);
}

TEST(RoundTrip, KeepsScans)
{
  TriMesh scan = bentStrip(50);
  scan.triangles.clear();
  expectSameBits(
    parse(scan::parsePly, bytesOf(scan, scan::test::plyFormat(Encoding::binary))), scan);
  expectSameBits(parse(scan::parseObj, bytesOf(scan, scan::writeObj)), scan);
}

TEST(RoundTrip, KeepsStlUpToTheFormatsPrecision)
{
  const TriMesh mesh = bentStrip(100);
  expectSameBits(
    parse(scan::parseStl, bytesOf(mesh, scan::test::stlFormat(Encoding::ascii))), mesh);
  const TriMesh single = scan::test::rounded(mesh);
  expectSameBits(
    parse(scan::parseStl, bytesOf(mesh, scan::test::stlFormat(Encoding::binary))), single);
}

TEST(WrittenStl, NeverStartsWithSolidInBinary)
{
  const std::string bytes = bytesOf(bentStrip(3), scan::test::stlFormat(Encoding::binary));
  EXPECT_EQ(bytes.size(), 84U + 50U * 4U);
  EXPECT_FALSE(bytes.starts_with("solid"));
}

TEST(WrittenStl, HasUnitNormals)
{
  TriMesh mesh;
  mesh.points = { { 0, 0, 5 }, { 2, 0, 5 }, { 0, 3, 5 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 0, 1 } };
  const std::string text = bytesOf(mesh, scan::test::stlFormat(Encoding::ascii));
  EXPECT_NE(text.find("facet normal 0 0 1\n"), std::string::npos) << text;
  EXPECT_NE(text.find("facet normal 0 0 0\n"), std::string::npos) << text;
}

TEST(WrittenStl, RefusesWhatItCannotHold)
{
  const auto codeOf = [](const TriMesh& mesh)
  { return scan::test::writeError(scan::Model{ mesh }, scan::test::stlFormat(Encoding::binary)); };
  TriMesh mesh = bentStrip(2);
  mesh.points[0].x = 1e39;
  EXPECT_EQ(codeOf(mesh), scan::ErrorCode::limit);
  mesh.triangles.clear();
  EXPECT_EQ(codeOf(mesh), scan::ErrorCode::badInput);
}

TEST(WrittenText, IgnoresTheLocale)
{
  using namespace scan::test;
  const TriMesh mesh = bentStrip(2000);
  const std::string ply = bytesOf(mesh, plyFormat(Encoding::ascii));
  const std::string obj = bytesOf(mesh, scan::writeObj);
  const std::string stl = bytesOf(mesh, stlFormat(Encoding::ascii));
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaPoint));
  EXPECT_EQ(bytesOf(mesh, plyFormat(Encoding::ascii)), ply);
  EXPECT_EQ(bytesOf(mesh, scan::writeObj), obj);
  EXPECT_EQ(bytesOf(mesh, stlFormat(Encoding::ascii)), stl);
  std::locale::global(before);
}

TEST(Writers, LeaveNothingWhenCancelled)
{
  const scan::test::TemporaryFolder folder;
  scan::CancelToken token;
  token.cancel();
  scan::Execution execution(1, token);
  EXPECT_THROW(
    {
      scan::OutputFile file(folder.file("x.ply"));
      scan::writePly({ bentStrip(10) }, {}, file, execution);
      file.commit();
    },
    scan::Cancelled);
  EXPECT_EQ(folder.fileCount(), 0U);
}
