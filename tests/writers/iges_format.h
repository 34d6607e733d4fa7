// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/writers/written.h"
#include "writers/iges.h"

namespace scan::test
{

/// @param millimetresPerUnit what the model says about its unit
inline Format igesFormat(const IgesOptions& options, double millimetresPerUnit = 0.0)
{
  return [=](Model model, OutputFile& file, Execution& execution)
  {
    model.millimetresPerUnit = millimetresPerUnit;
    writeIges(model, options, file, execution);
  };
}

inline Format igesFormat(IgesEntities entities)
{
  return igesFormat({ .entities = entities });
}

} // namespace scan::test
