// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "writers/text_line.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace scan
{

/// A part of a colour, 0 to 255, as text from " 0.0000" to " 1.0000".
class ColorText
{
public:
  explicit ColorText(std::uint8_t value)
  {
    // rounded up, so that a reader which cuts off the digits of value * 255 meets it too
    int digits = (value * 10000 + 254) / 255;
    for (const std::size_t at : { 6U, 5U, 4U, 3U, 1U })
    {
      this->Characters[at] = static_cast<char>('0' + digits % 10);
      digits /= 10;
    }
  }

  operator std::string_view() const { return { this->Characters.data(), this->Characters.size() }; }

private:
  std::array<char, 7> Characters = { ' ', '0', '.' };
};

/// Appends red, green and blue, each behind a blank.
inline TextLine& putColor(TextLine& line, const Color& color)
{
  return line.text(ColorText(color[0])).text(ColorText(color[1])).text(ColorText(color[2]));
}

} // namespace scan
