// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/cyberware_header.h"

#include "readers/text_scanner.h"

#include <charconv>
#include <optional>
#include <string>
#include <system_error>

namespace scan
{
namespace
{

constexpr std::size_t kLongestHeader = 4096;
constexpr std::size_t kShortestBinary = 114;
constexpr std::int64_t kMostSamples = 32767; // along an axis: the counts were 16 bits wide
constexpr std::int64_t kLongestStep = 0x7fffffff;
constexpr int kLargestShift = 16;

std::string_view headText(std::span<const char> bytes)
{
  return { bytes.data(), std::min(bytes.size(), kLongestHeader) };
}

/// A 16 or 32 bit number at an offset; the caller knows that it is there.
std::int64_t integerAt(std::span<const char> bytes, std::size_t offset, int width, bool isBig)
{
  std::uint32_t value = 0;
  for (int i = 0; i < width; ++i)
  {
    const std::size_t place = offset + static_cast<std::size_t>(isBig ? i : width - 1 - i);
    value = value << 8U | static_cast<unsigned char>(bytes[place]);
  }
  return width == 2 ? static_cast<std::int16_t>(static_cast<std::uint16_t>(value))
                    : static_cast<std::int32_t>(value);
}

/// The size of the binary header, which it gives itself; 0 when there is none.
std::size_t binarySize(std::span<const char> bytes, bool isBig)
{
  const std::int64_t size = bytes.size() >= 8 ? integerAt(bytes, 4, 4, isBig) : 0;
  return size == 114 || size == 122 || size == 128 ? static_cast<std::size_t>(size) : 0;
}

/// The test that Cyberware's own programs made: the r of "Cyberware", which is also the size 114.
bool isPortable(std::span<const char> bytes)
{
  return bytes.size() > 4 && bytes[4] == 'r' && binarySize(bytes, false) == 0;
}

/// Where something stands that a message is about, and how it is called.
struct Place
{
  const char* at = nullptr;
  bool isLine = true;
};

/// Checks values on their way into the header.
class HeaderReader
{
public:
  explicit HeaderReader(const Source& source)
    : Input(source)
  {
  }

  CyberwareHeader read()
  {
    if (isPortable(this->Input.bytes))
    {
      this->readLines();
    }
    else
    {
      this->readStruct();
    }
    if (this->Result.space == CyberwareSpace::bilateral && this->Result.latitudes % 2 != 0)
    {
      this->Input.fail("a bilateral map has two halves, but the header gives an odd number of "
                       "latitudes; it is damaged");
    }
    return this->Result;
  }

private:
  void readLines()
  {
    this->Text = headText(this->Input.bytes);
    this->Text = this->Text.substr(0, this->findData());
    CyberwareHeader& header = this->Result;
    header.latitudes = this->required("NLT", 1, kMostSamples);
    header.longitudes = this->required("NLG", 1, kMostSamples);
    header.latitudeStep = this->required("LTINCR", 1, kLongestStep);
    header.longitudeStep = this->required("LGINCR", 1, kLongestStep);
    header.shift = static_cast<int>(this->required("RSHIFT", 0, kLargestShift));
    const std::int64_t top = header.latitudes - 1;
    const std::int64_t right = header.longitudes - 1;
    header.firstLatitude = this->chosen("LTMIN", 0, top, 0);
    header.lastLatitude = this->chosen("LTMAX", header.firstLatitude, top, top);
    header.firstLongitude = this->chosen("LGMIN", 0, right, 0);
    header.lastLongitude = this->chosen("LGMAX", header.firstLongitude, right, right);
    header.isInsideOut = this->find("INSIDE_OUT").has_value();
    header.isRightHanded = this->find("THETA_RIGHTHAND").has_value();
    this->readSpace();
  }

  /// The place of the line DATA=; notes where the samples start.
  std::size_t findData()
  {
    for (const std::string_view mark : { "\nDATA=\n", "\nDATA=\r\n" })
    {
      const std::size_t found = this->Text.find(mark);
      if (found != std::string_view::npos)
      {
        this->Result.size = found + mark.size();
        return found + 1;
      }
    }
    this->Input.fail("no line 'DATA=' in the first 4096 bytes; this is no complete Cyberware file");
  }

  /// The value of the first line "key=value"; the first line of all holds no key.
  std::optional<std::string_view> find(std::string_view key) const
  {
    const std::string start = std::string("\n").append(key).append("=");
    const std::size_t found = this->Text.find(start);
    if (found == std::string_view::npos)
    {
      return std::nullopt;
    }
    const char* const end = this->Text.data() + this->Text.size();
    const char* const value = skipBlanks(this->Text.data() + found + start.size(), end);
    const char* stop = findLineEnd(value, end);
    while (stop != value && isBlank(stop[-1]))
    {
      --stop;
    }
    return std::string_view(value, static_cast<std::size_t>(stop - value));
  }

  std::int64_t required(const char* key, std::int64_t least, std::int64_t most) const
  {
    const std::optional<std::string_view> value = this->find(key);
    if (!value)
    {
      this->Input.fail(
        "the header lacks the line " + std::string(key) + "=; this is no complete Cyberware file");
    }
    return this->number(key, *value, least, most);
  }

  std::int64_t chosen(
    const char* key, std::int64_t least, std::int64_t most, std::int64_t otherwise) const
  {
    const std::optional<std::string_view> value = this->find(key);
    return value ? this->number(key, *value, least, most) : otherwise;
  }

  std::int64_t number(
    const char* key, std::string_view text, std::int64_t least, std::int64_t most) const
  {
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end)
    {
      this->Input.failAtLine(
        text.data(), std::string(key) + " must be a whole number, not " + quoted(text));
    }
    return this->checked(key, { text.data(), true }, value, least, most);
  }

  void readSpace()
  {
    const std::string_view space = this->find("SPACE").value_or("CYLINDRICAL");
    if (space == "CARTESIAN")
    {
      this->Result.space = CyberwareSpace::cartesian;
    }
    else if (space == "BILATERAL")
    {
      this->Result.space = CyberwareSpace::bilateral;
    }
    else if (space != "CYLINDRICAL")
    {
      this->Input.failAtLine(
        space.data(), "SPACE must be CYLINDRICAL, CARTESIAN or BILATERAL, not " + quoted(space));
    }
  }

  void readStruct()
  {
    CyberwareHeader& header = this->Result;
    header.isBigEndian = binarySize(this->Input.bytes, true) != 0;
    header.size = binarySize(this->Input.bytes, header.isBigEndian);
    if (header.size == 0)
    {
      this->Input.fail("no Cyberware header found; such a file starts with "
                       "'Cyberware Digitizer Data' or an older binary header");
    }
    if (this->Input.bytes.size() < header.size)
    {
      this->Input.fail("the file ends inside its header of " + std::to_string(header.size) +
        " bytes; it is truncated");
    }
    // the struct was written as the compiler had laid it out: 128 bytes where it aligned to four
    const std::size_t gap = header.size == 128 ? 2 : 0;
    header.latitudes = this->field("NLT", 58, 2, 1, kMostSamples);
    header.longitudes = this->field("NLG", 60, 2, 1, kMostSamples);
    header.shift = static_cast<int>(this->field("RSHIFT", 62, 2, 0, kLargestShift));
    header.latitudeStep = this->field("LTINCR", 70 + gap, 4, 1, kLongestStep);
    header.longitudeStep = this->field("LGINCR", 74 + gap, 4, 1, kLongestStep);
    this->readFlags(integerAt(this->Input.bytes, 66 + gap, 4, header.isBigEndian));
    this->readWindow(90 + gap);
  }

  std::int64_t field(
    const char* key, std::size_t offset, int width, std::int64_t least, std::int64_t most) const
  {
    const std::int64_t value =
      integerAt(this->Input.bytes, offset, width, this->Result.isBigEndian);
    return this->checked(key, { this->Input.begin() + offset, false }, value, least, most);
  }

  /// The low byte holds junk in old files.
  void readFlags(std::int64_t flags)
  {
    CyberwareHeader& header = this->Result;
    if ((flags & 0x400) != 0)
    {
      header.space = CyberwareSpace::bilateral;
    }
    else if ((flags & 0x100) != 0)
    {
      header.space = CyberwareSpace::cartesian;
    }
    header.isRightHanded = (flags & 0x1000) != 0;
    header.isInsideOut = (flags & 0x2000) != 0;
  }

  /// A window of zeros was never set: it means the whole grid.
  void readWindow(std::size_t offset)
  {
    CyberwareHeader& header = this->Result;
    const std::int64_t top = header.latitudes - 1;
    const std::int64_t right = header.longitudes - 1;
    const std::span<const char> window = this->Input.bytes.subspan(offset, 8);
    if (std::all_of(window.begin(), window.end(), [](char c) { return c == '\0'; }))
    {
      header.lastLatitude = top;
      header.lastLongitude = right;
      return;
    }
    header.firstLatitude = this->field("LTMIN", offset, 2, 0, top);
    header.lastLatitude = this->field("LTMAX", offset + 2, 2, header.firstLatitude, top);
    header.firstLongitude = this->field("LGMIN", offset + 4, 2, 0, right);
    header.lastLongitude = this->field("LGMAX", offset + 6, 2, header.firstLongitude, right);
  }

  std::int64_t checked(const char* key, const Place& place, std::int64_t value, std::int64_t least,
    std::int64_t most) const
  {
    if (value < least || value > most)
    {
      const std::string what = std::string(key) + " is " + std::to_string(value) +
        ", but must be in " + std::to_string(least) + " to " + std::to_string(most) +
        "; the header is damaged";
      if (place.isLine)
      {
        this->Input.failAtLine(place.at, what);
      }
      this->Input.failAtByte(place.at, what);
    }
    return value;
  }

  const Source& Input;
  std::string_view Text; // the portable header without DATA=
  CyberwareHeader Result;
};

/// Whether the counts and steps of a binary header make sense, as far as `head` shows them.
bool isPlausibleStruct(std::span<const char> head, bool isBig)
{
  const std::size_t size = binarySize(head, isBig);
  if (size == 0 || head.size() < kShortestBinary)
  {
    return false;
  }
  const std::size_t gap = size == 128 ? 2 : 0;
  const std::int64_t shift = integerAt(head, 62, 2, isBig);
  return integerAt(head, 58, 2, isBig) > 0 && integerAt(head, 60, 2, isBig) > 0 && shift >= 0 &&
    shift <= kLargestShift && integerAt(head, 70 + gap, 4, isBig) > 0 &&
    integerAt(head, 74 + gap, 4, isBig) > 0;
}

} // namespace

CyberwareHeader parseCyberwareHeader(const Source& source)
{
  return HeaderReader(source).read();
}

bool looksLikeCyberware(std::span<const char> head)
{
  const std::string_view text = headText(head);
  if (isPortable(head))
  {
    return text.starts_with("Cyberware") ||
      (text.find("\nNLT=") != text.npos && text.find("\nNLG=") != text.npos);
  }
  return isPlausibleStruct(head, true) || isPlausibleStruct(head, false);
}

} // namespace scan
