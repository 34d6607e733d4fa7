// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "tests/readers/usable.h"

#include <cstdio>
#include <cstdlib>
#include <string>

namespace scan::test
{

/// Ends the fuzzer with a message, which makes it keep its input.
inline void require(bool isTrue, const std::string& what)
{
  if (!isTrue)
  {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
  }
}

/// Requires of parse(), which reads something named "file", a usable model or one line of an Error.
template <class Parse>
void requireModelOrError(const Parse& parse)
{
  try
  {
    require(isUsable(parse()), "the model is not usable");
  }
  catch (const Error& error)
  {
    const std::string message = error.what();
    require(message.starts_with("file: ") && message.find('\n') == std::string::npos,
      "not a line about the file: " + message);
  }
}

} // namespace scan::test
