// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/zip_archive.h"

#include "filters/base/error.h"
#include "readers/little_endian.h"
#include "readers/text_scanner.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace scan
{
namespace
{

constexpr std::size_t kPieceSize = std::size_t(1) << 18U;
constexpr std::uint32_t kLarge32 = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint64_t kMostUnpacked = 200; // times the file; text of a mesh reaches about 30

constexpr std::size_t kEndSize = 22;
constexpr std::size_t kLocatorSize = 20;
constexpr std::size_t kLargeEndSize = 56;
constexpr std::size_t kEntrySize = 46;
constexpr std::size_t kHeaderSize = 30;

bool hasMark(const char* at, std::string_view mark)
{
  return std::string_view(at, mark.size()) == mark;
}

} // namespace

struct ZipStream::State
{
  z_stream stream = {};
};

ZipArchive::ZipArchive(const Source& source)
  : Input(source)
{
  std::uint64_t size = 0;
  const char* at = this->findDirectory(size);
  const char* const end = at + size;
  while (at != end)
  {
    at = this->readEntry(at, end);
  }
}

/// The directory, which lies in the file.
const char* ZipArchive::findDirectory(std::uint64_t& size) const
{
  constexpr std::size_t kLongestComment = 0xffff;
  const std::size_t fileSize = this->Input.bytes.size();
  const char* const begin = this->Input.begin();
  if (fileSize < kEndSize)
  {
    this->Input.fail("not a zip archive: the file is too short; it is truncated");
  }
  std::size_t end = fileSize - kEndSize;
  const std::size_t first = end - std::min(end, kLongestComment);
  while (end > first && !hasMark(begin + end, "PK\5\6"))
  {
    --end;
  }
  if (!hasMark(begin + end, "PK\5\6"))
  {
    this->Input.fail("no directory of a zip archive found; the file is truncated");
  }
  size = loadLittle<std::uint32_t>(begin + end + 12);
  std::uint64_t offset = loadLittle<std::uint32_t>(begin + end + 16);
  if (end >= kLocatorSize && hasMark(begin + end - kLocatorSize, "PK\6\7"))
  {
    const auto large = loadLittle<std::uint64_t>(begin + end - kLocatorSize + 8);
    if (large <= end && end - large >= kLargeEndSize && hasMark(begin + large, "PK\6\6"))
    {
      size = loadLittle<std::uint64_t>(begin + large + 40);
      offset = loadLittle<std::uint64_t>(begin + large + 48);
    }
  }
  if (offset > end || size > end - offset)
  {
    this->Input.fail("the directory of the zip archive lies beyond the file; it is truncated");
  }
  return begin + offset;
}

/// @return the end of the entry at `at`
const char* ZipArchive::readEntry(const char* at, const char* end)
{
  const auto left = static_cast<std::size_t>(end - at);
  if (left < kEntrySize || !hasMark(at, "PK\1\2"))
  {
    this->Input.failAtByte(at, "malformed directory of a zip archive");
  }
  const std::size_t nameSize = loadLittle<std::uint16_t>(at + 28);
  const std::size_t extraSize = loadLittle<std::uint16_t>(at + 30);
  const std::size_t size = kEntrySize + nameSize + extraSize + loadLittle<std::uint16_t>(at + 32);
  if (size > left)
  {
    this->Input.failAtByte(at, "malformed directory of a zip archive");
  }
  Entry entry;
  entry.flags = loadLittle<std::uint16_t>(at + 8);
  entry.method = loadLittle<std::uint16_t>(at + 10);
  entry.sum = loadLittle<std::uint32_t>(at + 16);
  entry.packed = loadLittle<std::uint32_t>(at + 20);
  entry.size = loadLittle<std::uint32_t>(at + 24);
  entry.offset = loadLittle<std::uint32_t>(at + 42);
  this->readLargeSizes(at + kEntrySize + nameSize, extraSize, entry);
  this->Parts.emplace(std::string(at + kEntrySize, nameSize), entry);
  return at + size;
}

/// The numbers of zip64, each there only when its short form is all ones.
void ZipArchive::readLargeSizes(const char* extra, std::size_t size, Entry& entry) const
{
  constexpr std::uint16_t kZip64 = 1;
  while (size >= 4)
  {
    const auto id = loadLittle<std::uint16_t>(extra);
    const std::size_t fieldSize =
      std::min<std::size_t>(loadLittle<std::uint16_t>(extra + 2), size - 4);
    const char* at = extra + 4;
    const char* const end = at + fieldSize;
    if (id == kZip64)
    {
      for (std::uint64_t* const number : { &entry.size, &entry.packed, &entry.offset })
      {
        if (*number == kLarge32 && end - at >= 8)
        {
          *number = loadLittle<std::uint64_t>(at);
          at += 8;
        }
      }
    }
    size -= 4 + fieldSize;
    extra = end;
  }
}

std::string ZipArchive::firstThatEndsWith(std::string_view end) const
{
  for (const auto& [name, entry] : this->Parts)
  {
    if (name.ends_with(end))
    {
      return name;
    }
  }
  return {};
}

ZipPart ZipArchive::part(const std::string& name) const
{
  const auto found = this->Parts.find(name);
  if (found == this->Parts.end())
  {
    this->Input.fail("the archive has no part " + scan::quoted(name) + "; it is incomplete");
  }
  const Entry& entry = found->second;
  constexpr unsigned kEncrypted = 1;
  constexpr std::uint16_t kStored = 0;
  constexpr std::uint16_t kDeflated = 8;
  if ((entry.flags & kEncrypted) != 0 || (entry.method != kStored && entry.method != kDeflated))
  {
    this->Input.fail("the part " + scan::quoted(name) +
      " is encrypted or packed by a method that is not read; save it with another program");
  }
  const std::size_t fileSize = this->Input.bytes.size();
  if (entry.offset > fileSize || fileSize - entry.offset < kHeaderSize ||
    !hasMark(this->Input.begin() + entry.offset, "PK\3\4"))
  {
    this->Input.fail("the part " + scan::quoted(name) + " is not where the directory says");
  }
  const char* const header = this->Input.begin() + entry.offset;
  const std::size_t skipped =
    kHeaderSize + loadLittle<std::uint16_t>(header + 26) + loadLittle<std::uint16_t>(header + 28);
  const std::size_t left = fileSize - entry.offset;
  if (skipped > left || entry.packed > left - skipped)
  {
    this->Input.fail(
      "the part " + scan::quoted(name) + " reaches beyond the file; it is truncated");
  }
  return { { header + skipped, entry.packed }, entry.size, entry.sum, entry.method == kDeflated };
}

ZipStream::ZipStream(const ZipArchive& archive, const std::string& name, std::uint64_t& unpacked)
  : Archive(archive)
  , Name(name)
  , Part(archive.part(name))
  , Unpacked(unpacked)
  , Inflate(std::make_unique<State>())
{
  if (this->Part.isDeflated)
  {
    this->Piece.resize(kPieceSize);
    if (inflateInit2(&this->Inflate->stream, -MAX_WBITS) != Z_OK)
    {
      throw Error(ErrorCode::memory, std::string(this->source().name) + ": no memory to unpack");
    }
  }
}

ZipStream::~ZipStream()
{
  if (this->Part.isDeflated)
  {
    inflateEnd(&this->Inflate->stream);
  }
}

std::span<const char> ZipStream::next()
{
  std::span<const char> piece;
  if (this->Part.isDeflated)
  {
    piece = this->inflateNext();
  }
  else
  {
    piece = this->Part.packed.first(std::min(kPieceSize, this->Part.packed.size()));
    this->Part.packed = this->Part.packed.subspan(piece.size());
  }
  this->Size += piece.size();
  this->Unpacked += piece.size();
  this->Sum = static_cast<std::uint32_t>(
    crc32_z(this->Sum, reinterpret_cast<const Bytef*>(piece.data()), piece.size()));
  if (this->Unpacked > kMostUnpacked * this->source().bytes.size() + (std::uint64_t(64) << 20U))
  {
    this->fail("unpacks to more than 200 times the size of the file; that is no model");
  }
  if (piece.empty())
  {
    this->checkEnd();
  }
  return piece;
}

std::span<const char> ZipStream::inflateNext()
{
  z_stream& stream = this->Inflate->stream;
  stream.next_out = reinterpret_cast<Bytef*>(this->Piece.data());
  stream.avail_out = static_cast<uInt>(this->Piece.size());
  while (!this->IsAtEnd && stream.avail_out > 0)
  {
    if (stream.avail_in == 0)
    {
      const std::span<const char> input =
        this->Part.packed.first(std::min(kPieceSize, this->Part.packed.size()));
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(input.data()));
      stream.avail_in = static_cast<uInt>(input.size());
      this->Part.packed = this->Part.packed.subspan(input.size());
    }
    const int result = ::inflate(&stream, Z_NO_FLUSH);
    this->IsAtEnd = result == Z_STREAM_END;
    if (result != Z_OK && result != Z_STREAM_END)
    {
      this->fail("is damaged or truncated");
    }
  }
  return { this->Piece.data(), this->Piece.size() - stream.avail_out };
}

void ZipStream::checkEnd() const
{
  if (this->Size != this->Part.size || this->Sum != this->Part.sum)
  {
    this->fail("is damaged: it does not unpack to what the directory says");
  }
}

std::size_t ZipStream::position() const
{
  return static_cast<std::size_t>(this->Part.packed.data() - this->source().begin());
}

void ZipStream::fail(const std::string& what) const
{
  this->source().fail("the part " + scan::quoted(this->Name) + " " + what);
}

} // namespace scan
