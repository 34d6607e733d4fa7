// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/length.h"

#include "filters/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace scan
{

namespace
{

struct UnitRow
{
  Length::Unit unit;
  std::string_view symbol;
  double millimetres; ///< 0: relative to the model
};

constexpr std::array<UnitRow, 8> kUnits = { {
  { Length::Unit::model, "", 0.0 },
  { Length::Unit::diagonalPercent, "%", 0.0 },
  { Length::Unit::spacing, "x", 0.0 },
  { Length::Unit::micrometre, "um", 0.001 },
  { Length::Unit::millimetre, "mm", 1.0 },
  { Length::Unit::centimetre, "cm", 10.0 },
  { Length::Unit::metre, "m", 1000.0 },
  { Length::Unit::inch, "in", 25.4 },
} };

const UnitRow& rowOf(Length::Unit unit)
{
  return *std::ranges::find(kUnits, unit, &UnitRow::unit);
}

double known(double reference, const Length& length, const char* name)
{
  if (!(reference > 0.0) || !std::isfinite(reference))
  {
    throw Error(ErrorCode::badInput,
      "length " + length.text() + " has no meaning here: the model has no " + name +
        "; give the length in model units");
  }
  return reference;
}

} // namespace

Length Length::parse(std::string_view text)
{
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view symbol = text.substr(static_cast<std::size_t>(end - text.data()));
  const auto* const row = std::ranges::find(kUnits, symbol, &UnitRow::symbol);
  if (status != std::errc() || row == kUnits.end() || !std::isfinite(value))
  {
    throw Error(ErrorCode::badParameter,
      "'" + std::string(text) +
        "' is no length; write 0.5 (model units), 0.5mm, 1% (of the bounding-box diagonal) or 3x "
        "(the mean point spacing)");
  }
  return Length(value, row->unit);
}

double Length::resolve(const LengthScale& scale) const
{
  switch (this->Symbol)
  {
    case Unit::model:
      return this->Value;
    case Unit::diagonalPercent:
      return this->Value / 100.0 * known(scale.diagonal, *this, "extent");
    case Unit::spacing:
      return this->Value * known(scale.spacing, *this, "point spacing");
    default:
      return this->Value * rowOf(this->Symbol).millimetres /
        known(scale.millimetresPerUnit, *this, "unit");
  }
}

std::string Length::text() const
{
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), this->Value);
  return std::string(digits.data(), result.ptr).append(rowOf(this->Symbol).symbol);
}

} // namespace scan
