// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"
#include "readers/source.h"
#include "readers/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace scan
{

/// How binary legacy VTK files store a number: big-endian.
struct VtkNumberType
{
  std::size_t bytes = 0;
  double (*load)(const char* at) = nullptr;
};

namespace detail
{

constexpr std::size_t kStepValues = std::size_t(1) << 16U;

template <class Number>
double loadBig(const char* at)
{
  std::array<char, sizeof(Number)> bytes;
  std::reverse_copy(at, at + sizeof(Number), bytes.begin());
  Number value;
  std::memcpy(&value, bytes.data(), sizeof(value));
  return static_cast<double>(value);
}

template <class Number>
constexpr VtkNumberType numberType()
{
  return { sizeof(Number), loadBig<Number> };
}

} // namespace detail

/// The type of that name, in lower case; none for bit, strings and what is not known.
inline std::optional<VtkNumberType> vtkNumberType(std::string_view name)
{
  struct Row
  {
    std::string_view name;
    VtkNumberType type;
  };
  static constexpr Row kRows[] = {
    { "float", detail::numberType<float>() },
    { "double", detail::numberType<double>() },
    { "unsigned_char", detail::numberType<std::uint8_t>() },
    { "char", detail::numberType<std::int8_t>() },
    { "signed_char", detail::numberType<std::int8_t>() },
    { "unsigned_short", detail::numberType<std::uint16_t>() },
    { "short", detail::numberType<std::int16_t>() },
    { "unsigned_int", detail::numberType<std::uint32_t>() },
    { "int", detail::numberType<std::int32_t>() },
    { "unsigned_long", detail::numberType<std::uint64_t>() },
    { "long", detail::numberType<std::int64_t>() },
    { "vtkidtype", detail::numberType<std::int32_t>() },
    { "vtktypeint64", detail::numberType<std::int64_t>() },
    { "vtktypeuint64", detail::numberType<std::uint64_t>() },
  };
  const Row* const found = std::ranges::find(kRows, name, &Row::name);
  return found != std::end(kRows) ? std::optional(found->type) : std::nullopt;
}

/// The words and numbers of a legacy VTK file.
class VtkScanner
{
public:
  VtkScanner(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
    , At(source.begin())
  {
  }

  /// Reads the three lines of the head.
  void readHead()
  {
    const char* const end = this->Text.end();
    this->At = nextLine(nextLine(this->At, end), end);
    const char* const line = this->At;
    const std::string encoding = this->lowerWord();
    if (encoding != "ascii" && encoding != "binary")
    {
      this->Text.failAtLine(line, "expected ASCII or BINARY, found " + quoted(encoding));
    }
    this->IsBinary = encoding == "binary";
  }

  bool isBinary() const { return this->IsBinary; }
  const Source& text() const { return this->Text; }

  /// The next word, anywhere; empty at the end.
  std::string_view nextWord()
  {
    this->At = skipSpace(this->At, this->Text.end());
    const std::string_view found = word(this->At, this->Text.end());
    this->Last = this->At;
    this->At += found.size();
    return found;
  }

  std::string lowerWord() { return lowerCase(this->nextWord()); }

  /// Skips the next word if it is that one, in any case.
  bool takeWord(std::string_view wanted)
  {
    const char* const before = this->At;
    const bool isTaken = this->lowerWord() == wanted;
    this->At = isTaken ? this->At : before;
    return isTaken;
  }

  /// A further word on this line, in lower case, or an empty one.
  std::string lowerWordOnLine()
  {
    this->At = skipBlanks(this->At, this->Text.end());
    return this->At == this->Text.end() || isLineEnd(*this->At) ? std::string() : this->lowerWord();
  }

  std::size_t readCount()
  {
    const std::string_view found = this->nextWord();
    std::size_t count = 0;
    const auto [stop, error] = std::from_chars(found.begin(), found.end(), count);
    if (error != std::errc() || stop != found.end())
    {
      this->fail("expected a count, found " + quoted(found));
    }
    return count;
  }

  VtkNumberType readType()
  {
    const std::string name = this->lowerWord();
    const std::optional<VtkNumberType> type = vtkNumberType(name);
    if (!type)
    {
      this->fail("numbers of type " + quoted(name) + " cannot be read");
    }
    return *type;
  }

  /// Throws Error parse at the last word.
  [[noreturn]] void fail(const std::string& what) const
  {
    if (this->IsBinary)
    {
      this->Text.failAtByte(this->Last, what);
    }
    this->Text.failAtLine(this->Last, what);
  }

  /// Calls visit(value, place) for rows * columns numbers that start on the next line.
  template <class Visit>
  void readValues(std::size_t rows, std::size_t columns, const VtkNumberType& type, Visit visit)
  {
    const std::size_t least = this->IsBinary ? type.bytes : 2; // a digit and a blank
    const char* const end = this->Text.end();
    const char* const data = this->IsBinary ? nextLine(this->At, end) : this->At;
    const std::size_t room = (static_cast<std::size_t>(end - data) + 1) / least;
    if (columns > 0 && rows > room / columns)
    {
      this->fail("the file ends early: there are " + std::to_string(rows) + " times " +
        std::to_string(columns) + " numbers announced");
    }
    this->At = data;
    const std::size_t count = rows * columns;
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i % detail::kStepValues == 0)
      {
        this->Run.step(
          "read", static_cast<std::size_t>(this->At - this->Text.begin()), this->Text.bytes.size());
      }
      this->Last = this->At;
      const double value = this->IsBinary ? this->nextBinary(type) : this->nextNumber();
      visit(value, this->Last);
    }
  }

  /// What follows METADATA, to the next blank line.
  void skipMetadata()
  {
    const char* const end = this->Text.end();
    do
    {
      this->At = nextLine(this->At, end);
    } while (skipBlanks(this->At, end) != findLineEnd(this->At, end));
  }

  /// Calls visit(vector, place) for that many vectors that start on the next line.
  template <class Visit>
  void readVectors(std::size_t rows, const VtkNumberType& type, Visit visit)
  {
    std::array<double, 3> vector = {};
    std::size_t axis = 0;
    this->readValues(rows, 3, type,
      [&](double value, const char* at)
      {
        vector[axis] = value;
        axis = (axis + 1) % 3;
        if (axis == 0)
        {
          visit(Vec3{ vector[0], vector[1], vector[2] }, at);
        }
      });
  }

  void skipToEnd() { this->At = this->Text.end(); }

  /// Skips strings that start on the next line: a line each, or behind their length.
  void skipStrings(std::size_t rows, std::size_t columns)
  {
    if (columns > 0 && rows > (this->Text.bytes.size() + 1) / columns)
    {
      this->fail("the file ends early: strings are missing");
    }
    this->At = nextLine(this->At, this->Text.end());
    for (std::size_t i = 0; i < rows * columns; ++i)
    {
      this->skipString();
    }
  }

private:
  void skipString()
  {
    this->Last = this->At;
    if (!this->IsBinary)
    {
      this->At = nextLine(this->At, this->Text.end());
      return;
    }
    const std::uint64_t length = this->readStringLength();
    if (length > static_cast<std::uint64_t>(this->Text.end() - this->At))
    {
      this->fail("the file ends early, in the middle of strings");
    }
    this->At += length;
  }

  /// The length of a binary string, big-endian, whose first two bits tell how many bytes it takes.
  std::uint64_t readStringLength()
  {
    constexpr std::size_t kBytes[] = { 8, 4, 2, 1 };
    const char* const end = this->Text.end();
    const std::size_t size =
      this->At != end ? kBytes[static_cast<unsigned char>(*this->At) >> 6U] : 1;
    if (static_cast<std::size_t>(end - this->At) < size)
    {
      this->fail("the file ends early, in the middle of strings");
    }
    std::uint64_t length = static_cast<unsigned char>(*this->At) & 0x3fU;
    for (std::size_t i = 1; i < size; ++i)
    {
      length = length << 8U | static_cast<unsigned char>(this->At[i]);
    }
    this->At += size;
    return length;
  }

  double nextBinary(const VtkNumberType& type)
  {
    if (static_cast<std::size_t>(this->Text.end() - this->At) < type.bytes)
    {
      this->fail("the file ends early, in the middle of numbers");
    }
    const double value = type.load(this->At);
    this->At += type.bytes;
    return value;
  }

  double nextNumber()
  {
    const char* const end = this->Text.end();
    this->At = skipSpace(this->At, end);
    this->Last = this->At;
    double value = 0.0;
    const char* const stop = parseNumber(this->At, end, value);
    if (stop == nullptr || (stop != end && !isBlank(*stop) && !isLineEnd(*stop)))
    {
      this->fail(this->At == end ? "the file ends early, in the middle of numbers"
                                 : "expected a number, found " + quoted(word(this->At, end)));
    }
    this->At = stop;
    return value;
  }

  const Source& Text;
  Execution& Run;
  const char* At;
  const char* Last = nullptr; // the word or number before At
  bool IsBinary = false;
};

} // namespace scan
