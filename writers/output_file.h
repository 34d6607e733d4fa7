// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// A file that appears under its name only when it is complete.
///
/// Bytes go, in large blocks, to a file without a name in the target's folder, which vanishes even
/// when the program is killed; where the system has no such files, to NAME.part-XXXXXX, which the
/// destructor and removeParts() remove. commit() makes them durable and gives them the name;
/// without it a target that was there stays as it was. A target's permissions and symbolic links
/// are kept. "-" is standard output; it and devices and pipes are written directly.
///
/// Every function but the destructor throws Error io: missing folder, no permission, disk full.
class OutputFile
{
public:
  enum class Part
  {
    unnamed, ///< where the system has such files
    named
  };

  explicit OutputFile(const std::string& path, Part part = Part::unnamed);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes)
  {
    if (bytes.size() > this->Buffer.capacity() - this->Buffer.size())
    {
      this->flush();
      if (bytes.size() >= this->Buffer.capacity())
      {
        this->writeOut(bytes);
        return;
      }
    }
    this->Buffer.insert(this->Buffer.end(), bytes.begin(), bytes.end());
  }

  /// Once, after the last write.
  void commit();

  /// The path, or "standard output".
  const std::string& name() const { return this->Name; }

  /// Removes the parts with a name of all files of the program, which ends. Async-signal-safe.
  static void removeParts() noexcept;

private:
  void openPart(Part kind);
  void namePart();
  void setPart(const std::string& path);
  void flush();
  void writeOut(std::string_view bytes);
  [[noreturn]] void fail(int error) const;

  std::string Name;
  std::string Target;   // behind symbolic links; empty when written directly
  std::string PartPath; // while the part exists under this name
  int Descriptor = -1;
  std::vector<char> Buffer;
};

/// The file behind symbolic links, whether it exists or not; empty for links in a circle.
std::string behindLinks(const std::string& path);

} // namespace scan
