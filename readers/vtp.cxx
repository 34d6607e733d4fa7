// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtp.h"

#include "readers/text_scanner.h"

#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace scan
{
namespace
{

constexpr std::size_t kTailBytes = 4096;
constexpr std::size_t kBestCompression = 1100; // of zlib, of bytes that are all the same

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
  const char* const end = text.data() + text.size();
  const char* const start = skipSpace(skipUtf8Mark(text), end);
  return start != end && *start == '<';
}

void checkCounts(const Source& source)
{
  const std::string_view text(source.begin(), source.bytes.size());
  const bool isCompressed = firstTag(text).find("compressor") != std::string_view::npos;
  const std::size_t most = source.bytes.size() * (isCompressed ? kBestCompression : 1);
  const std::string_view markup = text.substr(0, text.find("<AppendedData"));
  for (std::size_t at = markup.find("NumberOf"); at != std::string_view::npos;
       at = markup.find("NumberOf", at + 1))
  {
    const std::string_view rest = markup.substr(at);
    const std::size_t start = rest.find_first_of("\"'");
    if (start == std::string_view::npos)
    {
      break;
    }
    std::size_t count = 0;
    const auto result = std::from_chars(rest.data() + start + 1, rest.data() + rest.size(), count);
    if (result.ec == std::errc::result_out_of_range || count > most)
    {
      source.failAtByte(rest.data(),
        quoted(rest.substr(0, rest.find_first_of("\"'", start + 1) + 1)) +
          " is more than the file can hold; write the file again");
    }
  }
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

void checkVtp(const Source& source)
{
  const std::string_view text(source.begin(), source.bytes.size());
  const std::string_view tail = text.substr(text.size() - std::min(text.size(), kTailBytes));
  if (tail.rfind("</VTKFile>") == std::string_view::npos)
  {
    source.fail("the file ends early: </VTKFile> is missing; copy or write it again");
  }
  checkCounts(source);
}

} // namespace scan
