// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"
#include "readers/autodesk_3ds.h"
#include "readers/cyberware.h"
#include "readers/digibotics.h"
#include "readers/gltf.h"
#include "readers/las.h"
#include "readers/obj.h"
#include "readers/off.h"
#include "readers/pcd.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/pts.h"
#include "readers/ptx.h"
#include "readers/sgi_image.h"
#include "readers/stl.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

namespace scan::test
{

/// A parser as the fuzzers and the test of their corpora call it.
struct FuzzedParser
{
  std::string_view name; ///< of the fuzzer, and of its folder in corpus/
  Model (*parse)(std::span<const char> bytes, std::string_view name, Execution& execution);
  bool (*looksLike)(std::span<const char> head);
  /// What a parser may take beside a multiple of the file: less than the 64 MB that are promised
  /// where nothing in the format expands, so that small files show it when a count is trusted.
  std::size_t freeMemory = std::size_t(4) << 10U;
  std::size_t memoryPerByte = 20;
};

inline constexpr std::size_t kExpands = std::size_t(64) << 20U;

template <TriMesh (*Parse)(std::span<const char>, std::string_view, Execution&)>
Model parseMesh(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return Model{ Parse(bytes, name, execution) };
}

/// A range map with its triangles, and colours from an image of six pixels.
inline Model parseColoredCyberware(
  std::span<const char> bytes, std::string_view name, Execution& execution)
{
  CyberwareScan scan = parseCyberwareScan(bytes, name, { .mesh = true }, execution);
  addCyberwareColors(scan, { 3, 2, { {}, {}, {}, {}, {}, {} } });
  return std::move(scan.model);
}

/// An image has no points: an empty model.
inline Model parseImage(std::span<const char> bytes, std::string_view name, Execution&)
{
  parseSgiImage(bytes, name);
  return {};
}

inline constexpr FuzzedParser kFuzzedParsers[] = {
  { "autodesk_3ds", parseAutodesk3ds, looksLikeAutodesk3ds },
  { "cyberware", parseColoredCyberware, looksLikeCyberware, std::size_t(4) << 10U, 30 },
  { "digibotics", parseDigibotics, looksLikeDigibotics },
  { "gltf", parseGltf, looksLikeGltf, kExpands },
  { "las", parseLas, looksLikeLas },
  { "obj", parseObj, looksLikeObj },
  { "off", parseOff, looksLikeOff },
  { "pcd", parsePcd, looksLikePcd, kExpands },
  { "ply", parsePly, looksLikePly },
  { "ply_range_grid", parsePlyRangeGrid, looksLikePly },
  { "points_text", parsePointsText, looksLikePointsText },
  { "pts", parsePts, looksLikePts },
  { "ptx", parsePtx, looksLikePtx },
  { "sgi_image", parseImage, looksLikeSgiImage, kExpands },
  { "stl", parseMesh<parseStl>, looksLikeStl },
};

} // namespace scan::test
