// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "tests/writers/written.h"
#include "writers/iges.h"

namespace scan::test
{

/// @param millimetresPerUnit what the model says about its unit
inline Format igesFormat(const IgesOptions& options, double millimetresPerUnit = 0.0)
{
  return [=](const TriMesh& mesh, OutputFile& file, Execution& execution)
  {
    Model model;
    static_cast<TriMesh&>(model) = mesh;
    model.millimetresPerUnit = millimetresPerUnit;
    writeIges(model, options, file, execution);
  };
}

inline Format igesFormat(IgesEntities entities)
{
  return igesFormat({ .entities = entities });
}

} // namespace scan::test
