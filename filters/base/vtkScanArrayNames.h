// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Names of the data arrays that filters and readers write.
namespace scan::arrays
{

/// Point data, vtkIdTypeArray: index of the scan point that a vertex came from.
inline constexpr const char* kScanPointId = "ScanPointId";

} // namespace scan::arrays
