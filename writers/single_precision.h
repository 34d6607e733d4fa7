// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>
#include <string>
#include <vector>

/// What formats with coordinates of float32 do to a model.
namespace scan
{

/// The nearest float32. Out of line: where GCC 12 vectorizes a conversion there and back it leaves
/// out both.
std::array<float, 3> asFloats(const Vec3& point);

Vec3 roundedToFloat(const Vec3& point);

/// Throws Error limit when a coordinate exceeds what a float32 of the format holds.
void requireFloatRange(const TriMesh& mesh, const std::string& file, const std::string& format);

/// What coordinates had better be stored relative to: the middle of the model when it is further
/// from the origin than it is large and float32 does not hold every coordinate; else 0 0 0.
Vec3 originForFloats(const std::vector<Vec3>& points);

/// The points as float32, from an origin on.
std::vector<Vec3> roundedToFloat(const std::vector<Vec3>& points, const Vec3& origin = {});

/// One line on what rounding to float32 does to a model that is far from the origin: when it moves
/// a point by more than a millionth of the diagonal of the bounding box; else empty.
std::string noteOnRounding(const std::vector<Vec3>& points);

} // namespace scan
