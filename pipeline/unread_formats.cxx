// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unread_formats.h"

#include "readers/text_scanner.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace scan
{
namespace
{

using namespace std::string_view_literals;

/// How a file starts, or the extension of its name, and what is to be said about it.
struct UnreadFormat
{
  std::string_view mark;
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
  { "FACET FILE"sv, "is a VTK facet file, which is not read; export it as STL or PLY" },
  { "bmesh "sv, "is a list that places scans; give it with --transforms" },
  { "camera "sv, "is a list that places scans; give it with --transforms" },
  { "AutoCAD Binary DXF"sv, "is a drawing, which is not read; export it as STL or OBJ" },
  { "\xD0\xCF\x11\xE0"sv,
    "is an office or CAD document, which is not read; export it as STL or STEP" },
};

/// Formats of numbers, in which others could see points.
constexpr UnreadFormat kUnreadNames[] = {
  { "raw"sv, "is a list of triangles (RAW), which is not read; export it as STL or PLY" },
  { "g"sv, "is a Movie.BYU mesh, which is not read; export it as STL or PLY" },
  { "byu"sv, "is a Movie.BYU mesh, which is not read; export it as STL or PLY" },
  { "m"sv, "is a mesh of Hoppe's programs or of Matlab, which is not read; export it as PLY" },
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

/// The kind of data in a VTK XML file, when it is another than PolyData.
std::string_view otherVtkKind(std::string_view text)
{
  constexpr std::string_view kKey = "<VTKFile type=\"";
  const std::size_t start = text.substr(0, 1024).find(kKey);
  if (start == std::string_view::npos)
  {
    return {};
  }
  const std::string_view kind = text.substr(start + kKey.size());
  const std::string_view name = kind.substr(0, kind.find('"'));
  return name == "PolyData" ? std::string_view() : name;
}

} // namespace

std::string adviceOnUnread(std::span<const char> head)
{
  const std::string_view text(head.data(), head.size());
  const auto found = std::ranges::find_if(
    kUnread, [&](const UnreadFormat& format) { return text.starts_with(format.mark); });
  if (found != std::end(kUnread))
  {
    return std::string(found->advice);
  }
  if (const std::string_view kind = otherVtkKind(text); !kind.empty())
  {
    return "is a VTK file of " + quoted(kind) + "; only PolyData is read, save its surface as .vtp";
  }
  return looksLikeDxf(text) ? "is a DXF drawing, which is written but not read; export it as STL"
                            : "";
}

std::string adviceOnUnreadName(const std::string& extension)
{
  const auto found = std::ranges::find(kUnreadNames, extension, &UnreadFormat::mark);
  return found != std::end(kUnreadNames) ? std::string(found->advice) : "";
}

} // namespace scan
