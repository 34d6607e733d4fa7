// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/surface/vtkScanSurfaceFilter.h"
#include "pipeline/operation_rows.h"

#include <vtkSmartPointer.h>

#include <utility>
#include <vector>

namespace scan
{

// What the rows of operations on surfaces have in common.

/// The parameters of an operation, and those that every operation on surfaces has.
std::vector<Parameter> surfaceParameters(std::vector<Parameter> own);

/// Sets the common properties.
void setSurfaceProperties(vtkScanSurfaceFilter& filter, const ParameterValues& values);

/// A new filter with the common properties set.
template <class Filter>
vtkSmartPointer<Filter> newSurfaceFilter(const ParameterValues& values)
{
  auto filter = vtkSmartPointer<Filter>::New();
  setSurfaceProperties(*filter, values);
  return filter;
}

/// How many triangles there were and are, what the operation found itself, and how far the surface
/// moved.
Results surfaceResults(const vtkScanSurfaceFilter& filter, const Results& own = {});

Operation mendOperation();
Operation orientOperation();
Operation fillHolesOperation();
Operation bridgeOperation();
Operation refineOperation();
Operation relaxOperation();
Operation decimateOperation();
Operation remeshOperation();
Operation thickenOperation();
Operation offsetOperation();
Operation sharpenOperation();

} // namespace scan
