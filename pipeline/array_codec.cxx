// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/array_codec.h"

#include "filters/base/error.h"

#include <zstd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>

namespace scan
{

namespace
{

enum class Way : char
{
  plain,
  packed,
  shuffled,
  differences
};

constexpr int kLevel = 1; // of Zstandard: as fast as disks are
constexpr std::size_t kHeader = 4;

Way wayOf(const ValueLayout& layout)
{
  return layout.width == 1 ? Way::packed : layout.isInteger ? Way::differences : Way::shuffled;
}

/// Byte k of all values, then byte k + 1 of all; values are differences to the one a tuple before.
template <class Value>
void shuffle(std::span<const char> values, std::size_t back, std::span<char> planes)
{
  const std::size_t count = values.size() / sizeof(Value);
  const auto at = [&](std::size_t i)
  {
    Value value{};
    std::memcpy(&value, values.data() + i * sizeof(Value), sizeof(Value));
    return value;
  };
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto difference = static_cast<Value>(at(i) - (back > 0 && i >= back ? at(i - back) : 0));
    for (std::size_t k = 0; k < sizeof(Value); ++k)
    {
      planes[k * count + i] = static_cast<char>(difference >> (8 * k) & 0xff);
    }
  }
}

template <class Value>
void unshuffle(std::span<const char> planes, std::size_t back, std::span<char> values)
{
  const std::size_t count = values.size() / sizeof(Value);
  for (std::size_t i = 0; i < count; ++i)
  {
    Value value = 0;
    for (std::size_t k = 0; k < sizeof(Value); ++k)
    {
      const auto byte = static_cast<unsigned char>(planes[k * count + i]);
      value = static_cast<Value>(value | static_cast<Value>(Value{ byte } << (8 * k)));
    }
    if (back > 0 && i >= back)
    {
      Value before{};
      std::memcpy(&before, values.data() + (i - back) * sizeof(Value), sizeof(Value));
      value = static_cast<Value>(value + before);
    }
    std::memcpy(values.data() + i * sizeof(Value), &value, sizeof(Value));
  }
}

template <class Body>
void forWidth(std::size_t width, const Body& body)
{
  switch (width)
  {
    case 2:
      return body(std::uint16_t{});
    case 4:
      return body(std::uint32_t{});
    default:
      return body(std::uint64_t{});
  }
}

[[noreturn]] void refuse()
{
  throw Error(ErrorCode::parse, "a stored array is damaged");
}

template <class Context>
Context& contextOf(Context* (*make)(), std::size_t (*free)(Context*))
{
  thread_local const std::unique_ptr<Context, std::size_t (*)(Context*)> context(make(), free);
  if (!context)
  {
    throw std::bad_alloc();
  }
  return *context;
}

} // namespace

std::vector<char> encodeValues(std::span<const char> values, const ValueLayout& layout)
{
  const Way way = wayOf(layout);
  std::vector<char> planes;
  std::span<const char> source = values;
  if (way != Way::packed)
  {
    planes.resize(values.size());
    forWidth(layout.width,
      [&]<class Value>(Value)
      { shuffle<Value>(values, way == Way::differences ? layout.components : 0, planes); });
    source = planes;
  }
  std::vector<char> code(kHeader + ZSTD_compressBound(source.size()));
  std::size_t size = ZSTD_compressCCtx(&contextOf(ZSTD_createCCtx, ZSTD_freeCCtx),
    code.data() + kHeader, code.size() - kHeader, source.data(), source.size(), kLevel);
  const bool isSmaller = ZSTD_isError(size) == 0 && size < values.size();
  if (!isSmaller)
  {
    size = values.size();
    std::ranges::copy(values, code.begin() + kHeader);
  }
  code.resize(kHeader + size);
  code[0] = static_cast<char>(isSmaller ? way : Way::plain);
  code[1] = static_cast<char>(layout.width);
  code[2] = static_cast<char>(layout.components & 0xff);
  code[3] = static_cast<char>(layout.components >> 8);
  return code;
}

void decodeValues(std::span<const char> code, std::span<char> values)
{
  if (code.size() < kHeader)
  {
    refuse();
  }
  const auto byte = [&](std::size_t i)
  { return static_cast<std::size_t>(static_cast<unsigned char>(code[i])); };
  const auto way = static_cast<Way>(code[0]);
  const std::size_t width = byte(1);
  const std::size_t components = byte(2) + 256 * byte(3);
  const std::span<const char> body = code.subspan(kHeader);
  if (way == Way::plain && body.size() == values.size())
  {
    std::ranges::copy(body, values.begin());
    return;
  }
  const bool isShuffled = way == Way::shuffled || way == Way::differences;
  const bool isWidth = width == 2 || width == 4 || width == 8;
  if ((!isShuffled && way != Way::packed) || (isShuffled && !isWidth) ||
    (isShuffled && (components == 0 || values.size() % (width * components) != 0)))
  {
    refuse();
  }
  std::vector<char> planes(isShuffled ? values.size() : 0);
  const std::span<char> target = isShuffled ? std::span<char>(planes) : values;
  const std::size_t size = ZSTD_decompressDCtx(&contextOf(ZSTD_createDCtx, ZSTD_freeDCtx),
    target.data(), target.size(), body.data(), body.size());
  if (ZSTD_isError(size) != 0 || size != target.size())
  {
    refuse();
  }
  if (isShuffled)
  {
    forWidth(width,
      [&]<class Value>(Value)
      { unshuffle<Value>(planes, way == Way::differences ? components : 0, values); });
  }
}

} // namespace scan
