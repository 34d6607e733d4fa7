// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/pcd_header.h"

#include "readers/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>

namespace scan
{
namespace
{

constexpr std::size_t kMostColumns = 65536; // of a point; descriptors have some hundred

/// Reads the lines of a header.
class HeaderReader
{
public:
  explicit HeaderReader(const Source& source)
    : Text(source)
    , At(skipByteOrderMark(source))
  {
  }

  PcdHeader read()
  {
    while (!this->IsComplete)
    {
      this->readLine();
    }
    this->makeFields();
    this->checkFields();
    this->checkPoints();
    return std::move(this->Header);
  }

private:
  void readLine()
  {
    const char* const end = this->Text.end();
    this->At = skipSpace(this->At, end);
    if (this->At == end)
    {
      this->fail("the header of the PCD file ends without a line DATA");
    }
    this->Line = this->At;
    const std::string_view key = *this->At == '#' ? "#" : this->next();
    if (key == "FIELDS" || key == "COLUMNS")
    {
      this->Names = this->words();
    }
    else if (key == "SIZE")
    {
      this->Sizes = this->integers();
    }
    else if (key == "TYPE")
    {
      this->Types = this->words();
    }
    else if (key == "COUNT")
    {
      this->Counts = this->integers();
    }
    else if (key == "WIDTH")
    {
      this->Width = this->integer(this->next());
    }
    else if (key == "HEIGHT")
    {
      this->Height = this->integer(this->next());
    }
    else if (key == "POINTS")
    {
      this->Points = this->integer(this->next());
    }
    else if (key == "DATA")
    {
      this->readData();
    }
    else if (key != "#" && key != "VERSION" && key != "VIEWPOINT")
    {
      this->fail("expected a line of a PCD header, found " + quoted(key));
    }
    this->At = nextLine(this->At, end);
    this->Header.body = this->At;
  }

  std::vector<std::string_view> words()
  {
    std::vector<std::string_view> result;
    for (std::string_view name = this->next(); !name.empty(); name = this->next())
    {
      result.push_back(name);
      if (result.size() > kMostColumns)
      {
        this->fail("the header has too many fields");
      }
    }
    return result;
  }

  std::vector<std::uint64_t> integers()
  {
    std::vector<std::uint64_t> result;
    for (const std::string_view text : this->words())
    {
      result.push_back(this->integer(text));
    }
    return result;
  }

  void readData()
  {
    const std::string_view encoding = this->next();
    if (encoding != "ascii" && encoding != "binary" && encoding != "binary_compressed")
    {
      this->fail("expected the data ascii, binary or binary_compressed, found " + quoted(encoding));
    }
    this->Header.encoding = encoding == "ascii" ? PcdEncoding::ascii
      : encoding == "binary"                    ? PcdEncoding::binary
                                                : PcdEncoding::compressed;
    this->IsComplete = true;
  }

  /// The next word on the line; empty at its end.
  std::string_view next()
  {
    this->At = skipBlanks(this->At, this->Text.end());
    const std::string_view result = word(this->At, this->Text.end());
    this->At += result.size();
    return result;
  }

  std::uint64_t integer(std::string_view text) const
  {
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size())
    {
      this->fail("expected a whole number, found " + quoted(text));
    }
    return value;
  }

  /// The lines of the header may have stood in any order.
  void makeFields()
  {
    const std::size_t count = this->Names.size();
    const auto isWrong = [&](std::size_t values) { return values != 0 && values != count; };
    if (isWrong(this->Sizes.size()) || isWrong(this->Types.size()) || isWrong(this->Counts.size()))
    {
      this->Text.fail("the header must give one SIZE, TYPE and COUNT for each of the FIELDS");
    }
    if (this->Header.encoding != PcdEncoding::ascii && (this->Sizes.empty() || this->Types.empty()))
    {
      this->Text.fail("the header lacks SIZE or TYPE, so that its binary data cannot be read");
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      PcdField field;
      field.name = this->Names[i];
      field.size = this->Sizes.empty() ? field.size : this->Sizes[i];
      field.type = this->Types.empty() ? field.type
        : this->Types[i].size() == 1   ? this->Types[i][0]
                                       : '?';
      field.count = this->Counts.empty() ? field.count : this->Counts[i];
      this->Header.fields.push_back(std::move(field));
    }
  }

  void checkFields() const
  {
    std::size_t columns = 0;
    for (const PcdField& field : this->Header.fields)
    {
      const bool isInteger = field.type == 'I' || field.type == 'U';
      const bool isKnown = (isInteger && (field.size == 1 || field.size == 2)) ||
        ((isInteger || field.type == 'F') && (field.size == 4 || field.size == 8));
      if (!isKnown)
      {
        this->Text.fail("the field " + quoted(field.name) + " has an unknown type or size");
      }
      columns += std::min(field.count, kMostColumns);
      if (columns > kMostColumns)
      {
        this->Text.fail("the fields of a point hold too many numbers");
      }
    }
  }

  void checkPoints()
  {
    const std::uint64_t height = this->Height.value_or(1);
    const bool isGrid =
      this->Width.has_value() && (height == 0 || *this->Width <= ~std::uint64_t(0) / height);
    if (!this->Points && !isGrid)
    {
      this->Text.fail("the header lacks the number of points");
    }
    if (this->Points && this->Width && (!isGrid || *this->Width * height != *this->Points))
    {
      this->Text.fail("the header announces " + std::to_string(*this->Points) +
        " points, but a WIDTH and HEIGHT of another product");
    }
    this->Header.points = this->Points ? *this->Points : *this->Width * height;
  }

  [[noreturn]] void fail(const std::string& what) const { this->Text.failAtLine(this->Line, what); }

  const Source& Text;
  const char* At;
  const char* Line = nullptr;
  PcdHeader Header;
  std::vector<std::string_view> Names;
  std::vector<std::uint64_t> Sizes;
  std::vector<std::string_view> Types;
  std::vector<std::uint64_t> Counts;
  std::optional<std::uint64_t> Width;
  std::optional<std::uint64_t> Height;
  std::optional<std::uint64_t> Points;
  bool IsComplete = false;
};

} // namespace

std::size_t PcdHeader::find(std::string_view name) const
{
  const auto found = std::find_if(this->fields.begin(), this->fields.end(),
    [&](const PcdField& field) { return field.name == name && field.count > 0; });
  return static_cast<std::size_t>(found - this->fields.begin());
}

std::size_t PcdHeader::pointSize() const
{
  std::size_t size = 0;
  for (const PcdField& field : this->fields)
  {
    size += field.size * field.count;
  }
  return size;
}

std::size_t PcdHeader::pointColumns() const
{
  std::size_t columns = 0;
  for (const PcdField& field : this->fields)
  {
    columns += field.count;
  }
  return columns;
}

PcdHeader parsePcdHeader(const Source& source)
{
  return HeaderReader(source).read();
}

} // namespace scan
