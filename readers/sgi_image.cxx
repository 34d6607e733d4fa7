// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/sgi_image.h"

#include "readers/source.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kHeaderBytes = 512;
constexpr std::uint32_t kMagic = 474;
constexpr std::size_t kPixelsAlways = (std::size_t(64) << 20U) / sizeof(Color);
constexpr std::size_t kPixelsPerByte = 20 / sizeof(Color);

std::uint32_t bigEndian(const char* at, int width)
{
  std::uint32_t value = 0;
  for (int i = 0; i < width; ++i)
  {
    value = value << 8U | static_cast<unsigned char>(at[i]);
  }
  return value;
}

/// Decodes the rows of the channels into an image.
class SgiReader
{
public:
  explicit SgiReader(const Source& source)
    : Data(source)
  {
  }

  SgiImage read()
  {
    this->readHeader();
    this->Image.pixels.resize(this->Image.width * this->Image.height);
    // two channels are grey and alpha
    const std::size_t used = this->Channels >= 3 ? 3 : 1;
    for (std::size_t channel = 0; channel < used; ++channel)
    {
      for (std::size_t row = 0; row < this->Image.height; ++row)
      {
        this->readRow(row, channel);
      }
    }
    if (used == 1)
    {
      for (Color& pixel : this->Image.pixels)
      {
        pixel[1] = pixel[2] = pixel[0];
      }
    }
    return std::move(this->Image);
  }

private:
  void readHeader()
  {
    if (!looksLikeSgiImage(this->Data.bytes))
    {
      this->Data.fail("this is no SGI image, which starts with the bytes 01 da");
    }
    if (this->Data.bytes.size() < kHeaderBytes)
    {
      this->failAtEnd();
    }
    const char* const begin = this->Data.begin();
    this->IsEncoded = begin[2] == 1;
    if (begin[2] != 0 && begin[2] != 1)
    {
      this->Data.failAtByte(begin + 2, "unknown storage of the pixels; save the image anew");
    }
    if (begin[3] != 1)
    {
      this->Data.failAtByte(
        begin + 3, "only one byte a channel is read; save the image with 8 bits a channel");
    }
    if (bigEndian(begin + 104, 4) != 0)
    {
      this->Data.failAtByte(
        begin + 104, "images with a colour map are not read; save the image as RGB");
    }
    const std::uint32_t dimension = bigEndian(begin + 4, 2);
    this->Image.width = bigEndian(begin + 6, 2);
    this->Image.height = dimension >= 2 ? bigEndian(begin + 8, 2) : 1;
    this->Channels = dimension >= 3 ? bigEndian(begin + 10, 2) : 1;
    this->checkSize();
  }

  void checkSize() const
  {
    const std::size_t pixels = this->Image.width * this->Image.height;
    if (pixels == 0 || this->Channels == 0)
    {
      this->Data.failAtByte(this->Data.begin() + 6, "the image has no pixels; save it anew");
    }
    const std::size_t body = this->Data.bytes.size() - kHeaderBytes;
    const std::size_t rows = this->Image.height * this->Channels;
    const std::size_t least = this->IsEncoded ? 8 * rows : pixels * this->Channels;
    if (least > body)
    {
      this->failAtEnd();
    }
    if (pixels > kPixelsAlways + this->Data.bytes.size() * kPixelsPerByte)
    {
      this->Data.fail("an image of " + std::to_string(this->Image.width) + " x " +
        std::to_string(this->Image.height) + " pixels in a file of " +
        std::to_string(this->Data.bytes.size()) + " bytes; it is damaged");
    }
  }

  void readRow(std::size_t row, std::size_t channel)
  {
    const std::size_t index = channel * this->Image.height + row;
    Color* const pixels = this->Image.pixels.data() + row * this->Image.width;
    if (this->IsEncoded)
    {
      this->decodeRow(index, pixels, channel);
      return;
    }
    const char* const at = this->Data.begin() + kHeaderBytes + index * this->Image.width;
    for (std::size_t i = 0; i < this->Image.width; ++i)
    {
      pixels[i][channel] = static_cast<std::uint8_t>(at[i]);
    }
  }

  void decodeRow(std::size_t index, Color* pixels, std::size_t channel)
  {
    const std::size_t rows = this->Image.height * this->Channels;
    const char* const entry = this->Data.begin() + kHeaderBytes + 4 * index;
    const std::size_t start = bigEndian(entry, 4);
    const std::size_t length = bigEndian(entry + 4 * rows, 4);
    if (start > this->Data.bytes.size() || length > this->Data.bytes.size() - start)
    {
      this->failAtEnd();
    }
    const char* at = this->Data.begin() + start;
    const char* const end = at + length;
    std::size_t filled = 0;
    while (at != end && (*at & 0x7f) != 0)
    {
      const bool isLiteral = (*at & 0x80) != 0;
      const auto count = static_cast<std::size_t>(*at & 0x7f);
      const char* const values = at + 1;
      const std::ptrdiff_t stored = isLiteral ? static_cast<std::ptrdiff_t>(count) : 1;
      if (stored > end - values || count > this->Image.width - filled)
      {
        this->failAtRow(at);
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        pixels[filled++][channel] = static_cast<std::uint8_t>(values[isLiteral ? i : 0]);
      }
      at = values + stored;
    }
    if (filled != this->Image.width)
    {
      this->failAtRow(at);
    }
  }

  [[noreturn]] void failAtRow(const char* at) const
  {
    this->Data.failAtByte(at, "a run-length encoded row does not fit the width; it is damaged");
  }

  [[noreturn]] void failAtEnd() const
  {
    this->Data.fail("the image ends too early; it is truncated");
  }

  const Source& Data;
  bool IsEncoded = false;
  std::size_t Channels = 0;
  SgiImage Image;
};

} // namespace

SgiImage parseSgiImage(std::span<const char> bytes, std::string_view name)
{
  const Source source{ name, bytes };
  return SgiReader(source).read();
}

bool looksLikeSgiImage(std::span<const char> head)
{
  return head.size() >= 4 && bigEndian(head.data(), 2) == kMagic && (head[2] == 0 || head[2] == 1);
}

} // namespace scan
