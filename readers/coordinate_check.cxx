// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/coordinate_check.h"

#include "readers/text_scanner.h"

#include <string>
#include <vector>

namespace scan
{
namespace
{

bool isMissing(const Vec3& p)
{
  return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z);
}

/// Keeps the values of points that are kept.
template <class Value>
void keep(std::vector<Value>& values, const std::vector<bool>& isKept)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[kept] = values[i];
    kept += isKept[i] ? 1 : 0;
  }
  values.resize(kept);
}

void dropMissing(Model& model)
{
  std::vector<bool> isKept(model.points.size());
  for (std::size_t i = 0; i < isKept.size(); ++i)
  {
    isKept[i] = !isMissing(model.points[i]);
  }
  keep(model.points, isKept);
  keep(model.colors, isKept);
  keep(model.normals, isKept);
}

} // namespace

void CoordinateCheck::count(const Vec3& point, const char* at)
{
  this->First = this->Count++ == 0 ? at : this->First;
  this->Missing += isMissing(point) ? 1 : 0;
}

void CoordinateCheck::append(const CoordinateCheck& later)
{
  this->First = this->Count == 0 ? later.First : this->First;
  this->Count += later.Count;
  this->Missing += later.Missing;
}

void CoordinateCheck::finish(const Source& source, std::size_t total, Place place) const
{
  if (this->Count == 0)
  {
    return;
  }
  const std::string first = place == Place::line
    ? " (first: line " + std::to_string(lineNumber(source.begin(), this->First)) + ")"
    : place == Place::byte ? " (first: byte " + std::to_string(this->First - source.begin()) + ")"
                           : "";
  source.fail(std::to_string(this->Count) + " of " + std::to_string(total) +
    " points have coordinates that are not finite or exceed 1e50" + first + "; remove them");
}

void CoordinateCheck::finish(const Source& source, Model& model, Place place) const
{
  if (!model.isScan() || this->Count > this->Missing)
  {
    this->finish(source, model.points.size(), place);
  }
  if (this->Missing == model.points.size())
  {
    source.fail("no point with coordinates; there is nothing to load");
  }
  if (this->Missing > 0)
  {
    dropMissing(model);
    model.addNote(
      "points whose coordinates are not a number left out: " + std::to_string(this->Missing));
  }
}

} // namespace scan
