// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/affine.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// Where a scan belongs.
struct ScanTransform
{
  std::string name; ///< of the file, as the list gives it
  Affine place;     ///< from the scan to the model
};

/// Reads a list that places scans. It holds, for each scan, its name and behind it, on as many
/// lines as you like, one of:
/// - 16 numbers: the rows of a matrix, which is multiplied with (x y z 1) from the left; the last
///   row is 0 0 0 1. 12 numbers are its first three rows;
/// - 7 numbers: a translation x y z and a rotation as a quaternion x y z w, which need not be of
///   length 1: rotate, then translate.
/// A name with blanks, or one that is a number, stands in double quotes. # starts a comment.
///
/// Also reads the lists of Stanford's scans (.conf: "bmesh NAME tx ty tz qx qy qz qw", where the
/// quaternion turns the other way) and of MeshLab (.aln: the number of scans, then 16 numbers for
/// each behind a line #, and a 0 at the end).
///
/// Throws Error parse, with the line, for another number of numbers, for one that is not finite,
/// for a matrix that is no affine one or flattens the scan, for a name that stands there twice and
/// for a list without a scan.
std::vector<ScanTransform> parseTransforms(std::span<const char> bytes, std::string_view name);

/// The transform of a file: that of its name, with its folder or without it, with or without
/// extension. Null when the list has none.
const ScanTransform* findTransform(
  const std::vector<ScanTransform>& transforms, const std::string& path);

} // namespace scan
