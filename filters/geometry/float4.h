// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

namespace scan
{

/// A vector in single precision that the processor takes at once; the last number is 0. Not
/// initialised unless by {}, as arrays of millions are written next.
struct Float4
{
  using Lanes [[gnu::vector_size(16)]] = float; // of GCC and Clang; compilers miss it in loops
  Lanes lanes;
};

inline Float4 operator+(const Float4& a, const Float4& b)
{
  return { a.lanes + b.lanes };
}
inline Float4 operator-(const Float4& a, const Float4& b)
{
  return { a.lanes - b.lanes };
}
inline Float4 operator*(const Float4& a, float s)
{
  return { a.lanes * s };
}
inline float dot(const Float4& a, const Float4& b)
{
  const Float4 product{ a.lanes * b.lanes };
  return product.lanes[0] + product.lanes[1] + product.lanes[2];
}
inline Float4 cross(const Float4& a, const Float4& b)
{
  const auto& u = a.lanes;
  const auto& v = b.lanes;
  return { Float4::Lanes{
    u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0], 0.0F } };
}

inline Float4 narrowed(const Vec3& v, double scale)
{
  return { Float4::Lanes{ static_cast<float>(v.x * scale), static_cast<float>(v.y * scale),
    static_cast<float>(v.z * scale), 0.0F } };
}
inline Vec3 widened(const Float4& v, double scale)
{
  return Vec3{ v.lanes[0], v.lanes[1], v.lanes[2] } * scale;
}

} // namespace scan
