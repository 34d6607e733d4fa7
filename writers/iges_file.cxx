// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/iges_file.h"

#include "filters/base/error.h"
#include "writers/iges_line.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

namespace scan
{
namespace
{

/// The shortest digits that read back as the value, with the decimal point that makes it a real.
class Real
{
public:
  explicit Real(double value)
  {
    std::array<char, 32> digits;
    const char* const end = std::to_chars(digits.begin(), digits.end(), value).ptr;
    const std::string_view all(digits.data(), static_cast<std::size_t>(end - digits.data()));
    const std::size_t mantissa = std::min(all.find('e'), all.size());
    this->append(all.substr(0, mantissa));
    if (all.find('.') == std::string_view::npos)
    {
      this->append(".");
    }
    if (mantissa < all.size())
    {
      this->append("E");
      this->append(all.substr(mantissa + 1));
    }
  }

  operator std::string_view() const { return { this->Characters.data(), this->Size }; }

private:
  void append(std::string_view text)
  {
    text.copy(this->Characters.data() + this->Size, text.size());
    this->Size += text.size();
  }

  std::array<char, 40> Characters;
  std::size_t Size = 0;
};

void requireCountable(std::uint64_t lines, const OutputFile& file)
{
  if (lines > IgesLine::kLargestNumber)
  {
    throw Error(ErrorCode::limit,
      file.name() +
        ": a section needs more than 9999999 lines, the limit of IGES; decimate, or write PLY");
  }
}

std::string hollerith(std::string_view text)
{
  return std::to_string(text.size()) + "H" + std::string(text);
}

std::vector<std::string> globalParameters(const IgesHeader& header)
{
  const auto real = [](double value) { return std::string(std::string_view(Real(value))); };
  const std::string program = hollerith("Scanwrap");
  // Readers want a date, but the same model gives the same bytes on every day and in every folder.
  const std::string date = hollerith("20000101.000000");
  const std::string name = hollerith("scanwrap.igs");
  // Sizes of numbers: 32 bits; reals and double-length reals both of 15 digits and 10^308.
  return { "1H,", "1H;", program, name, program, program, "32", "308", "15", "308", "15", program,
    "1.", std::to_string(header.unitFlag), hollerith(header.unitName), "1", "0.01", date,
    real(header.resolution), real(header.largest), hollerith("Scanwrap"), hollerith("Scanwrap"),
    "11", "0", date }; // 11: version 5.3; 0: no drafting standard
}

/// How many lines.
std::uint64_t writeGlobal(const IgesHeader& header, OutputFile& file)
{
  std::uint64_t lines = 0;
  std::string text;
  const auto endLine = [&]
  {
    file.write(IgesLine('G', ++lines).text(0, text));
    text.clear();
  };
  for (const std::string& parameter : globalParameters(header))
  {
    if (text.size() + parameter.size() + 1 > IgesLine::kData)
    {
      endLine();
    }
    text += parameter + ",";
  }
  text.back() = ';';
  endLine();
  return lines;
}

} // namespace

IgesSink::IgesSink(Section section, std::uint64_t entities, OutputFile& file, Execution& execution)
  : Current(section)
  , Expected(entities)
  , File(file)
  , Run(execution)
{
}

void IgesSink::begin(const IgesKind& kind)
{
  constexpr std::uint64_t kStep = 1U << 12U;
  if (this->Entities % kStep == 0)
  {
    const std::uint64_t before = this->Current == Section::directory ? 0 : this->Expected;
    this->Run.step("write", before + this->Entities, 2 * this->Expected);
  }
  ++this->Entities;
  this->Kind = kind;
  this->FirstLine = this->Lines + 1;
  this->integer(kind.type);
}

IgesSink& IgesSink::integer(std::uint64_t value)
{
  std::array<char, 20> digits;
  const char* const end = std::to_chars(digits.begin(), digits.end(), value).ptr;
  this->put({ digits.data(), static_cast<std::size_t>(end - digits.data()) });
  return *this;
}

IgesSink& IgesSink::real(double value)
{
  this->put(Real(value));
  return *this;
}

IgesSink& IgesSink::point(const Vec3& point)
{
  return this->real(point.x).real(point.y).real(point.z);
}

std::uint64_t IgesSink::end()
{
  this->Text[this->Column - 1] = ';';
  this->endLine();
  if (this->Current == Section::directory)
  {
    this->writeDirectoryEntry();
  }
  return this->directoryLines() - 1;
}

void IgesSink::put(std::string_view parameter)
{
  if (this->Column + parameter.size() + 1 > kWidth)
  {
    this->endLine();
  }
  parameter.copy(this->Text.data() + this->Column, parameter.size());
  this->Column += parameter.size();
  this->Text[this->Column++] = ',';
}

void IgesSink::endLine()
{
  requireCountable(++this->Lines, this->File);
  if (this->Current == Section::parameters)
  {
    this->File.write(IgesLine('P', this->Lines)
                       .text(0, { this->Text.data(), this->Column })
                       .number(IgesLine::kData, this->directoryLines() - 1));
  }
  this->Column = 0;
}

void IgesSink::writeDirectoryEntry()
{
  const auto field = [](std::size_t number) { return 8 * number; };
  const std::uint64_t line = this->directoryLines() - 1;
  IgesLine first('D', line);
  first.number(field(1), this->Kind.type).number(field(2), this->FirstLine);
  for (std::size_t none = 3; none <= 8; ++none) // structure, font, level, view, transform, label
  {
    first.number(field(none), 0);
  }
  this->File.write(first.text(field(8), this->Kind.status));
  this->File.write(IgesLine('D', line + 1)
                     .number(field(1), this->Kind.type)
                     .number(field(2), 0) // weight
                     .number(field(3), 0) // colour
                     .number(field(4), this->Lines + 1 - this->FirstLine)
                     .number(field(5), this->Kind.form)
                     .number(field(9), 0)); // number of the label
}

void writeIgesFile(const IgesHeader& header, std::uint64_t entities,
  const std::function<void(IgesSink&)>& put, OutputFile& file, Execution& execution)
{
  requireCountable(2 * entities, file);
  file.write(IgesLine('S', 1).text(0, header.description));
  const std::uint64_t globalLines = writeGlobal(header, file);
  IgesSink directory(IgesSink::Section::directory, entities, file, execution);
  put(directory);
  IgesSink parameters(IgesSink::Section::parameters, entities, file, execution);
  put(parameters);
  file.write(IgesLine('T', 1)
               .text(0, "S")
               .number(8, 1)
               .text(8, "G")
               .number(16, globalLines)
               .text(16, "D")
               .number(24, parameters.directoryLines())
               .text(24, "P")
               .number(32, parameters.parameterLines()));
}

} // namespace scan
