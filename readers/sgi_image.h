// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace scan
{

struct SgiImage
{
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<Color> pixels; ///< row after row from the lowest, each from the left
};

/// Reads an SGI image (.rgb, .sgi, .bw), raw or run-length encoded, of one byte a channel. One or
/// two channels are grey, three or four colour; the last of an even number, alpha, is skipped.
///
/// Throws Error parse for a malformed or truncated file, for two bytes a channel, for colour maps
/// and for images much larger than the file (20 times and 64 MB) or without pixels.
SgiImage parseSgiImage(std::span<const char> bytes, std::string_view name);

/// Whether a file that starts with `head` can be an SGI image.
bool looksLikeSgiImage(std::span<const char> head);

} // namespace scan
