// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/readers/parsing.h"
#include "tests/readers/usable.h"

#include <gtest/gtest.h>

#include <string>

namespace scan::test
{

/// Fails the test when the bytes end in neither a usable model nor Error parse, in one line.
template <class Parser>
void expectErrorOrModel(Parser parser, const std::string& bytes, const std::string& what)
{
  try
  {
    EXPECT_TRUE(isUsable(parse(parser, bytes))) << what;
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    EXPECT_EQ(error.code(), ErrorCode::parse) << what << ": " << message;
    EXPECT_TRUE(message.starts_with("file: ")) << what << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << what << ": " << message;
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
    for (const char flip : { '\x01', '\x10', '\x80', '\xff' })
    {
      changed[at] = static_cast<char>(bytes[at] ^ flip);
      expectErrorOrModel(parser, changed, "changed at " + std::to_string(at));
    }
    changed[at] = bytes[at];
  }
}

} // namespace scan::test
