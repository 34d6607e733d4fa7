// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/mapped_file.h"
#include "readers/obj.h"
#include "readers/ply.h"
#include "readers/points_text.h"
#include "readers/stl.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace scan::test
{

/// The data of the shared corpus.
inline const std::filesystem::path kData = std::filesystem::path(SCAN_SHARED_DIR) / "data";

/// Skips the test where a file of the corpus is missing.
#define SCAN_NEED(file)                                                                            \
  if (!std::filesystem::exists(file))                                                              \
  {                                                                                                \
    GTEST_SKIP() << (file) << " is not there: the shared corpus is missing";                       \
  }

/// The points of a file, by its extension.
inline std::vector<Vec3> load(const std::filesystem::path& path)
{
  const MappedFile file(path.string());
  Execution execution;
  const std::string kind = path.extension().string();
  if (kind == ".stl")
  {
    return parseStl(file.bytes(), path.string(), execution).points;
  }
  const auto parse = kind == ".ply" ? parsePly : kind == ".obj" ? parseObj : parsePointsText;
  return parse(file.bytes(), path.string(), execution).points;
}

} // namespace scan::test
