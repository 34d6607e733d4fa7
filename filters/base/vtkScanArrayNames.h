// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Names of the data arrays that filters and readers write.
namespace scan::arrays
{

/// Point data, vtkIdTypeArray: index of the scan point that a vertex came from.
inline constexpr const char* kScanPointId = "ScanPointId";

/// Point data, three unsigned bytes: red, green, blue. They are the scalars.
inline constexpr const char* kColors = "Colors";

/// Point data, three doubles: unit vectors, or 0 0 0. They are the normals.
inline constexpr const char* kNormals = "Normals";

/// Field data, one double: the unit of the coordinates in millimetres, where a file says so.
inline constexpr const char* kMillimetresPerUnit = "MillimetresPerUnit";

/// Field data of a model that several files make: their names, a vtkStringArray, and for each the
/// scan-point id behind its last point, a vtkIdTypeArray. So ScanPointId tells the file, too.
inline constexpr const char* kScanFileNames = "ScanFileNames";
inline constexpr const char* kScanFileEnds = "ScanFileEnds";

/// Field data: the names of the regions that the model carries and their rules as text, two
/// vtkStringArrays.
inline constexpr const char* kRegionNames = "RegionNames";
inline constexpr const char* kRegionRules = "RegionRules";

/// Cell data, unsigned bytes: 1 where the surface folds onto itself, 0 elsewhere.
inline constexpr const char* kFolded = "Folded";

/// Cell data, unsigned bytes: which triangles are halves of one that refining has cut in two, as
/// scan::halfMark() says. What no longer fits is ignored.
inline constexpr const char* kHalf = "Half";

/// Cell and field data of wraps: see vtkScanWrapData.
inline constexpr const char* kBlock = "Block";
inline constexpr const char* kBlockSize = "BlockSize";
inline constexpr const char* kBlockPersistence = "BlockPersistence";
inline constexpr const char* kBlockSizes = "BlockSizes";
inline constexpr const char* kBlockPersistences = "BlockPersistences";
inline constexpr const char* kBlockRemoved = "BlockRemoved";

} // namespace scan::arrays
