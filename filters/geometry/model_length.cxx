// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/model_length.h"

#include "filters/geometry/bounding_box.h"
#include "filters/geometry/spacing.h"

namespace scan
{

double inModelUnits(const Length& length, std::span<const Vec3> points, double millimetresPerUnit)
{
  LengthScale scale;
  scale.millimetresPerUnit = millimetresPerUnit > 0.0 ? millimetresPerUnit : 1.0;
  scale.diagonal = BoundingBox(points).diagonal();
  if (length.unit() == Length::Unit::spacing)
  {
    scale.spacing = meanSpacing(points);
  }
  return length.resolve(scale);
}

double inModelUnitsOrZero(
  const Length& length, std::span<const Vec3> points, double millimetresPerUnit)
{
  const bool hasExtent = BoundingBox(points).diagonal() > 0.0;
  return hasExtent ? inModelUnits(length, points, millimetresPerUnit) : 0.0;
}

} // namespace scan
