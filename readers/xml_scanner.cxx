// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/xml_scanner.h"

#include "readers/text_scanner.h"

#include <algorithm>

namespace scan
{
namespace
{

constexpr std::size_t kLongestTag = std::size_t(1) << 20U;

bool isSpace(char c)
{
  return isBlank(c) || isLineEnd(c);
}

std::string_view withoutPrefix(std::string_view name)
{
  return name.substr(name.find(':') + 1); // npos + 1 is 0
}

} // namespace

XmlScanner::XmlScanner(ZipStream& text, Execution& execution)
  : Text(text)
  , Run(execution)
{
  this->refill();
  if (this->Buffer.starts_with("\xfe\xff") || this->Buffer.starts_with("\xff\xfe"))
  {
    this->fail("UTF-16 is not read; save the file as UTF-8");
  }
}

/// Drops what lies in front of At and appends the next piece; false when there is none.
bool XmlScanner::refill()
{
  this->Run.step("read", this->Text.position(), this->Text.source().bytes.size());
  const auto passed = this->Buffer.begin() + static_cast<std::ptrdiff_t>(this->At);
  this->Lines += static_cast<std::size_t>(std::count(this->Buffer.begin(), passed, '\n'));
  this->Buffer.erase(0, this->At);
  this->At = 0;
  const std::span<const char> piece = this->Text.next();
  this->Buffer.append(piece.data(), piece.size());
  return !piece.empty();
}

/// Moves behind the next `end`; false when the document ends before.
bool XmlScanner::skipBehind(std::string_view end)
{
  for (;;)
  {
    const std::size_t found = this->Buffer.find(end, this->At);
    if (found != std::string::npos)
    {
      this->At = found + end.size();
      return true;
    }
    this->At =
      std::max(this->At, this->Buffer.size() - std::min(this->Buffer.size(), end.size() - 1));
    if (!this->refill())
    {
      return false;
    }
  }
}

/// Whether the document goes on with this text.
bool XmlScanner::hasAhead(std::string_view text)
{
  while (this->Buffer.size() - this->At < text.size() && this->refill())
  {
  }
  return std::string_view(this->Buffer).substr(this->At).starts_with(text);
}

bool XmlScanner::next()
{
  if (this->IsEmpty)
  {
    this->IsEmpty = false;
    this->IsStart = false;
    return true;
  }
  while (this->skipBehind("<"))
  {
    std::string_view end;
    if (this->hasAhead("!--"))
    {
      this->At += 3;
      end = "-->";
    }
    else if (this->hasAhead("![CDATA["))
    {
      end = "]]>";
    }
    else if (this->hasAhead("?"))
    {
      end = "?>";
    }
    else if (this->hasAhead("!"))
    {
      this->fail("a document type declaration is not allowed");
    }
    else
    {
      this->readTag();
      return true;
    }
    if (!this->skipBehind(end))
    {
      this->fail("the document ends inside a comment; the file is truncated");
    }
  }
  return false;
}

/// Reads a tag from behind its '<'.
void XmlScanner::readTag()
{
  char quote = '\0';
  std::size_t length = 0;
  for (;; ++length)
  {
    if (this->At + length == this->Buffer.size() && !this->refill())
    {
      this->fail("the document ends inside a tag; the file is truncated");
    }
    if (length > kLongestTag)
    {
      this->fail("a tag of more than 1 MB");
    }
    const char c = this->Buffer[this->At + length];
    if (quote == '\0' && c == '>')
    {
      break;
    }
    quote = quote == '\0' ? (c == '"' || c == '\'' ? c : '\0') : (c == quote ? '\0' : quote);
  }
  std::string_view tag = std::string_view(this->Buffer).substr(this->At, length);
  this->At += length + 1;
  this->IsStart = !tag.starts_with('/');
  this->IsEmpty = this->IsStart && tag.ends_with('/');
  tag.remove_prefix(this->IsStart ? 0 : 1);
  tag.remove_suffix(this->IsEmpty ? 1 : 0);
  const std::size_t nameEnd =
    static_cast<std::size_t>(std::find_if(tag.begin(), tag.end(), isSpace) - tag.begin());
  this->Name = withoutPrefix(tag.substr(0, nameEnd));
  this->Attributes = tag.substr(nameEnd);
  if (this->Name.empty())
  {
    this->fail("a tag without a name");
  }
}

template <class Matches>
std::optional<std::string_view> XmlScanner::findAttribute(const Matches& matches) const
{
  const char* at = this->Attributes.data();
  const char* const end = at + this->Attributes.size();
  for (at = skipSpace(at, end); at != end; at = skipSpace(at, end))
  {
    const char* const equals = std::find(at, end, '=');
    const char* nameEnd = equals;
    while (nameEnd != at && isSpace(nameEnd[-1]))
    {
      --nameEnd;
    }
    const char* const quote = equals == end ? end : skipSpace(equals + 1, end);
    if (quote == end || (*quote != '"' && *quote != '\''))
    {
      this->fail("a malformed attribute in the tag " + scan::quoted(this->Name));
    }
    const char* const close = std::find(quote + 1, end, *quote);
    if (close == end)
    {
      this->fail("a malformed attribute in the tag " + scan::quoted(this->Name));
    }
    if (matches(std::string_view(at, static_cast<std::size_t>(nameEnd - at))))
    {
      return std::string_view(quote + 1, static_cast<std::size_t>(close - quote - 1));
    }
    at = close + 1;
  }
  return std::nullopt;
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view name) const
{
  return this->findAttribute([name](std::string_view other) { return other == name; });
}

std::optional<std::string_view> XmlScanner::prefixedAttribute(std::string_view name) const
{
  return this->findAttribute(
    [name](std::string_view other) { return withoutPrefix(other) == name; });
}

void XmlScanner::fail(const std::string& what) const
{
  const auto passed = this->Buffer.begin() + static_cast<std::ptrdiff_t>(this->At);
  const auto lines =
    this->Lines + static_cast<std::size_t>(std::count(this->Buffer.begin(), passed, '\n'));
  this->Text.source().fail(
    "part " + quoted(this->Text.name()) + ", line " + std::to_string(lines + 1) + ": " + what);
}

} // namespace scan
