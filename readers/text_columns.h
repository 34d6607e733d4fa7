// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "readers/text_scanner.h"

/// Columns of numbers, separated by blanks, tabs, one comma or one semicolon. As in text_scanner.h
/// all functions take [at, end).
namespace scan
{

/// Whether a comment starts at `at`, which is not the end.
inline bool isComment(const char* at, const char* end)
{
  return *at == '#' || *at == '!' || *at == '%' || (*at == '/' && at + 1 != end && at[1] == '/');
}

inline bool isColumnEnd(const char* at, const char* end)
{
  return at == end || isSeparator(*at) || isLineEnd(*at);
}

inline const char* skipSeparator(const char* at, const char* end)
{
  at = skipBlanks(at, end);
  if (at != end && (*at == ',' || *at == ';'))
  {
    at = skipBlanks(at + 1, end);
  }
  return at;
}

/// A column that holds a number; nullptr when it does not.
inline const char* parseColumn(const char* at, const char* end, double& value)
{
  at = parseNumber(at, end, value);
  return at != nullptr && isColumnEnd(at, end) ? at : nullptr;
}

} // namespace scan
