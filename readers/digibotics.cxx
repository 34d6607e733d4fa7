// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/digibotics.h"

#include "filters/base/error.h"
#include "readers/coordinate_check.h"
#include "readers/text_columns.h"

#include <array>
#include <cmath>
#include <iterator>
#include <string>

namespace scan
{
namespace
{

constexpr std::size_t kStepBytes = std::size_t(1) << 20U;
constexpr std::size_t kInspectedBytes = std::size_t(1) << 16U;

enum class LineKind
{
  blank,
  comment,
  words,  // starts with a word
  number, // one number
  point,  // three numbers or more
  broken  // two numbers
};

/// A line and the numbers it starts with, up to four of them.
struct Line
{
  LineKind kind = LineKind::blank;
  std::array<double, 4> values = {};
  std::size_t count = 0;
};

Line readLine(const char* at, const char* end)
{
  Line line;
  at = skipBlanks(at, end);
  if (at == end || isLineEnd(*at))
  {
    return line;
  }
  if (*at == ';' || isComment(at, end))
  {
    line.kind = LineKind::comment;
    return line;
  }
  while (line.count < line.values.size() && at != end && !isLineEnd(*at))
  {
    const char* const stop = parseColumn(at, end, line.values[line.count]);
    if (stop == nullptr)
    {
      break;
    }
    ++line.count;
    at = skipSeparator(stop, end);
  }
  const bool isLast = at == end || isLineEnd(*at);
  line.kind = line.count >= 3   ? LineKind::point
    : line.count == 0           ? LineKind::words
    : line.count == 1 && isLast ? LineKind::number
                                : LineKind::broken;
  return line;
}

/// "1,5 2,5 3,5" would silently become the point 1 5 2.
bool hasDecimalCommas(const char* at, const char* end)
{
  bool hasComma = false;
  bool hasOther = false; // separators that are no commas
  const char* const stop = findLineEnd(at, end);
  const char* const start = skipBlanks(at, end);
  for (at = start; at != stop; ++at)
  {
    const bool isAheadOfDigit = at + 1 != stop && isDigit(at[1]);
    hasComma = hasComma || (*at == ',' && isAheadOfDigit);
    const bool isColumn = isAheadOfDigit || (at + 1 != stop && (at[1] == '-' || at[1] == '+'));
    hasOther = hasOther || (isColumn && at[0] != ',' && isSeparator(*at) && at[-1] != ',');
  }
  return hasComma && hasOther && std::find(start, stop, '.') == stop;
}

/// Control characters that no text has.
bool isBinary(std::span<const char> bytes)
{
  const std::span<const char> start = bytes.first(std::min(bytes.size(), kInspectedBytes));
  return std::any_of(start.begin(), start.end(),
    [](char c)
    {
      const bool isSpace = c >= '\t' && c <= '\r';
      return static_cast<unsigned char>(c) < 32 && !isSpace && c != '\x1a'; // the end in DOS
    });
}

/// Calls see(word) with each run of letters of a line, in lower case.
template <class See>
void forEachWord(const char* at, const char* end, const See& see)
{
  std::string letters;
  for (; at != end && !isLineEnd(*at); ++at)
  {
    const char lower = lowerCase(*at);
    if (lower >= 'a' && lower <= 'z')
    {
      letters += lower;
    }
    else if (!letters.empty())
    {
      see(letters);
      letters.clear();
    }
  }
  if (!letters.empty())
  {
    see(letters);
  }
}

double millimetresOf(std::string_view unit)
{
  struct Row
  {
    std::string_view name;
    double millimetres;
  };
  static constexpr Row kRows[] = { { "inch", 25.4 }, { "inches", 25.4 }, { "in", 25.4 },
    { "mm", 1.0 }, { "millimeter", 1.0 }, { "millimeters", 1.0 }, { "millimetre", 1.0 },
    { "millimetres", 1.0 }, { "cm", 10.0 }, { "centimeter", 10.0 }, { "centimeters", 10.0 },
    { "centimetre", 10.0 }, { "centimetres", 10.0 } };
  const auto* const row =
    std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) { return r.name == unit; });
  return row != std::end(kRows) ? row->millimetres : 0.0;
}

/// What the words of a line say.
struct WordsOfLine
{
  double millimetres = 0.0; // 0 when there is no unit
  bool isAboutUnits = false;
  bool startsSlice = false;
  bool namesProgram = false;
};

WordsOfLine readWords(const char* at, const char* end)
{
  WordsOfLine result;
  double ofIn = 0.0; // "in" is a unit by itself or on a line about units, else a preposition
  int count = 0;
  forEachWord(at, end,
    [&](std::string_view text)
    {
      static constexpr std::string_view kSlices[] = { "slice", "contour", "section", "layer",
        "profile" };
      const bool isSlice =
        std::find(std::begin(kSlices), std::end(kSlices), text) != std::end(kSlices);
      result.startsSlice = result.startsSlice || (isSlice && count == 0);
      result.namesProgram = result.namesProgram || text.starts_with("digibot");
      result.isAboutUnits = result.isAboutUnits || text == "unit" || text == "units";
      double& unit = text == "in" ? ofIn : result.millimetres;
      unit = unit == 0.0 ? millimetresOf(text) : unit;
      ++count;
    });
  if (result.millimetres == 0.0 && (result.isAboutUnits || count == 1))
  {
    result.millimetres = ofIn;
  }
  return result;
}

/// Reads the lines into a model.
class ContourReader
{
public:
  ContourReader(const Source& source, Execution& execution)
    : Text(source)
    , Run(execution)
  {
  }

  Model read()
  {
    if (isBinary(this->Text.bytes))
    {
      this->Text.fail("this is a binary file, and the binary form of Digibotics files is not "
                      "documented; export the scan as text, or send a sample file to the authors "
                      "so that they can add it");
    }
    this->FirstColumn = this->countsPoints() ? 1 : 0;
    this->forEachLine([&](const char* at, const Line& line) { return this->take(at, line); });
    this->finish();
    return std::move(this->Result);
  }

private:
  /// Calls see(at, line) until it is false; @return whether it never was.
  template <class See>
  bool forEachLine(const See& see)
  {
    const char* const end = this->Text.end();
    const char* reported = this->Text.begin();
    for (const char* at = skipByteOrderMark(this->Text); at != end; at = nextLine(at, end))
    {
      if (at >= reported)
      {
        this->Run.step(
          "read", static_cast<std::size_t>(at - this->Text.begin()), this->Text.bytes.size());
        reported = at + std::min<std::ptrdiff_t>(end - at, kStepBytes);
      }
      if (!see(at, readLine(at, end)))
      {
        return false;
      }
    }
    return true;
  }

  /// Whether the first of four columns or more numbers the points, of the file or of each slice:
  /// whole numbers that start at 0 or 1 and nearly always rise by one.
  bool countsPoints()
  {
    double last = -1.0;
    std::size_t starts = 0;
    std::size_t steps = 0;
    const bool mayCount = this->forEachLine(
      [&](const char* at, const Line& line)
      {
        if (line.kind != LineKind::point)
        {
          return true;
        }
        const char* const first = skipBlanks(at, this->Text.end());
        const char* const stop = std::find_if_not(first, this->Text.end(), isDigit);
        const double number = line.values[0];
        const bool isStep = last >= 0.0 && number == last + 1.0;
        const bool isStart = !isStep && (number == 0.0 || number == 1.0);
        steps += isStep ? 1 : 0;
        starts += isStart ? 1 : 0;
        last = number;
        return line.count == 4 && isSeparator(*stop) && (isStep || isStart);
      });
    return mayCount && steps >= 3 * starts && steps > 0;
  }

  bool take(const char* at, const Line& line)
  {
    if (line.kind == LineKind::broken || line.kind == LineKind::point)
    {
      this->takeNumbers(at, line);
    }
    else if (line.kind == LineKind::words || line.kind == LineKind::comment)
    {
      this->Words += line.kind == LineKind::words ? 1 : 0;
      this->takeUnit(at);
    }
    return true;
  }

  void takeNumbers(const char* at, const Line& line)
  {
    const char* const end = this->Text.end();
    if (hasDecimalCommas(at, end))
    {
      this->Text.failAtLine(at, "the numbers have decimal commas; export them with decimal points");
    }
    if (line.kind == LineKind::broken)
    {
      this->Text.failAtLine(at,
        "expected x y z, found " +
          quoted({ at, static_cast<std::size_t>(findLineEnd(at, end) - at) }) +
          "; correct or remove the line");
    }
    const double* const values = line.values.data() + this->FirstColumn;
    this->Result.points.push_back({ values[0], values[1], values[2] });
    this->Check.see(this->Result.points.back(), at);
  }

  void takeUnit(const char* at)
  {
    if (!this->Result.points.empty() || this->IsUnitCertain)
    {
      return;
    }
    const WordsOfLine words = readWords(at, this->Text.end());
    const bool isFirst = this->Result.millimetresPerUnit == 0.0;
    if (words.millimetres != 0.0 && (isFirst || words.isAboutUnits))
    {
      this->Result.millimetresPerUnit = words.millimetres;
      this->IsUnitCertain = words.isAboutUnits;
    }
  }

  void finish()
  {
    const std::size_t count = this->Result.points.size();
    if (count == 0)
    {
      this->Text.fail("no point found; Digibotics text has lines of three numbers");
    }
    if (count < this->Words)
    {
      this->Text.fail("only " + std::to_string(count) + " lines are points, but " +
        std::to_string(this->Words) +
        " start with a word; this is no Digibotics text that can be read, export it as XYZ");
    }
    this->Text.checkPointCount(count);
    this->Check.finish(this->Text, this->Result, CoordinateCheck::Place::line);
    this->Result.addNote("the layout of Digibotics files is not documented and was not verified; "
                         "check a known size");
  }

  const Source& Text;
  Execution& Run;
  Model Result;
  CoordinateCheck Check;
  std::size_t FirstColumn = 0;
  std::size_t Words = 0; // lines
  bool IsUnitCertain = false;
};

} // namespace

Model parseDigibotics(std::span<const char> bytes, std::string_view name, Execution& execution)
{
  const Source source = textOf(name, bytes);
  return ContourReader(source, execution).read();
}

bool looksLikeDigibotics(std::span<const char> head)
{
  if (isBinary(head))
  {
    return false;
  }
  bool hasPoint = false;
  bool hasMark = false;
  const char* const end = head.data() + head.size();
  for (const char* at = skipUtf8Mark(head); at != end; at = nextLine(at, end))
  {
    const LineKind kind = readLine(at, end).kind;
    hasPoint = hasPoint || kind == LineKind::point;
    if (kind == LineKind::words || kind == LineKind::comment)
    {
      // other lists may have comments about anything, and any words above the points
      const WordsOfLine words = readWords(at, end);
      hasMark =
        hasMark || words.namesProgram || (words.startsSlice && hasPoint && kind == LineKind::words);
    }
  }
  return hasPoint && hasMark;
}

} // namespace scan
