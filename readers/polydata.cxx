// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/polydata.h"

#include <string_view>

namespace scan
{
namespace
{

/// The first element's start tag, behind the declaration and comments.
std::string_view firstTag(std::string_view text)
{
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1))
  {
    if (text.substr(at).starts_with("<!--"))
    {
      at = text.find("-->", at);
      if (at == std::string_view::npos)
      {
        break;
      }
    }
    else if (!text.substr(at).starts_with("<?"))
    {
      return text.substr(at, text.find('>', at) - at);
    }
  }
  return {};
}

bool startsAsXml(std::string_view text)
{
  text = text.substr(text.starts_with("\xef\xbb\xbf") ? 3 : 0);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  return start != std::string_view::npos && text[start] == '<';
}

} // namespace

bool looksLikeVtp(std::span<const char> head)
{
  const std::string_view text(head.data(), head.size());
  const std::string_view tag = startsAsXml(text) ? firstTag(text) : std::string_view();
  return tag.starts_with("<VTKFile") &&
    (tag.find("\"PolyData\"") != std::string_view::npos ||
      tag.find("'PolyData'") != std::string_view::npos);
}

bool looksLikeLegacyVtk(std::span<const char> head)
{
  return std::string_view(head.data(), head.size()).starts_with("# vtk DataFile Version");
}

} // namespace scan
