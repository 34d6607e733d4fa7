// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// A vector in single precision that the processor takes at once; the last number is 0.
struct alignas(16) Float4
{
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float none = 0.0F;
};

inline Float4 operator+(const Float4& a, const Float4& b)
{
  return { a.x + b.x, a.y + b.y, a.z + b.z, a.none + b.none };
}
inline Float4 operator-(const Float4& a, const Float4& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z, a.none - b.none };
}
inline Float4 operator*(const Float4& a, float s)
{
  return { a.x * s, a.y * s, a.z * s, a.none * s };
}
inline float dot(const Float4& a, const Float4& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Float4 cross(const Float4& a, const Float4& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x, 0.0F };
}

inline Float4 narrowed(const Vec3& v, double scale)
{
  return { static_cast<float>(v.x * scale), static_cast<float>(v.y * scale),
    static_cast<float>(v.z * scale), 0.0F };
}

} // namespace scan
