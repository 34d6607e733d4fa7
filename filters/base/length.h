// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace scan
{

/// What the relative and the physical lengths of a model refer to. Zero means unknown.
struct LengthScale
{
  double diagonal = 0.0;           ///< of the bounding box, in model units
  double spacing = 0.0;            ///< mean distance of neighbouring points, in model units
  double millimetresPerUnit = 1.0; ///< a model that names no unit counts as millimetres
};

/// A length as people write it: "0.5mm", "1%" of the bounding-box diagonal, "3x" the mean point
/// spacing, "0.5" model units; also um, cm, m and in. Finite, may be negative.
class Length
{
public:
  enum class Unit
  {
    model,
    diagonalPercent,
    spacing,
    micrometre,
    millimetre,
    centimetre,
    metre,
    inch
  };

  Length() = default;
  explicit Length(double value, Unit unit = Unit::model)
    : Value(value)
    , Symbol(unit)
  {
  }

  /// @throws Error{badParameter} for anything but one finite number and one known unit
  static Length parse(std::string_view text);

  double value() const noexcept { return this->Value; }
  Unit unit() const noexcept { return this->Symbol; }

  /// The length in model units.
  /// @throws Error{badInput} when the scale does not know what the length is relative to
  double resolve(const LengthScale& scale) const;

  /// The shortest text that parse() turns into the same length.
  std::string text() const;

  friend bool operator==(const Length&, const Length&) = default;

private:
  double Value = 0.0;
  Unit Symbol = Unit::model;
};

} // namespace scan
