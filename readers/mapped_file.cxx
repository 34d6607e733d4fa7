// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/mapped_file.h"

#include "filters/base/error.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scan
{
namespace
{

struct Descriptor
{
  int value = -1;

  ~Descriptor()
  {
    if (this->value > STDERR_FILENO)
    {
      ::close(this->value);
    }
  }
};

} // namespace

MappedFile::MappedFile(const std::string& path)
  : Name(path == "-" ? "standard input" : path)
{
  const Descriptor file{ path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC) };
  struct stat status = {};
  if (file.value < 0 || ::fstat(file.value, &status) != 0)
  {
    this->fail("cannot be opened", errno);
  }
  if (S_ISDIR(status.st_mode))
  {
    this->fail("cannot be opened", EISDIR);
  }
  const bool isAtStart = path != "-" || ::lseek(STDIN_FILENO, 0, SEEK_CUR) == 0;
  if (S_ISREG(status.st_mode) && isAtStart)
  {
    const auto size = static_cast<std::size_t>(status.st_size);
    void* const memory =
      size > 0 ? ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.value, 0) : nullptr;
    if (memory == MAP_FAILED)
    {
      this->fail("cannot be read", errno);
    }
    this->Bytes = { static_cast<const char*>(memory), size };
  }
  else
  {
    this->readToEnd(file.value);
  }
  if (this->Bytes.empty())
  {
    throw Error(ErrorCode::parse, this->Name + " is empty");
  }
}

MappedFile::~MappedFile()
{
  if (this->Buffer.empty())
  {
    ::munmap(const_cast<char*>(this->Bytes.data()), this->Bytes.size());
  }
}

void MappedFile::readToEnd(int descriptor)
{
  constexpr std::size_t kStep = std::size_t(1) << 20U;
  std::size_t used = 0;
  for (;;)
  {
    if (this->Buffer.size() - used < kStep)
    {
      this->Buffer.resize(this->Buffer.size() * 2 + kStep);
    }
    const ssize_t got = ::read(descriptor, this->Buffer.data() + used, this->Buffer.size() - used);
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got < 0)
    {
      this->fail("cannot be read", errno);
    }
    if (got == 0)
    {
      break;
    }
    used += static_cast<std::size_t>(got);
  }
  this->Bytes = { this->Buffer.data(), used };
}

void MappedFile::fail(const char* doing, int error) const
{
  throw Error(ErrorCode::io,
    this->Name + " " + doing + ": " + std::generic_category().message(error) +
      "; check the name and the permissions");
}

} // namespace scan
