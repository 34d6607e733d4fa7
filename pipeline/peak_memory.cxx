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

PeakMemory::PeakMemory()
{
  const int file = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  if (file >= 0)
  {
    // "5" resets the peak; a refusal leaves the peak of the whole run, which is what we promise
    [[maybe_unused]] const auto written = ::write(file, "5", 1);
    ::close(file);
  }
}

std::int64_t PeakMemory::bytes() const
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
