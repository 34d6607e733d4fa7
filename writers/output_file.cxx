// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/output_file.h"

#include "filters/base/error.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
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

/// NAME.part-XXXXXX beside the target; a long NAME is cut, the system's limit holds for the whole.
std::string partName(const std::string& target)
{
  static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  constexpr std::size_t kLongest = 200;
  const std::size_t name = target.rfind('/') + 1; // 0 without a folder
  std::random_device random;
  std::string part = target.substr(0, name) + target.substr(name, kLongest) + ".part-";
  for (int i = 0; i < 6; ++i)
  {
    part += kLetters[random() % kLetters.size()];
  }
  return part;
}

/// The parts with a name, for the handler of a signal.
struct PartSlot
{
  std::atomic<const OutputFile*> owner = nullptr;
  std::array<char, PATH_MAX> path = {};
};
std::array<PartSlot, 16> partSlots; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// A file without a name in the target's folder, which vanishes however the program ends; -1 where
/// the system has none.
int openUnnamed(const std::string& target)
{
  if (::access("/proc/self/fd", X_OK) != 0) // commit() needs it
  {
    return -1;
  }
  const std::string folder = target.substr(0, target.rfind('/') + 1) + ".";
  return ::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
}

} // namespace

OutputFile::OutputFile(const std::string& path, Part part)
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
  this->Target = behindLinks(path);
  if (this->Target.empty())
  {
    this->fail(ELOOP);
  }
  if (isThere && ::access(this->Target.c_str(), W_OK) != 0)
  {
    this->fail(errno);
  }
  this->openPart(part);
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
  if (!this->PartPath.empty())
  {
    ::unlink(this->PartPath.c_str());
    this->setPart({});
  }
}

void OutputFile::removeParts() noexcept
{
  for (const PartSlot& slot : partSlots)
  {
    if (slot.owner.load() != nullptr)
    {
      ::unlink(slot.path.data());
    }
  }
}

/// Remembers the part under its name, or that it has none any more.
void OutputFile::setPart(const std::string& path)
{
  const OutputFile* const owner = path.empty() ? this : nullptr; // of the slot that is wanted
  const auto slot = std::ranges::find_if(
    partSlots, [&](const PartSlot& candidate) { return candidate.owner.load() == owner; });
  if (slot != partSlots.end() && path.size() < slot->path.size())
  {
    if (!path.empty())
    {
      slot->path[path.copy(slot->path.data(), slot->path.size() - 1)] = '\0';
    }
    slot->owner.store(path.empty() ? nullptr : this);
  }
  this->PartPath = path;
}

void OutputFile::openPart(Part kind)
{
  this->Descriptor = kind == Part::unnamed ? openUnnamed(this->Target) : -1;
  if (this->Descriptor >= 0)
  {
    return;
  }
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC;
  std::string part;
  do
  {
    part = partName(this->Target);
    this->Descriptor = ::open(part.c_str(), kFlags, 0666);
  } while (this->Descriptor < 0 && errno == EEXIST);
  if (this->Descriptor < 0)
  {
    this->fail(errno);
  }
  this->setPart(part);
}

void OutputFile::namePart()
{
  const std::string self = "/proc/self/fd/" + std::to_string(this->Descriptor);
  std::string part;
  int status = 0;
  do
  {
    part = partName(this->Target);
    status = ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, part.c_str(), AT_SYMLINK_FOLLOW);
  } while (status != 0 && errno == EEXIST);
  if (status != 0)
  {
    this->fail(errno);
  }
  this->setPart(part);
}

void OutputFile::flush()
{
  this->writeOut({ this->Buffer.data(), this->Buffer.size() });
  this->Buffer.clear();
}

void OutputFile::writeOut(std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t written = ::write(this->Descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR)
    {
      this->fail(errno);
    }
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
}

void OutputFile::commit()
{
  this->flush();
  if (this->Target.empty())
  {
    return;
  }
  if (::fsync(this->Descriptor) != 0)
  {
    this->fail(errno);
  }
  if (this->PartPath.empty())
  {
    this->namePart();
  }
  if (::rename(this->PartPath.c_str(), this->Target.c_str()) != 0)
  {
    this->fail(errno);
  }
  this->setPart({});
}

void OutputFile::fail(int error) const
{
  const bool isFull = error == ENOSPC || error == EDQUOT || error == EFBIG;
  const bool isDirect = this->Target.empty() && this->Descriptor >= 0;
  const std::string reason = error == EFBIG ? "the file is larger than the system allows"
    : isFull                                ? "disk full"
    : error == EPIPE                        ? "the program that reads it has ended"
    : error == EBADF && isDirect            ? "is closed or cannot be written"
                                            : std::generic_category().message(error);
  const std::string advice = isFull ? "make room or choose another folder"
    : isDirect                      ? "give -o another file"
                                    : "check the name and the permissions";
  const std::string state = isDirect ? "the output is incomplete" : "nothing was written";
  throw Error(ErrorCode::io, this->Name + ": " + reason + "; " + advice + "; " + state);
}

std::string behindLinks(const std::string& path)
{
  constexpr int kMostLinks = 40;
  std::filesystem::path target = path;
  std::error_code status;
  for (int i = 0; i < kMostLinks; ++i)
  {
    const std::filesystem::path next = std::filesystem::read_symlink(target, status);
    if (status)
    {
      return target.string();
    }
    target = target.parent_path() / next;
  }
  return {};
}

} // namespace scan
