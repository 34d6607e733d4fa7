// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/zip_writer.h"

#include "filters/base/error.h"
#include "writers/size_limit.h"

#include <zlib.h>

namespace scan
{
namespace
{

constexpr int kLevel = 4; // the largest that keeps up with the text on two threads
constexpr std::uint16_t kVersion = 20;
constexpr std::uint16_t kSizesFollow = 1U << 3U;
constexpr std::uint16_t kDeflated = 8;
constexpr std::uint16_t kTime = 0;
constexpr std::uint16_t kDate = 33; // 1980-01-01

std::uint32_t crcOf(std::string_view text)
{
  return static_cast<std::uint32_t>(
    crc32_z(0, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

} // namespace

std::size_t ZipBlock::bound(std::size_t textSize)
{
  return compressBound(textSize) + 64; // and the marks between blocks
}

void ZipBlock::deflate()
{
  this->sum = crcOf(this->text);
  z_stream stream = {};
  this->isLacking =
    deflateInit2(&stream, kLevel, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY) != Z_OK;
  if (this->isLacking)
  {
    return;
  }
  this->bytes.resize(bound(this->text.size()));
  stream.next_in = reinterpret_cast<Bytef*>(this->text.data());
  stream.avail_in = static_cast<uInt>(this->text.size());
  stream.next_out = reinterpret_cast<Bytef*>(this->bytes.data());
  stream.avail_out = static_cast<uInt>(this->bytes.size());
  ::deflate(&stream, Z_SYNC_FLUSH); // ends at a byte, so that pieces can be joined
  this->bytes.resize(this->bytes.size() - stream.avail_out);
  deflateEnd(&stream);
}

void ZipWriter::add(const std::string& name, std::string_view text)
{
  this->begin(name);
  ZipBlock block;
  block.text = text;
  block.deflate();
  this->append(block);
  this->end();
}

void ZipWriter::begin(const std::string& name)
{
  this->Entries.push_back({ name, this->Offset });
  this->put("PK\3\4");
  this->putHeader(this->Entries.back()); // the sizes are still 0
  this->putNumbers({ static_cast<std::uint16_t>(name.size()), 0 });
  this->put(name);
}

void ZipWriter::append(const ZipBlock& block)
{
  if (block.isLacking)
  {
    throw Error(ErrorCode::memory, this->File.name() + ": no memory to compress the file");
  }
  Entry& entry = this->Entries.back();
  entry.sum = static_cast<std::uint32_t>(
    crc32_combine(entry.sum, block.sum, static_cast<z_off_t>(block.text.size())));
  entry.size += block.text.size();
  entry.packed += block.bytes.size();
  this->put(block.bytes);
}

void ZipWriter::end()
{
  constexpr std::string_view kLastBlock("\3\0", 2); // an empty one
  Entry& entry = this->Entries.back();
  this->put(kLastBlock);
  entry.packed += kLastBlock.size();
  this->put("PK\7\10");
  this->putLong(entry.sum);
  this->putSize(entry.packed);
  this->putSize(entry.size);
}

void ZipWriter::finish()
{
  const std::uint64_t start = this->Offset;
  for (const Entry& entry : this->Entries)
  {
    this->put("PK\1\2");
    this->putNumbers({ kVersion });
    this->putHeader(entry);
    // no extra data, no comment, disk 0, no attributes
    this->putNumbers({ static_cast<std::uint16_t>(entry.name.size()), 0, 0, 0, 0, 0, 0 });
    this->putSize(entry.offset);
    this->put(entry.name);
  }
  const std::uint64_t size = this->Offset - start;
  const auto count = static_cast<std::uint16_t>(this->Entries.size());
  this->put("PK\5\6");
  this->putNumbers({ 0, 0, count, count });
  this->putSize(size);
  this->putSize(start);
  this->putNumbers({ 0 });
}

/// What the header of a part and its entry in the directory have in common.
void ZipWriter::putHeader(const Entry& entry)
{
  this->putNumbers({ kVersion, kSizesFollow, kDeflated, kTime, kDate });
  this->putLong(entry.sum);
  this->putSize(entry.packed);
  this->putSize(entry.size);
}

void ZipWriter::put(std::string_view bytes)
{
  this->File.write(bytes);
  this->Offset += bytes.size();
}

void ZipWriter::putNumbers(const std::vector<std::uint16_t>& numbers)
{
  for (const std::uint16_t number : numbers)
  {
    const char bytes[] = { static_cast<char>(number & 255U), static_cast<char>(number >> 8U) };
    this->put({ bytes, sizeof(bytes) });
  }
}

void ZipWriter::putSize(std::uint64_t size)
{
  this->putLong(
    fourBytes(size, this->File.name() + ": more than 4 GiB of text, the limit of this format"));
}

void ZipWriter::putLong(std::uint32_t number)
{
  this->putNumbers(
    { static_cast<std::uint16_t>(number & 0xffffU), static_cast<std::uint16_t>(number >> 16U) });
}

} // namespace scan
