// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/output_file.h"

#include "filters/base/error.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace scan
{
namespace
{

constexpr std::size_t kBufferBytes = std::size_t(1) << 20U;

std::string randomSuffix()
{
  static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  std::random_device random;
  std::string suffix = ".part-";
  for (int i = 0; i < 6; ++i)
  {
    suffix += kLetters[random() % kLetters.size()];
  }
  return suffix;
}

} // namespace

OutputFile::OutputFile(const std::string& path)
  : Name(path == "-" ? "standard output" : path)
{
  this->Buffer.reserve(kBufferBytes);
  if (path == "-")
  {
    this->Descriptor = STDOUT_FILENO;
    return;
  }
  struct stat status = {};
  const bool isThere = ::stat(path.c_str(), &status) == 0;
  if (isThere && !S_ISREG(status.st_mode))
  {
    this->Descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (this->Descriptor < 0)
    {
      this->fail(errno);
    }
    return;
  }
  std::error_code ignored;
  const bool isLink = std::filesystem::is_symlink(path, ignored);
  this->Target = isLink ? std::filesystem::weakly_canonical(path, ignored).string() : path;
  if (isThere && ::access(this->Target.c_str(), W_OK) != 0)
  {
    this->fail(errno);
  }
  this->openPart();
  if (isThere && ::fchmod(this->Descriptor, status.st_mode & 07777U) != 0)
  {
    this->fail(errno);
  }
}

OutputFile::~OutputFile()
{
  if (this->Descriptor > STDERR_FILENO)
  {
    ::close(this->Descriptor);
  }
  if (!this->Part.empty())
  {
    ::unlink(this->Part.c_str());
  }
}

void OutputFile::openPart()
{
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  std::string part;
  do
  {
    part = this->Target + randomSuffix();
    this->Descriptor = ::open(part.c_str(), kFlags, 0666);
  } while (this->Descriptor < 0 && errno == EEXIST);
  if (this->Descriptor < 0)
  {
    this->fail(errno);
  }
  this->Part = part;
}

void OutputFile::flush()
{
  std::string_view rest(this->Buffer.data(), this->Buffer.size());
  while (!rest.empty())
  {
    const ssize_t written = ::write(this->Descriptor, rest.data(), rest.size());
    if (written < 0 && errno != EINTR)
    {
      this->fail(errno);
    }
    rest.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  this->Buffer.clear();
}

void OutputFile::commit()
{
  this->flush();
  if (this->Target.empty())
  {
    return;
  }
  if (::fsync(this->Descriptor) != 0 || ::rename(this->Part.c_str(), this->Target.c_str()) != 0)
  {
    this->fail(errno);
  }
  this->Part.clear();
}

void OutputFile::fail(int error) const
{
  const bool isFull = error == ENOSPC || error == EDQUOT || error == EFBIG;
  const std::string reason = error == EFBIG ? "the file is larger than the system allows"
    : isFull                                ? "disk full"
                                            : std::generic_category().message(error);
  const std::string advice =
    isFull ? "make room or choose another folder" : "check the name and the permissions";
  const std::string state = this->Target.empty() && this->Descriptor >= 0
    ? "the output is incomplete"
    : "nothing was written";
  throw Error(ErrorCode::io, this->Name + ": " + reason + "; " + advice + "; " + state);
}

} // namespace scan
