// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gltf_accessor.h"

#include "readers/little_endian.h"

#include <algorithm>
#include <array>

namespace scan
{

double GltfAccessor::real(std::size_t element, int component) const
{
  const char* const at = this->data + element * this->stride;
  const auto integer = [&]<class Int>(Int, double largest)
  {
    const auto value = static_cast<double>(loadLittle<Int>(at + sizeof(Int) * component));
    return this->isNormalized ? std::max(value / largest, -1.0) : value;
  };
  switch (this->componentType)
  {
    case 5120:
      return integer(std::int8_t(), 127.0);
    case 5121:
      return integer(std::uint8_t(), 255.0);
    case 5122:
      return integer(std::int16_t(), 32767.0);
    case 5123:
      return integer(std::uint16_t(), 65535.0);
    case 5125:
      return integer(std::uint32_t(), 4294967295.0);
    default:
      return loadLittle<float>(at + sizeof(float) * component);
  }
}

std::uint32_t GltfAccessor::integer(std::size_t element) const
{
  const char* const at = this->data + element * this->stride;
  switch (this->componentType)
  {
    case 5121:
      return loadLittle<std::uint8_t>(at);
    case 5123:
      return loadLittle<std::uint16_t>(at);
    default:
      return loadLittle<std::uint32_t>(at);
  }
}

bool GltfAccessor::isUnsigned() const
{
  return this->componentType == 5121 || this->componentType == 5123 || this->componentType == 5125;
}

std::size_t gltfSizeOf(std::size_t componentType)
{
  static constexpr std::array<std::size_t, 7> kSizes = { 1, 1, 2, 2, 0, 4, 4 };
  return componentType >= 5120 && componentType < 5120 + kSizes.size()
    ? kSizes[componentType - 5120]
    : 0;
}

int gltfComponentsOf(std::string_view type)
{
  return type == "SCALAR" ? 1 : type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 0;
}

} // namespace scan
