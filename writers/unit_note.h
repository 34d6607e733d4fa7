// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"

#include <string>

namespace scan
{

/// What to say where a format needs a unit and the model has none.
inline std::string noteOnUnit(const Model& model)
{
  return model.millimetresPerUnit == 0.0
    ? "the model has no unit, millimetres are written; --unit tells it"
    : "";
}

} // namespace scan
