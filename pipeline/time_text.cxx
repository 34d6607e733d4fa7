// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/time_text.h"

#include <sys/stat.h>

#include <ctime>

#include <array>

namespace scan
{

namespace
{

std::string textOf(std::time_t time)
{
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  std::array<char, 64> text{};
  return { text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc) };
}

} // namespace

std::string timeText()
{
  return textOf(std::time(nullptr));
}

std::string timeTextOfFile(const std::string& path)
{
  struct stat status = {};
  return ::stat(path.c_str(), &status) == 0 ? textOf(status.st_mtime) : std::string();
}

} // namespace scan
