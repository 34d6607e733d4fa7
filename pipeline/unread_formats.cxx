// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unread_formats.h"

#include <algorithm>
#include <string_view>

namespace scan
{
namespace
{

using namespace std::string_view_literals;

struct UnreadFormat
{
  std::string_view start;
  std::string_view advice;
};

constexpr UnreadFormat kUnread[] = {
  { "\x1F\x8B"sv, "is compressed with gzip; unpack it first, with gunzip" },
  { "\xFD"
    "7zXZ"sv,
    "is compressed with xz; unpack it first, with unxz" },
  { "BZh"sv, "is compressed with bzip2; unpack it first, with bunzip2" },
  { "ASTM-E57"sv, "is an E57 scan, which is not read; export it as PTX, LAS or PLY" },
  { "#VRML"sv, "is a VRML scene, which is written but not read; export it as PLY, OBJ or glTF" },
  { "#Inventor"sv, "is an Open Inventor scene, which is written but not read; export it as PLY" },
  { "MeshVersionFormatted"sv, "is a Medit mesh, which is not read; export it as OFF, PLY or STL" },
  { "DBRep_DrawableShape"sv, "is an OpenCASCADE shape, which is not read; export it as STEP" },
  { "CASCADE Topology"sv, "is an OpenCASCADE shape, which is not read; export it as STEP" },
  { "ncols"sv, "is an ESRI grid of heights, which is not read; export it as XYZ" },
  { "NCOLS"sv, "is an ESRI grid of heights, which is not read; export it as XYZ" },
  { "AutoCAD Binary DXF"sv, "is a drawing, which is not read; export it as STL or OBJ" },
  { "\xD0\xCF\x11\xE0"sv,
    "is an office or CAD document, which is not read; export it as STL or STEP" },
};

/// A DXF drawing starts with group code 0 and SECTION, perhaps behind comments of code 999.
bool looksLikeDxf(std::string_view text)
{
  const auto nextWord = [&]
  {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(word.size());
    return word;
  };
  std::string_view code = nextWord();
  while (code == "999")
  {
    nextWord();
    code = nextWord();
  }
  return code == "0" && nextWord() == "SECTION";
}

} // namespace

std::string adviceOnUnread(std::span<const char> head)
{
  const std::string_view text(head.data(), head.size());
  const auto found = std::ranges::find_if(
    kUnread, [&](const UnreadFormat& format) { return text.starts_with(format.start); });
  if (found != std::end(kUnread))
  {
    return std::string(found->advice);
  }
  return looksLikeDxf(text) ? "is a DXF drawing, which is written but not read; export it as STL"
                            : "";
}

} // namespace scan
