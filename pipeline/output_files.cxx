// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/output_files.h"

#include "filters/base/error.h"
#include "writers/output_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace scan
{

void checkOutput(const std::string& path, bool mayReplace)
{
  if (path == "-")
  {
    return;
  }
  if (path.empty())
  {
    throw Error(ErrorCode::badParameter, "an output has an empty name; give -o a file");
  }
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0)
  {
    if (S_ISDIR(status.st_mode))
    {
      throw Error(ErrorCode::badParameter, path + ": is a directory; name a file in it");
    }
    if (S_ISREG(status.st_mode) && !mayReplace)
    {
      throw Error(
        ErrorCode::badParameter, path + ": exists already; choose another name or add --overwrite");
    }
    if (::access(path.c_str(), W_OK) != 0)
    {
      throw Error(ErrorCode::badParameter,
        path + ": cannot be replaced: " + std::generic_category().message(errno));
    }
    if (!S_ISREG(status.st_mode))
    {
      return; // devices and pipes are written in place
    }
  }
  else if (errno == ENAMETOOLONG || errno == ELOOP)
  {
    throw Error(ErrorCode::badParameter,
      path + ": cannot be a file: " + std::generic_category().message(errno) +
        "; choose another name");
  }
  const std::filesystem::path parent = std::filesystem::path(behindLinks(path)).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
  {
    throw Error(ErrorCode::badParameter,
      path + ": cannot write into the folder " + folder + ": " +
        std::generic_category().message(errno));
  }
}

bool isSameFile(const std::string& a, const std::string& b)
{
  if (a == b || a == "-" || b == "-")
  {
    return a == b;
  }
  std::error_code ignored;
  const auto place = [&](const std::string& path)
  {
    return std::filesystem::weakly_canonical(
      std::filesystem::absolute(behindLinks(path), ignored), ignored);
  };
  return std::filesystem::equivalent(a, b, ignored) || place(a) == place(b);
}

void removeUnfinishedOutputs() noexcept
{
  OutputFile::removeParts();
}

void writeText(const std::string& path, std::string_view text)
{
  OutputFile file(path);
  file.write(text);
  file.commit();
}

} // namespace scan
