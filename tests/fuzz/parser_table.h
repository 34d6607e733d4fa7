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
#include "readers/legacy_vtk.h"
#include "readers/obj.h"
#include "readers/off.h"
#include "readers/pcd.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/pts.h"
#include "readers/ptx.h"
#include "readers/sgi_image.h"
#include "readers/stl.h"
#include "readers/threemf.h"
#include "readers/transforms.h"
#include "readers/vtp.h"

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
inline constexpr std::size_t kGuesses = std::size_t(256) << 10U; // from a thousand lines at most

/// A range map with its triangles, and colours from an image of six pixels.
inline Model parseColoredCyberware(
  std::span<const char> bytes, std::string_view name, Execution& execution)
{
  CyberwareScan scan = parseCyberwareScan(bytes, name, { .mesh = true }, execution);
  addCyberwareColors(scan, { 3, 2, { {}, {}, {}, {}, {}, {} } });
  return std::move(scan.model);
}

/// Without a model to be copied a thousand times, which takes the fuzzer too long.
inline Model parseSmallGltf(
  std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseGltfScene(bytes, name, { .largest = 36e6 }, execution);
}

inline Model parseSmallThreemf(
  std::span<const char> bytes, std::string_view name, Execution& execution)
{
  return parseThreemfUpTo(0.0, bytes, name, execution);
}

/// A list of transforms has no points: an empty model.
inline Model parseTransformList(std::span<const char> bytes, std::string_view name, Execution&)
{
  parseTransforms(bytes, name);
  return {};
}

/// What is checked before VTK reads a file: an empty model.
inline Model checkVtpFile(std::span<const char> bytes, std::string_view name, Execution&)
{
  checkVtp({ name, bytes });
  return {};
}

inline bool looksLikeAnything(std::span<const char>)
{
  return true;
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
  { "gltf", parseSmallGltf, looksLikeGltf, kExpands },
  { "las", parseLas, looksLikeLas },
  { "legacy_vtk", parseLegacyVtk, looksLikeLegacyVtk },
  { "obj", parseObj, looksLikeObj },
  { "off", parseOff, looksLikeOff },
  { "pcd", parsePcd, looksLikePcd, kExpands },
  { "ply", parsePly, looksLikePly },
  { "ply_range_grid", parsePlyRangeGrid, looksLikePly },
  { "points_text", parsePointsText, looksLikePointsText, kGuesses },
  { "pts", parsePts, looksLikePts },
  { "ptx", parsePtx, looksLikePtx },
  { "sgi_image", parseImage, looksLikeSgiImage, kExpands },
  { "stl", parseStl, looksLikeStl },
  { "threemf", parseSmallThreemf, looksLikeThreemf, 2 * kExpands, 24 },
  { "transforms", parseTransformList, looksLikeAnything },
  { "vtp_counts", checkVtpFile, looksLikeVtp },
};

} // namespace scan::test
