// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace scan
{

/// The values of an accessor, all of which lie in memory.
struct GltfAccessor
{
  std::size_t index = 0; ///< in the document
  std::size_t count = 0; ///< of elements, at least 1
  int components = 0;    ///< of an element, 1 to 4
  int componentType = 0; ///< 5120 to 5123, 5125 or 5126
  bool isNormalized = false;
  const char* data = nullptr;
  std::size_t stride = 0; ///< bytes from element to element

  /// A component as a number, normalised integers as -1 to 1 or 0 to 1.
  double real(std::size_t element, int component) const;

  /// The first component of an accessor of unsigned integers.
  std::uint32_t integer(std::size_t element) const;

  bool isUnsigned() const;
};

/// The bytes of a component type, 0 for an unknown one.
std::size_t gltfSizeOf(std::size_t componentType);

/// The components of an element type, "SCALAR" to "VEC4", 0 for another one.
int gltfComponentsOf(std::string_view type);

} // namespace scan
