// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/array_codec.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

using namespace scan;

namespace
{

template <class Value>
std::vector<char> bytesOf(const std::vector<Value>& values)
{
  std::vector<char> bytes(values.size() * sizeof(Value));
  if (!values.empty())
  {
    std::memcpy(bytes.data(), values.data(), bytes.size());
  }
  return bytes;
}

void expectRoundTrip(const std::vector<char>& values, const ValueLayout& layout)
{
  const std::vector<char> code = encodeValues(values, layout);
  std::vector<char> decoded(values.size());
  decodeValues(code, decoded);
  EXPECT_EQ(decoded, values);
  EXPECT_LE(code.size(), values.size() + 4);
}

} // namespace

TEST(ArrayCodec, GivesBackEveryValue)
{
  std::mt19937_64 random(1);
  for (const std::size_t count : { 0, 1, 7, 1000, 10007 })
  {
    for (const std::size_t components : { 1, 3, 4 })
    {
      std::vector<std::uint8_t> bytes(count * components);
      std::vector<std::uint16_t> shorts(count * components);
      std::vector<std::uint32_t> indices(count * components);
      std::vector<std::int64_t> ids(count * components);
      std::vector<double> reals(count * components);
      for (std::size_t i = 0; i < count * components; ++i)
      {
        bytes[i] = static_cast<std::uint8_t>(random() % 3 * 16);
        shorts[i] = static_cast<std::uint16_t>(random());
        indices[i] = i % 5 == 0 ? 0xffffffffU : static_cast<std::uint32_t>(i / 3 + random() % 100);
        ids[i] = static_cast<std::int64_t>(random());
        reals[i] = std::sin(static_cast<double>(i)) * 1e6;
      }
      expectRoundTrip(bytesOf(bytes), { 1, components, true });
      expectRoundTrip(bytesOf(shorts), { 2, components, true });
      expectRoundTrip(bytesOf(indices), { 4, components, true });
      expectRoundTrip(bytesOf(ids), { 8, components, true });
      expectRoundTrip(bytesOf(reals), { 8, components, false });
    }
  }
}

TEST(ArrayCodec, MakesCountedNumbersSmall)
{
  std::vector<std::uint32_t> offsets(60000);
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    offsets[i] = static_cast<std::uint32_t>(3 * i);
  }
  EXPECT_LT(encodeValues(bytesOf(offsets), { 4, 1, true }).size(), 500U);
}

TEST(ArrayCodec, RefusesDamagedCodes)
{
  const std::vector<char> values(1200, 'a');
  const std::vector<char> code = encodeValues(values, { 4, 3, true });
  std::vector<char> decoded(values.size());
  std::vector<char> longer(values.size() + 12);
  EXPECT_THROW(decodeValues(code, longer), Error);
  for (std::size_t size = 0; size < code.size(); ++size)
  {
    EXPECT_THROW(decodeValues({ code.data(), size }, decoded), Error) << size;
  }
  // whatever is changed, nothing is written behind the end (a sanitizer would tell)
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i)
  {
    std::vector<char> changed = code;
    changed[random() % changed.size()] = static_cast<char>(random());
    try
    {
      decodeValues(changed, decoded);
    }
    catch (const Error&)
    {
      continue;
    }
  }
}
