// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "readers/source.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace scan
{

/// A part of a zip archive, as it is packed.
struct ZipPart
{
  std::span<const char> packed;
  std::uint64_t size = 0; ///< unpacked, as the file says
  std::uint32_t sum = 0;  ///< CRC-32
  bool isDeflated = false;
};

/// The directory of a zip archive, zip64 too. Throws Error parse for a malformed or truncated
/// archive; a part that is encrypted or packed by other means than deflate fails when asked for.
class ZipArchive
{
public:
  explicit ZipArchive(const Source& source);

  const Source& source() const { return this->Input; }

  bool has(const std::string& name) const { return this->Parts.contains(name); }

  /// The name of the first part, in the order of names, that ends so; empty without one.
  std::string firstThatEndsWith(std::string_view end) const;

  /// Throws Error parse for a part that is not there or cannot be read.
  ZipPart part(const std::string& name) const;

private:
  struct Entry
  {
    std::uint64_t offset = 0;
    std::uint64_t packed = 0;
    std::uint64_t size = 0;
    std::uint32_t sum = 0;
    std::uint16_t method = 0;
    std::uint16_t flags = 0;
  };

  const char* findDirectory(std::uint64_t& size) const;
  const char* readEntry(const char* at, const char* end);
  void readLargeSizes(const char* extra, std::size_t size, Entry& entry) const;

  const Source& Input;
  std::map<std::string, Entry> Parts;
};

/// Unpacks a part piece by piece, so that memory does not depend on what it unpacks to.
///
/// Throws Error parse for damaged data and, against archives that are made to exhaust a reader,
/// when all parts together unpack to more than 200 times the file and 64 MB.
class ZipStream
{
public:
  /// @param unpacked the bytes that all streams of an archive have unpacked
  ZipStream(const ZipArchive& archive, const std::string& name, std::uint64_t& unpacked);
  ~ZipStream();
  ZipStream(const ZipStream&) = delete;
  ZipStream& operator=(const ZipStream&) = delete;

  /// The next piece, valid until the next call; empty at the end of the part.
  std::span<const char> next();

  const std::string& name() const { return this->Name; }
  const Source& source() const { return this->Archive.source(); }

  /// The share of the file that lies in front of the next piece, in bytes.
  std::size_t position() const;

private:
  std::span<const char> inflateNext();
  void checkEnd() const;
  [[noreturn]] void fail(const std::string& what) const;

  struct State;
  const ZipArchive& Archive;
  std::string Name;
  ZipPart Part;
  std::uint64_t& Unpacked;
  std::uint64_t Size = 0;
  std::uint32_t Sum = 0;
  bool IsAtEnd = false;
  std::vector<char> Piece;
  std::unique_ptr<State> Inflate;
};

} // namespace scan
