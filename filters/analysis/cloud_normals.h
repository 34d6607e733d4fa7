// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/mesh.h"

#include <vtkFloatArray.h>
#include <vtkSmartPointer.h>

class vtkPolyData;

namespace scan
{

/// Per point the normal of the plane through its nearest points, turned towards the eye.
///
/// As vtkPCANormalEstimation, which cannot be cancelled: on a million points it takes seconds.
/// The same normals on any number of threads. Reports and checks the phase "shade".
vtkSmartPointer<vtkFloatArray> cloudNormals(
  vtkPolyData& cloud, const Vec3& eye, Execution& execution);

} // namespace scan
