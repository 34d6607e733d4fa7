// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/surface_folds.h"

#include <string>

class vtkPolyData;

namespace scan
{

/// Gives a finished output the folded triangles as the region "folded", by the cell array Folded;
/// without any the region is empty and the array is not there.
/// @param folds per triangle of the output
void markFolds(const SurfaceFolds& folds, vtkPolyData& output);

/// A warning in one line; empty without folds.
std::string describe(const SurfaceFolds& folds);

} // namespace scan
