// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/ply_header.h"

#include "readers/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>

namespace scan
{
namespace
{

constexpr std::size_t kLongestLine = 4096;

std::optional<PlyType> typeNamed(std::string_view name)
{
  struct Row
  {
    std::string_view name;
    PlyType type;
  };
  static constexpr Row kRows[] = { { "char", PlyType::int8 }, { "int8", PlyType::int8 },
    { "uchar", PlyType::uint8 }, { "uint8", PlyType::uint8 }, { "short", PlyType::int16 },
    { "int16", PlyType::int16 }, { "ushort", PlyType::uint16 }, { "uint16", PlyType::uint16 },
    { "int", PlyType::int32 }, { "int32", PlyType::int32 }, { "uint", PlyType::uint32 },
    { "uint32", PlyType::uint32 }, { "float", PlyType::float32 }, { "float32", PlyType::float32 },
    { "double", PlyType::float64 }, { "float64", PlyType::float64 } };
  const auto* const row =
    std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) { return r.name == name; });
  return row != std::end(kRows) ? std::optional(row->type) : std::nullopt;
}

std::vector<std::string_view> splitWords(const char* at, const char* end)
{
  std::vector<std::string_view> words;
  for (at = skipBlanks(at, end); at != end;
       at = skipBlanks(words.back().data() + words.back().size(), end))
  {
    words.push_back(word(at, end));
  }
  return words;
}

/// Reads the lines one by one into the header.
class HeaderReader
{
public:
  explicit HeaderReader(const Source& source)
    : Text(source)
  {
  }

  PlyHeader read()
  {
    const char* line = skipUtf8Mark(this->Text.bytes);
    bool isFirst = true;
    for (;;)
    {
      this->Line = line;
      const char* const limit =
        line + std::min<std::ptrdiff_t>(this->Text.end() - line, kLongestLine);
      const char* const end = findLineEnd(line, limit);
      if (end == limit)
      {
        this->fail("the header does not end with 'end_header'; this is no complete PLY file");
      }
      const std::vector<std::string_view> words = splitWords(line, end);
      if (isFirst && (words.size() != 1 || words[0] != "ply"))
      {
        this->fail("a PLY file starts with 'ply', not " + quoted(word(line, end)));
      }
      if (!isFirst && !words.empty() && words[0] == "end_header")
      {
        this->Result.size = static_cast<std::size_t>(this->afterHeader(end) - this->Text.begin());
        return std::move(this->Result);
      }
      if (!isFirst && !words.empty())
      {
        this->readLine(words);
      }
      isFirst = false;
      line = nextLine(end, this->Text.end());
    }
  }

private:
  [[noreturn]] void fail(const std::string& what) const { this->Text.failAtLine(this->Line, what); }

  /// Where the data starts. With bare CR line ends a LF is the first byte of the data.
  const char* afterHeader(const char* end) const
  {
    const char* const first = findLineEnd(this->Text.begin(), end);
    const bool isBareReturn = *first == '\r' && first[1] != '\n';
    return isBareReturn && *end == '\r' ? end + 1 : nextLine(end, this->Text.end());
  }

  void readLine(const std::vector<std::string_view>& words)
  {
    const std::string_view keyword = words[0];
    if (keyword == "format")
    {
      this->readFormat(words.size() >= 2 ? words[1] : "");
    }
    else if (keyword == "element")
    {
      this->readElement(words);
    }
    else if (keyword == "property")
    {
      this->readProperty(words);
    }
    else if (keyword == "obj_info" && words.size() == 3)
    {
      this->readGridSize(words[1], words[2]);
    }
    // comments, other obj_info, and what some writers add without either keyword
  }

  void readFormat(std::string_view name)
  {
    if (name == "ascii")
    {
      this->Result.encoding = PlyEncoding::ascii;
    }
    else if (name == "binary_little_endian")
    {
      this->Result.encoding = PlyEncoding::littleEndian;
    }
    else if (name == "binary_big_endian")
    {
      this->Result.encoding = PlyEncoding::bigEndian;
    }
    else
    {
      this->fail("unknown format " + quoted(name));
    }
  }

  void readElement(const std::vector<std::string_view>& words)
  {
    if (words.size() != 3)
    {
      this->fail("incomplete 'element'");
    }
    const std::string_view number = words[2];
    PlyElement element;
    element.name = words[1];
    const std::vector<PlyElement>& known = this->Result.elements;
    if (element.name == "vertex" &&
      std::any_of(
        known.begin(), known.end(), [](const PlyElement& other) { return other.name == "vertex"; }))
    {
      this->fail("a second element 'vertex'; only one list of points can be read");
    }
    const char* const end = number.data() + number.size();
    const std::from_chars_result result = std::from_chars(number.data(), end, element.count);
    if (result.ec != std::errc() || result.ptr != end)
    {
      this->fail("the element count " + quoted(number) + " is no number");
    }
    this->Result.elements.push_back(std::move(element));
  }

  void readProperty(const std::vector<std::string_view>& words)
  {
    const bool isList = words.size() == 5 && words[1] == "list";
    if (this->Result.elements.empty() || !(isList || words.size() == 3))
    {
      this->fail("misplaced or incomplete 'property'");
    }
    PlyProperty property;
    property.name = words.back();
    property.isList = isList;
    property.type = this->readType(words[words.size() - 2]);
    property.countType = isList ? this->readType(words[2]) : property.countType;
    if (isList &&
      (property.countType == PlyType::float32 || property.countType == PlyType::float64))
    {
      this->fail("a list length must be an integer");
    }
    this->Result.elements.back().properties.push_back(std::move(property));
  }

  /// A value that is no number gives no size.
  void readGridSize(std::string_view key, std::string_view text)
  {
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    this->Result.columns = key == "num_cols" ? number : this->Result.columns;
    this->Result.rows = key == "num_rows" ? number : this->Result.rows;
  }

  PlyType readType(std::string_view name) const
  {
    const std::optional<PlyType> type = typeNamed(name);
    if (!type)
    {
      this->fail("unknown property type " + quoted(name));
    }
    return *type;
  }

  const Source& Text;
  const char* Line = nullptr;
  PlyHeader Result;
};

} // namespace

std::size_t plySize(PlyType type)
{
  static constexpr std::size_t kSizes[] = { 1, 1, 2, 2, 4, 4, 4, 8 };
  return kSizes[static_cast<std::size_t>(type)];
}

bool PlyElement::hasList() const
{
  return std::any_of(this->properties.begin(), this->properties.end(),
    [](const PlyProperty& property) { return property.isList; });
}

std::size_t PlyElement::find(std::string_view property) const
{
  const auto found = std::find_if(this->properties.begin(), this->properties.end(),
    [&](const PlyProperty& candidate) { return candidate.name == property; });
  return static_cast<std::size_t>(found - this->properties.begin());
}

PlyHeader parsePlyHeader(const Source& source)
{
  return HeaderReader(source).read();
}

} // namespace scan
