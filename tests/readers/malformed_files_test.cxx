// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever the bytes, a parser ends in a usable mesh or in scan::Error.
#include "readers/mapped_file.h"
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/stl.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <utility>

namespace
{

using scan::test::expectErrorOrModel;
using scan::test::Parser;

constexpr Parser kStl = scan::parseStl;

struct Sample
{
  std::string name;
  Parser parser;
  std::string bytes;
};

/// The header's count, and facets of a fan around the origin.
std::string binaryStl(std::uint32_t count)
{
  std::string bytes(80, '\0');
  bytes.append(reinterpret_cast<const char*>(&count), sizeof(count));
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const auto t = static_cast<float>(i);
    const float facet[12] = { 0, 0, 1, 0, 0, 0, 1, t, 0, 1, t + 1, 0 };
    bytes.append(reinterpret_cast<const char*>(facet), sizeof(facet)).append(2, '\0');
  }
  return bytes;
}

std::vector<Sample> smallSamples()
{
  const std::string header = "element vertex 3\nproperty double x\nproperty float y\n"
                             "property list uchar short w\nproperty uchar z\nelement face 1\n"
                             "property list uchar int vertex_indices\nend_header\n";
  const std::string values("\0\0\0\0\0\0\xf0?\0\0\0?\1\1\0\7"
                           "\0\0\0\0\0\0\xf0?\0\0\0?\0\7"
                           "\0\0\0\0\0\0\xf0?\0\0\0?\0\7"
                           "\3\0\0\0\0\1\0\0\0\2\0\0\0",
    57);
  const std::string swapped("?\xf0\0\0\0\0\0\0?\0\0\0\1\0\1\7"
                            "?\xf0\0\0\0\0\0\0?\0\0\0\0\7"
                            "?\xf0\0\0\0\0\0\0?\0\0\0\0\7"
                            "\3\0\0\0\0\0\0\0\1\0\0\0\2",
    57);
  return {
    { "text", scan::parsePointsText, "# c\nX Y Z\n3\n1 2 3\r\n4,5,6e2\n7;8;9 1\n-1e-5 .5 1.\n" },
    { "coloured text", scan::parsePointsText, "1 2 3 10 20 30 1 0 0\n4 5 6 40 50 60 0 .6 .8\n" },
    { "lettered", scan::parsePointsText, "# c\nd 0 0 0\np 1 2 3\np 4 5 6\n" },
    { "ascii ply", scan::parsePly,
      "ply\nformat ascii 1.0\n" + header + "0 0 1 5 2\n1 0 0 2\n0 1 2 8 9 2\n3 0 1 2\n" },
    { "binary ply", scan::parsePly, "ply\nformat binary_little_endian 1.0\n" + header + values },
    { "big-endian ply", scan::parsePly, "ply\nformat binary_big_endian 1.0\n" + header + swapped },
    { "coloured ply", scan::parsePly,
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property float red\nproperty uchar green\nproperty uchar blue\nend_header\n"
      "1 2 3 0 0 1 .5 1 0\n4 5 6 0 1e-9 1 .2 0 1\n" },
    { "coloured obj", scan::parseObj,
      "v 0 0 0 1 0.5 0\nv 1 0 0 1 1 1\nv 0 1 0\nvn 0 0 1\nvn 0 1 1\nvn 1 0 0\n"
      "f 1//1 2//2 3//3\nf -1//-1 -2//-2 1//1\n" },
    { "obj", scan::parseObj, "v 0 0 0\nv 1 0 0\\\n\nv 1 1 0\nf 1/2/3 2//3 -1/1\nf 1 2 \\\n 3\n" },
    { "binary stl", kStl, binaryStl(5) },
    { "ascii stl", kStl,
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\n"
      "endloop\nendfacet\nendsolid a\n" },
  };
}

/// Real files; none where the shared folder is missing.
std::vector<Sample> sharedSamples()
{
  const std::filesystem::path folder = SCAN_SHARED_DIR "/data";
  const std::pair<const char*, Parser> files[] = {
    { "01_points/cgal/half.xyz", scan::parsePointsText },
    { "01_points/hoppe/curve1.pts", scan::parsePointsText },
    { "02_range_scans/stanford_armadillo/ArmadilloBack_1.ply", scan::parsePly },
    { "02_range_scans/stanford_bunny/reconstruction/bun_zipper_res4.ply", scan::parsePly },
    { "05_meshes/cgal/sphere.stl", kStl },
    { "09_bad/assimp/box_longline.obj", scan::parseObj },
    { "09_bad/assimp/triangle_with_two_solids.stl", kStl },
    { "09_bad/trimesh/negative_indices.obj", scan::parseObj },
    { "09_bad/trimesh/soup.stl", kStl },
  };
  std::vector<Sample> samples;
  for (const auto& [name, parser] : files)
  {
    if (std::filesystem::exists(folder / name))
    {
      const scan::MappedFile file(folder / name);
      samples.push_back({ name, parser, { file.bytes().begin(), file.bytes().end() } });
    }
  }
  return samples;
}

unsigned testSeed()
{
  const char* const text = std::getenv("SCAN_TEST_SEED");
  return text != nullptr ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : 1U;
}

} // namespace

TEST(MalformedFile, EndsInErrorOrMeshWhenCutAnywhere)
{
  for (const Sample& sample : smallSamples())
  {
    for (std::size_t size = 1; size < sample.bytes.size(); ++size)
    {
      expectErrorOrModel(sample.parser, sample.bytes.substr(0, size),
        sample.name + " cut at " + std::to_string(size));
    }
    EXPECT_EQ(scan::test::parseError(sample.parser, sample.bytes), "") << sample.name;
  }
}

TEST(MalformedFile, EndsInErrorOrMeshWhenARealFileIsCut)
{
  const std::vector<Sample> samples = sharedSamples();
  if (samples.empty())
  {
    GTEST_SKIP() << SCAN_SHARED_DIR "/data is missing";
  }
  for (const Sample& sample : samples)
  {
    for (std::size_t size = 64; size < sample.bytes.size(); size += 64)
    {
      expectErrorOrModel(sample.parser, sample.bytes.substr(0, size),
        sample.name + " cut at " + std::to_string(size));
    }
  }
}

TEST(MalformedFile, EndsInErrorOrMeshWhenBytesChange)
{
  const unsigned seed = testSeed();
  std::mt19937 random(seed);
  for (const Sample& sample : smallSamples())
  {
    for (int round = 0; round < 3000; ++round)
    {
      std::string bytes = sample.bytes;
      for (int change = 0; change <= round % 3; ++change)
      {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      expectErrorOrModel(sample.parser, bytes,
        sample.name + " round " + std::to_string(round) +
          " SCAN_TEST_SEED=" + std::to_string(seed));
    }
  }
}
