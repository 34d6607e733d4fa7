// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/sgi_image.h"

#include "tests/readers/cyberware_files.h"
#include "tests/readers/parsing.h"
#include "tests/readers/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace
{

using scan::Color;
using scan::SgiImage;
using scan::test::appendInteger;

SgiImage read(std::span<const char> bytes, std::string_view name, scan::Execution&)
{
  return scan::parseSgiImage(bytes, name);
}

SgiImage parse(const std::string& bytes)
{
  return scan::test::parse(read, bytes);
}

std::string error(const std::string& bytes)
{
  return scan::test::parseError(read, bytes);
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

std::string header(bool isEncoded, int dimension, int width, int height, int channels)
{
  std::string bytes = "\x01\xda";
  bytes += static_cast<char>(isEncoded);
  bytes += '\1';
  for (const int value : { dimension, width, height, channels })
  {
    appendInteger(bytes, value, 2, true);
  }
  appendInteger(bytes, 0, 4, true);
  appendInteger(bytes, 255, 4, true);
  return bytes.append(512 - bytes.size(), '\0');
}

/// Run-length encoded rows, all channels of the lowest row first in the tables' order.
std::string encoded(int width, int height, int channels, const std::vector<std::string>& rows)
{
  std::string bytes = header(true, 3, width, height, channels);
  std::string data;
  std::string lengths;
  for (const std::string& row : rows)
  {
    appendInteger(bytes, static_cast<std::int64_t>(512 + 8 * rows.size() + data.size()), 4, true);
    appendInteger(lengths, static_cast<std::int64_t>(row.size()), 4, true);
    data += row;
  }
  return bytes + lengths + data;
}

const std::vector<Color> kPixels = { { 1, 11, 21 }, { 2, 12, 22 }, { 3, 13, 23 }, { 4, 14, 24 },
  { 4, 14, 24 }, { 4, 14, 24 } };
const std::string kPlanes = "\1\2\3\4\4\4\13\14\15\16\16\16\25\26\27\30\30\30";
const std::string kEncoded = encoded(3, 2, 3,
  { "\x83\1\2\3", "\3\4", { "\x81\13\x82\14\15\0", 6 }, { "\1\16\2\16\0", 5 }, "\x83\25\26\27",
    { "\3\30\0\7\7", 5 } });

} // namespace

TEST(SgiImage, ReadsRawAndEncodedPixels)
{
  for (const std::string& bytes : { header(false, 3, 3, 2, 3) + kPlanes, kEncoded })
  {
    const SgiImage image = parse(bytes);
    EXPECT_EQ(image.width, 3U);
    EXPECT_EQ(image.height, 2U);
    EXPECT_EQ(image.pixels, kPixels);
    EXPECT_TRUE(scan::looksLikeSgiImage(bytes));
  }
}

TEST(SgiImage, ReadsWhatAnotherProgramWrites)
{
  const scan::test::TemporaryFolder folder;
  if (std::system("convert -version > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "the program convert of ImageMagick is missing";
  }
  // a picture from its highest row; long runs and rows without any
  std::string text = "P3 300 20 255\n";
  std::vector<Color> pixels(6000);
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    const std::size_t value = i / 300 < 10 ? i / 150 : i * 7919;
    const Color color = { static_cast<std::uint8_t>(value), static_cast<std::uint8_t>(value / 3),
      static_cast<std::uint8_t>(255 - value % 256) };
    pixels[(19 - i / 300) * 300 + i % 300] = color;
    for (const int channel : color)
    {
      text += std::to_string(channel) + "\n";
    }
  }
  scan::test::setContent(folder.file("a.ppm"), text);
  for (const std::string kind : { "None", "RLE" })
  {
    const std::string command =
      "convert " + folder.file("a.ppm") + " -compress " + kind + " sgi:" + folder.file("a.sgi");
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(parse(scan::test::contentOf(folder.file("a.sgi"))).pixels, pixels) << kind;
  }
}

TEST(SgiImage, ReadsEveryNumberOfChannels)
{
  const std::vector<Color> grey = { { 5, 5, 5 }, { 6, 6, 6 } };
  EXPECT_EQ(parse(header(false, 1, 2, 9, 9) + "\5\6").pixels, grey);
  EXPECT_EQ(parse(header(false, 2, 1, 2, 9) + "\5\6").pixels, grey);
  EXPECT_EQ(parse(header(false, 3, 2, 1, 2) + "\5\6\7\7").pixels, grey);
  EXPECT_EQ(
    parse(header(false, 3, 1, 1, 4) + "\1\2\3\4").pixels, (std::vector<Color>{ { 1, 2, 3 } }));
}

TEST(SgiImage, ExplainsWhatItDoesNotRead)
{
  const auto with = [](std::size_t at, char value)
  {
    std::string bytes = header(false, 3, 3, 2, 3) + kPlanes;
    bytes[at] = value;
    return bytes;
  };
  EXPECT_TRUE(contains(error(with(0, 'P')), "no SGI image"));
  EXPECT_TRUE(contains(error(with(2, 2)), "no SGI image"));
  EXPECT_TRUE(contains(error(with(3, 2)), "byte 3: only one byte a channel"));
  EXPECT_TRUE(contains(error(with(107, 1)), "byte 104: images with a colour map"));
  EXPECT_TRUE(contains(error(with(7, 0)), "no pixels"));
  EXPECT_TRUE(contains(error(with(11, 0)), "no pixels"));
  EXPECT_TRUE(contains(error(with(6, 9)), "truncated"));
  EXPECT_TRUE(contains(error(kEncoded.substr(0, 511)), "truncated"));
}

TEST(SgiImage, RefusesRowsThatDoNotFit)
{
  EXPECT_TRUE(contains(error(encoded(3, 1, 1, { "\4\1" })), "does not fit the width"));
  EXPECT_TRUE(contains(error(encoded(3, 1, 1, { "\2\1" })), "does not fit the width"));
  EXPECT_TRUE(contains(error(encoded(3, 1, 1, { "\x83\1\2" })), "does not fit the width"));
  EXPECT_TRUE(contains(error(encoded(3, 1, 1, { "\x83\1\2\3" }).substr(0, 522)), "truncated"));
}

TEST(SgiImage, TakesNoMemoryForAnImageThatTheFileCannotHold)
{
  // every row refers to the same few bytes
  std::string bytes = header(true, 2, 65535, 65535, 1);
  bytes.append(8 * std::size_t(65535), '\0');
  EXPECT_TRUE(contains(error(bytes), "65535 x 65535 pixels"));
}

TEST(SgiImage, EndsInErrorOrImageWhateverTheBytes)
{
  for (const std::string& bytes : { header(false, 3, 3, 2, 3) + kPlanes, kEncoded })
  {
    for (std::size_t size = 0; size + 2 < bytes.size(); ++size)
    {
      EXPECT_NE(error(bytes.substr(0, size)), "") << "cut at " << size;
    }
    for (std::size_t at = 0; at < bytes.size(); ++at)
    {
      for (const int flip : { 0x01, 0x80, 0xff })
      {
        std::string changed = bytes;
        changed[at] = static_cast<char>(changed[at] ^ flip);
        EXPECT_NE(error(changed), "not a parse error");
      }
    }
  }
}
