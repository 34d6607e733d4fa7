// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "writers/output_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// A piece of a compressed part; pieces can be made on several threads.
struct ZipBlock
{
  std::string text;       ///< what the piece holds
  std::string bytes;      ///< what it becomes
  std::uint32_t sum = 0;  ///< CRC-32 of the text
  bool isLacking = false; ///< no memory

  /// Compresses the text; never throws when `bytes` has room for bound(text.size()).
  void deflate();

  static std::size_t bound(std::size_t textSize);
};

/// Writes the parts of a zip archive, all from 1980-01-01 0:00, so that the same parts give the
/// same bytes. Throws Error limit for 4 GiB and Error memory.
class ZipWriter
{
public:
  explicit ZipWriter(OutputFile& file)
    : File(file)
  {
  }

  /// A part in one piece.
  void add(const std::string& name, std::string_view text);

  /// A part in several pieces: begin, append for each, end.
  void begin(const std::string& name);
  void append(const ZipBlock& block);
  void end();

  /// The directory, behind all parts.
  void finish();

private:
  struct Entry
  {
    std::string name;
    std::uint64_t offset = 0;
    std::uint64_t packed = 0;
    std::uint64_t size = 0;
    std::uint32_t sum = 0;
  };

  void put(std::string_view bytes);
  void putNumbers(const std::vector<std::uint16_t>& numbers);
  void putLong(std::uint32_t number);
  void putSize(std::uint64_t size);
  void putHeader(const Entry& entry);

  OutputFile& File;
  std::vector<Entry> Entries;
  std::uint64_t Offset = 0;
};

} // namespace scan
