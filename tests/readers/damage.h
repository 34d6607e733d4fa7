// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "tests/readers/parsing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace scan::test
{

/// Fails the test when the result is neither Error parse nor a usable model.
template <class Parser>
void expectErrorOrModel(Parser parser, const std::string& bytes, const std::string& what)
{
  try
  {
    const Model model = parse(parser, bytes);
    bool isUsable = model.colors.empty() || model.colors.size() == model.points.size();
    isUsable = isUsable && (model.normals.empty() || model.normals.size() == model.points.size());
    for (const Vec3& p : model.points)
    {
      isUsable = isUsable && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    }
    for (const auto& [a, b, c] : model.triangles)
    {
      isUsable = isUsable && std::max({ a, b, c }) < model.points.size();
    }
    EXPECT_TRUE(isUsable) << what;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::parse) << what << ": " << error.what();
  }
}

/// A good file that is cut and changed: every cut up to the first 4 kB and each 64th behind, every
/// change of a byte likewise with each 97th.
template <class Parser>
void expectErrorOrModelWhenDamaged(Parser parser, const std::string& bytes)
{
  constexpr std::size_t kAll = 4096;
  EXPECT_EQ(parseError(parser, bytes), "");
  for (std::size_t size = 0; size < bytes.size(); size += size < kAll ? 1 : 64)
  {
    expectErrorOrModel(parser, bytes.substr(0, size), "cut at " + std::to_string(size));
  }
  std::string changed = bytes;
  for (std::size_t at = 0; at < bytes.size(); at += at < kAll ? 1 : 97)
  {
    for (const char flip : { '\x01', '\x80', '\xff' })
    {
      changed[at] = static_cast<char>(bytes[at] ^ flip);
      expectErrorOrModel(parser, changed, "changed at " + std::to_string(at));
    }
    changed[at] = bytes[at];
  }
}

} // namespace scan::test
