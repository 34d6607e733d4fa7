// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/coordinate_check.h"

#include "readers/text_scanner.h"

namespace scan
{

void CoordinateCheck::append(const CoordinateCheck& later)
{
  this->First = this->Count == 0 ? later.First : this->First;
  this->Count += later.Count;
}

void CoordinateCheck::finish(const Source& source, std::size_t total, Place place) const
{
  if (this->Count == 0)
  {
    return;
  }
  const std::string first = place == Place::line
    ? "line " + std::to_string(lineNumber(source.begin(), this->First))
    : "byte " + std::to_string(this->First - source.begin());
  source.fail(std::to_string(this->Count) + " of " + std::to_string(total) +
    " points have coordinates that are not finite or exceed 1e50 (first: " + first +
    "); remove them");
}

} // namespace scan
