// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "tests/readers/parsing.h"
#include "tests/readers/usable.h"

#include <gtest/gtest.h>

#include <string>

namespace scan::test
{

using ModelParser = Model (*)(std::span<const char>, std::string_view, Execution&);

/// Fails the test when the bytes end in neither a usable model nor Error parse.
inline void expectErrorOrModel(
  ModelParser parser, const std::string& bytes, const std::string& what)
{
  try
  {
    EXPECT_TRUE(isUsable(parse(parser, bytes))) << what;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::parse) << what << ": " << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << what;
  }
}

/// Cuts the file at every `cut`th byte and flips the bits of every `flip`th.
inline void expectNoDamageCrashes(
  ModelParser parser, const std::string& bytes, std::size_t cut = 64, std::size_t flip = 97)
{
  for (std::size_t size = 0; size < bytes.size(); size += cut)
  {
    expectErrorOrModel(parser, bytes.substr(0, size), "cut at " + std::to_string(size));
  }
  for (std::size_t at = 0; at < bytes.size(); at += flip)
  {
    for (const unsigned mask : { 0xffU, 0x80U, 0x01U, 0x10U })
    {
      std::string flipped = bytes;
      flipped[at] = static_cast<char>(static_cast<unsigned char>(flipped[at]) ^ mask);
      expectErrorOrModel(parser, flipped, "flipped at " + std::to_string(at));
    }
  }
}

} // namespace scan::test
