// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace scan::test
{

/// What lib3mf (package lib3mf-dev), the reference implementation of 3MF, finds in a file: of its
/// first mesh.
struct Lib3mfResult
{
  bool isRead = false;
  std::size_t warnings = 0;
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  bool isClosed = false; ///< manifold, without boundary, oriented
};

/// Whether the tests were built with lib3mf.
bool hasLib3mf();

/// @param rewritten where lib3mf writes the model again; empty: nowhere
Lib3mfResult readWithLib3mf(const std::string& path, const std::string& rewritten = {});

} // namespace scan::test
