// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace scan
{

/// A file's bytes in memory, read-only. Regular files are mapped, not copied, standard input too
/// unless something was read from it; pipes and devices are read to their end.
///
/// Throws Error io when the file is missing, a directory or unreadable, Error parse when it is
/// empty. A mapped file must not be shortened by another program while it is in use.
class MappedFile
{
public:
  /// @param path "-" is standard input
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const char> bytes() const { return this->Bytes; }

  /// The path, or "standard input".
  const std::string& name() const { return this->Name; }

private:
  void readToEnd(int descriptor);
  [[noreturn]] void fail(const char* doing, int error) const;

  std::string Name;
  std::vector<char> Buffer; // empty when mapped
  std::span<const char> Bytes;
};

} // namespace scan
