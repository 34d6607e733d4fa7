// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "readers/zip_archive.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace scan
{

/// Goes through the tags of an XML document in UTF-8, piece by piece; text, comments and processing
/// instructions are passed over. Memory does not depend on the size of the document.
///
/// Throws Error parse, with the part and the line, for malformed tags, tags of more than 1 MB,
/// UTF-16 and document type declarations, so that entities never expand.
class XmlScanner
{
public:
  XmlScanner(ZipStream& text, Execution& execution);

  /// Moves to the next tag; false at the end. An empty element has a start and an end.
  bool next();

  bool isStart() const { return this->IsStart; }

  /// Without its prefix.
  std::string_view name() const { return this->Name; }

  /// The text of an attribute with just this name, as it stands in the file.
  std::optional<std::string_view> attribute(std::string_view name) const;

  /// The text of an attribute with this name behind any prefix.
  std::optional<std::string_view> prefixedAttribute(std::string_view name) const;

  [[noreturn]] void fail(const std::string& what) const;

private:
  bool refill();
  bool skipBehind(std::string_view end);
  bool hasAhead(std::string_view text);
  void readTag();
  template <class Matches>
  std::optional<std::string_view> findAttribute(const Matches& matches) const;

  ZipStream& Text;
  Execution& Run;
  std::string Buffer;
  std::size_t At = 0;    // behind the tag
  std::size_t Lines = 0; // ended in front of the buffer
  bool IsStart = false;
  bool IsEmpty = false; // its end is still to come
  std::string_view Name;
  std::string_view Attributes;
};

} // namespace scan
