// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace scan
{

/// What went wrong, for whoever has to react: the exit status, a dialog, a batch report.
enum class ErrorCode
{
  badInput,     ///< the data cannot be used by this operation (too few points, all coplanar, ...)
  badParameter, ///< a parameter is malformed or out of its range
  parse,        ///< a file's content is malformed; the message carries the line or byte offset
  io,           ///< a file cannot be opened, read, written or renamed
  memory,       ///< the memory budget or the machine's memory is exhausted
  limit,        ///< a format or index limit is exceeded
  internal      ///< a broken invariant: our bug
};

/// Every failure of VTK-free code. The message says what, where and what to do, in one line.
class Error : public std::runtime_error
{
public:
  Error(ErrorCode code, const std::string& message)
    : std::runtime_error(message)
    , Code(code)
  {
  }

  ErrorCode code() const noexcept { return this->Code; }

private:
  ErrorCode Code;
};

/// Thrown by Execution when the user cancelled; never an error.
class Cancelled : public std::exception
{
public:
  const char* what() const noexcept override { return "cancelled"; }
};

} // namespace scan
