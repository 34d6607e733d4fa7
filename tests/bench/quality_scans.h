// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/bench/quality_methods.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace quality
{

/// Points, and the surface they were taken from where that is known.
struct Scan
{
  Cloud cloud;
  std::optional<scan::TriMesh> truth; ///< a mesh, fine enough to stand for a curved surface
};

/// What a surface should be: one manifold part of this genus, with every boundary capped.
struct Shape
{
  int genus = 0;
  std::optional<bool> closed; ///< none: either will do
};

/// A scan of the comparison, read when its turn comes.
struct ScanSource
{
  std::string name;
  std::optional<Shape> shape; ///< none where nobody knows
  std::string about;          ///< what it is, what its surface is like, what counts as the truth
  std::filesystem::path file;
  std::function<Scan(const std::filesystem::path& file)> load; ///< throws Error
};

/// All scans of the comparison, whether their files are there or not.
/// @param shared folder of the larger corpus
/// @param data folder of the project's samples
std::vector<ScanSource> scanSources(
  const std::filesystem::path& shared, const std::filesystem::path& data);

} // namespace quality
