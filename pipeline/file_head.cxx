// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/file_head.h"

#include "filters/base/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <system_error>

namespace scan
{

namespace
{

constexpr std::size_t kHeadBytes = 65536;

[[noreturn]] void fail(const std::string& name, int error)
{
  throw Error(ErrorCode::io, name + ": cannot be read: " + std::generic_category().message(error));
}

struct Descriptor
{
  int value = -1;
  explicit Descriptor(int descriptor)
    : value(descriptor)
  {
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor()
  {
    if (this->value >= 0)
    {
      ::close(this->value);
    }
  }
};

/// Reads from the descriptor's position, which it moves.
std::vector<char> readHead(int descriptor, const std::string& name)
{
  std::vector<char> head(kHeadBytes);
  std::size_t size = 0;
  while (size < head.size())
  {
    const ssize_t got = ::read(descriptor, head.data() + size, head.size() - size);
    if (got < 0)
    {
      fail(name, errno);
    }
    if (got == 0)
    {
      break;
    }
    size += static_cast<std::size_t>(got);
  }
  head.resize(size);
  return head;
}

void copyAll(int from, int to, const std::string& name, const CancelToken& token)
{
  std::array<char, kHeadBytes> buffer{};
  for (;;)
  {
    const ssize_t got = ::read(from, buffer.data(), buffer.size());
    if (token.cancelled())
    {
      throw Cancelled();
    }
    if (got == 0)
    {
      return;
    }
    if (got < 0 && errno != EINTR)
    {
      fail(name, errno);
    }
    for (ssize_t done = 0; done < got;)
    {
      const ssize_t put = ::write(to, buffer.data() + done, static_cast<std::size_t>(got - done));
      if (put < 0)
      {
        fail(name, errno);
      }
      done += put;
    }
  }
}

} // namespace

std::vector<char> headOfFile(const std::string& path)
{
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status = {};
  if (file.value < 0 || ::fstat(file.value, &status) != 0)
  {
    fail(path, errno);
  }
  if (!S_ISREG(status.st_mode))
  {
    throw Error(ErrorCode::io,
      path + ": is " + (S_ISDIR(status.st_mode) ? "a directory" : "no regular file") +
        "; give a file, or - for standard input");
  }
  return readHead(file.value, path);
}

std::vector<char> headOfStandardInput(const CancelToken& token)
{
  const std::string name = "standard input";
  struct stat status = {};
  if (::fstat(STDIN_FILENO, &status) != 0)
  {
    fail(name, errno);
  }
  if (!S_ISREG(status.st_mode))
  {
    const Descriptor memory(::memfd_create("standard-input", MFD_CLOEXEC));
    if (memory.value < 0)
    {
      fail(name, errno);
    }
    copyAll(STDIN_FILENO, memory.value, name, token);
    if (::dup2(memory.value, STDIN_FILENO) < 0)
    {
      fail(name, errno);
    }
    ::lseek(STDIN_FILENO, 0, SEEK_SET);
  }
  const off_t start = ::lseek(STDIN_FILENO, 0, SEEK_CUR);
  std::vector<char> head = readHead(STDIN_FILENO, name);
  ::lseek(STDIN_FILENO, start, SEEK_SET);
  return head;
}

} // namespace scan
