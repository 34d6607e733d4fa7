// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/error.h"
#include "tests/geometry/mesh_corpus.h"
#include "tests/writers/iges_format.h"
#include "tests/writers/iges_structure.h"
#include "writers/iges_file.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using scan::IgesEntities;
using scan::IgesOptions;
using scan::TriMesh;
using scan::Vec3;
using scan::test::bytesOf;
using scan::test::igesFormat;
using scan::test::IgesStructure;

constexpr std::array kAll = { IgesEntities::faces, IgesEntities::solid, IgesEntities::nurbs,
  IgesEntities::wireframe, IgesEntities::points };

TriMesh triangle()
{
  return { { { 0, 0, 5 }, { 2, 0, 5 }, { 0, 0.5, 5 } }, { { 0, 1, 2 } } };
}

/// The type and the message of the error that writing ends in.
std::string errorOf(const TriMesh& mesh, const scan::test::Format& format)
{
  try
  {
    bytesOf(mesh, format);
  }
  catch (const scan::Error& error)
  {
    return (error.code() == scan::ErrorCode::badInput ? "badInput " : "other ") +
      std::string(error.what());
  }
  return "written";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TriMesh scanOf(TriMesh mesh)
{
  mesh.triangles.clear();
  return mesh;
}

/// A parameter that is a number; 0 is the type.
std::size_t number(const IgesStructure::Entity& entity, std::size_t index)
{
  return std::strtoul(entity.parameters.at(index).c_str(), nullptr, 10);
}

Vec3 vector(const IgesStructure::Entity& entity)
{
  const auto real = [&](std::size_t i)
  { return std::strtod(entity.parameters.at(i).c_str(), nullptr); };
  return { real(1), real(2), real(3) };
}

/// The corners of a face of three edges, numbers of points from 0.
scan::Triangle cornersOf(const IgesStructure& file, const IgesStructure::Entity& face)
{
  const auto& loop = file.entity(number(face, 4));
  scan::Triangle corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto& edges = file.entity(number(loop, 5 * k + 3));
    const bool runsAlong = number(loop, 5 * k + 5) == 1;
    const std::size_t edge = 5 * number(loop, 5 * k + 4) - 3; // its curve, start and end
    corners[k] = static_cast<scan::Index>(number(edges, edge + (runsAlong ? 2 : 4)) - 1);
  }
  return corners;
}

} // namespace

TEST(Iges, HasExactlyTheseBytes)
{
  const std::string expected =
    "Triangles by Scanwrap: a bounded plane each (108 form 1)                S      1\n"
    "1H,,1H;,8HScanwrap,12Hscanwrap.igs,8HScanwrap,8HScanwrap,32,308,15,308, G      1\n"
    "15,8HScanwrap,1.,2,2HMM,1,0.01,15H20000101.000000,                      G      2\n"
    "2.0615578128088304E-08,5.,8HScanwrap,8HScanwrap,11,0,15H20000101.000000;G      3\n"
    "     106       1       0       0       0       0       0       000010000D      1\n"
    "     106       0       0       1      12                               0D      2\n"
    "     108       2       0       0       0       0       0       000000000D      3\n"
    "     108       0       0       1       1                               0D      4\n"
    "106,2,4,0.,0.,5.,2.,0.,5.,0.,0.5,5.,0.,0.,5.;                          1P      1\n"
    "108,0.,0.,1.,5.,1,0.,0.,0.,0.;                                         3P      2\n"
    "S      1G      3D      4P      2                                        T      1\n";
  EXPECT_EQ(bytesOf(triangle(), igesFormat(IgesEntities::faces)), expected);
}

TEST(Iges, IsSoundInEveryForm)
{
  for (const IgesEntities entities : kAll)
  {
    SCOPED_TRACE(static_cast<int>(entities));
    const IgesStructure file(bytesOf(corpus::torus(20), igesFormat(entities)));
    EXPECT_EQ(file.fault(), "");
    EXPECT_GT(file.entities().size(), 0U);
  }
}

TEST(Iges, PutsAnEntityForEachTriangle)
{
  const TriMesh mesh = scan::test::bentStrip(50);
  const auto count = [&](IgesEntities entities, int type, int form)
  { return IgesStructure(bytesOf(mesh, igesFormat(entities))).count(type, form); };
  EXPECT_EQ(count(IgesEntities::faces, 108, 1), mesh.triangles.size());
  EXPECT_EQ(count(IgesEntities::faces, 106, 12), mesh.triangles.size());
  EXPECT_EQ(count(IgesEntities::nurbs, 128, 0), mesh.triangles.size());
  EXPECT_EQ(count(IgesEntities::wireframe, 106, 12), mesh.triangles.size());
  EXPECT_EQ(count(IgesEntities::points, 116, 0), mesh.points.size());
}

TEST(Iges, KeepsEveryBitOfCoordinates)
{
  TriMesh mesh = scan::test::bentStrip(50);
  mesh.points.push_back({ -0.0, std::numeric_limits<double>::denorm_min(), -1e50 });
  mesh.points.push_back({ 100000.0, 1e22, -1.2345678901234567e-300 });
  const IgesStructure file(bytesOf(mesh, igesFormat(IgesEntities::points)));
  ASSERT_EQ(file.entities().size(), mesh.points.size());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    const auto& values = file.entities()[i].parameters;
    ASSERT_EQ(values.size(), 5U);
    const std::array<double, 3> found = { std::strtod(values[1].c_str(), nullptr),
      std::strtod(values[2].c_str(), nullptr), std::strtod(values[3].c_str(), nullptr) };
    using Bits = std::array<std::uint64_t, 3>;
    ASSERT_EQ(std::bit_cast<Bits>(found), std::bit_cast<Bits>(mesh.points[i])) << i;
  }
}

TEST(Iges, SolidHasTheTrianglesAndTheirOutside)
{
  const TriMesh mesh = corpus::tetrahedron();
  const IgesStructure file(bytesOf(mesh, igesFormat(IgesEntities::solid)));
  const auto& solid = file.entities().back();
  EXPECT_EQ(solid.parameters, (std::vector<std::string>{ "186", "65", "1", "0" }));
  const auto& shell = file.entity(number(solid, 1));
  ASSERT_EQ(number(shell, 1), mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& face = file.entity(number(shell, 2 * t + 2));
    EXPECT_EQ(number(shell, 2 * t + 3), 1U);
    const scan::Triangle corners = cornersOf(file, face);
    EXPECT_EQ(corners, mesh.triangles[t]);
    const Vec3 a = mesh.points[corners[0]];
    const Vec3 normal = cross(mesh.points[corners[1]] - a, mesh.points[corners[2]] - a);
    const auto& plane = file.entity(number(face, 1));
    EXPECT_EQ(vector(file.entity(number(plane, 1))), a);
    EXPECT_GT(dot(vector(file.entity(number(plane, 2))), normal), 0.99 * std::sqrt(3.0));
  }
}

TEST(Iges, WritesAScanAsPointsWhateverTheOption)
{
  const TriMesh scan = scanOf(scan::test::bentStrip(30));
  const std::string points = bytesOf(scan, igesFormat(IgesEntities::points));
  EXPECT_EQ(IgesStructure(points).count(116, 0), scan.points.size());
  for (const IgesEntities entities : kAll)
  {
    EXPECT_EQ(bytesOf(scan, igesFormat(entities)), points);
  }
}

TEST(Iges, NamesTheUnit)
{
  const auto global = [](double millimetres)
  {
    const std::string bytes = bytesOf(triangle(), igesFormat({}, millimetres));
    const std::size_t begin = bytes.find(",1.,") + 4;
    return bytes.substr(begin, bytes.find(",1,0.01,") - begin);
  };
  EXPECT_EQ(global(0.0), "2,2HMM");
  EXPECT_EQ(global(1.0), "2,2HMM");
  EXPECT_EQ(global(10.0), "10,2HCM");
  EXPECT_EQ(global(1000.0), "6,1HM");
  EXPECT_EQ(global(25.4), "1,4HINCH");
  EXPECT_EQ(global(304.8), "4,2HFT");
}

TEST(Iges, ConvertsUnitsThatItHasNoNameFor)
{
  constexpr double kSurveyFoot = 1200.0 / 3937.0 * 1000.0;
  TriMesh scaled = triangle();
  for (Vec3& p : scaled.points)
  {
    p = p * kSurveyFoot;
  }
  EXPECT_EQ(bytesOf(triangle(), igesFormat({}, kSurveyFoot)), bytesOf(scaled, igesFormat({}, 1.0)));
}

TEST(Iges, RefusesWhatItCannotHold)
{
  TriMesh mesh = triangle();
  EXPECT_TRUE(contains(errorOf({}, igesFormat(IgesEntities::faces)), "badInput"));
  mesh.points[1].x = std::nan("");
  EXPECT_TRUE(contains(errorOf(mesh, igesFormat(IgesEntities::points)), "point 1 has"));
}

TEST(Iges, RefusesTrianglesWithoutAreaWhereTheyNeedAPlane)
{
  TriMesh mesh = triangle();
  mesh.triangles.push_back({ 0, 0, 1 });
  EXPECT_TRUE(contains(errorOf(mesh, igesFormat(IgesEntities::faces)), "triangle 1 has no area"));
  EXPECT_EQ(errorOf(mesh, igesFormat(IgesEntities::nurbs)), "written");
  EXPECT_EQ(errorOf(mesh, igesFormat(IgesEntities::wireframe)), "written");
}

TEST(Iges, SaysWhyASurfaceIsNoSolid)
{
  const auto error = [](const TriMesh& mesh)
  { return errorOf(mesh, igesFormat(IgesEntities::solid)); };
  EXPECT_TRUE(contains(error(corpus::square()), "4 boundary edges; mend it or write it as faces"));
  EXPECT_TRUE(contains(error(corpus::tetrahedraOnOneEdge()), "1 non-manifold edges"));
  EXPECT_TRUE(contains(error(corpus::tetrahedraOnOnePoint()), "1 non-manifold points"));
  TriMesh turned = corpus::tetrahedron();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_TRUE(contains(error(turned), "3 misoriented edges"));
}

TEST(Iges, NeverNeedsMoreLinesThanItCanNumber)
{
  const auto codeOf = [](std::uint64_t entities, const std::function<void(scan::IgesSink&)>& put)
  {
    const scan::test::TemporaryFolder folder;
    scan::Execution execution;
    scan::OutputFile file(folder.file("x.igs"));
    try
    {
      writeIgesFile({}, entities, put, file, execution);
    }
    catch (const scan::Error& error)
    {
      return error.code();
    }
    return scan::ErrorCode::internal;
  };
  EXPECT_EQ(codeOf(5'000'000, [](scan::IgesSink&) {}), scan::ErrorCode::limit);
  const auto longEntity = [](scan::IgesSink& sink)
  {
    sink.begin({ .type = 116 });
    for (int i = 0; i < 30'000'000; ++i)
    {
      sink.integer(std::numeric_limits<std::uint64_t>::max()); // three a line
    }
    sink.end();
  };
  EXPECT_EQ(codeOf(1, longEntity), scan::ErrorCode::limit);
}

TEST(Iges, StopsWhenCancelled)
{
  for (const IgesEntities entities : kAll)
  {
    scan::test::expectCancels(scan::Model{ corpus::torus(10) }, igesFormat(entities));
  }
}
