// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/peak_memory.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <string_view>

namespace scan
{

std::int64_t peakMemory()
{
  const int file = ::open("/proc/self/status", O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return 0;
  }
  std::array<char, 8192> buffer{};
  const auto size = ::read(file, buffer.data(), buffer.size());
  ::close(file);
  const std::string_view text(buffer.data(), size > 0 ? static_cast<std::size_t>(size) : 0);
  constexpr std::string_view kKey = "VmHWM:";
  const std::size_t key = text.find(kKey);
  const std::size_t digits = text.find_first_of("0123456789", key);
  std::int64_t kilobytes = 0;
  if (key != std::string_view::npos && digits != std::string_view::npos)
  {
    std::from_chars(text.data() + digits, text.data() + text.size(), kilobytes);
  }
  return kilobytes * 1024;
}

} // namespace scan
