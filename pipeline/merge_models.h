// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <vector>

class vtkPolyData;

namespace scan
{

/// One model with the points and cells of all parts, in their order. Points stay double; point
/// arrays that every part has are kept, and the unit. A single part is returned as it is.
/// @throws Error{badInput} when the parts have different units, or only some have one
vtkSmartPointer<vtkPolyData> mergeModels(const std::vector<vtkSmartPointer<vtkPolyData>>& parts);

} // namespace scan
