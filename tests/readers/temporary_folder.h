// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace scan::test
{

/// A folder of its own for a test, removed at the end.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "scan-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
    {
      throw std::runtime_error("no temporary folder");
    }
    this->Path = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(this->Path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (this->Path / name).string(); }

  std::size_t fileCount() const
  {
    return static_cast<std::size_t>(std::distance(
      std::filesystem::directory_iterator(this->Path), std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path Path;
};

inline std::string contentOf(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

inline void setContent(const std::string& path, const std::string& content)
{
  std::ofstream(path, std::ios::binary) << content;
}

} // namespace scan::test
