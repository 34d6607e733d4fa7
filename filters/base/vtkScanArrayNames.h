// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Names of the data arrays that filters and readers write.
namespace scan::arrays
{

/// Point data, vtkIdTypeArray: index of the scan point that a vertex came from.
inline constexpr const char* kScanPointId = "ScanPointId";

/// Cell and field data of wraps: see vtkScanWrapData.
inline constexpr const char* kBlock = "Block";
inline constexpr const char* kBlockSize = "BlockSize";
inline constexpr const char* kBlockPersistence = "BlockPersistence";
inline constexpr const char* kBlockSizes = "BlockSizes";
inline constexpr const char* kBlockPersistences = "BlockPersistences";
inline constexpr const char* kBlockRemoved = "BlockRemoved";

} // namespace scan::arrays
