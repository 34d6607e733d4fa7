// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/runner.h"

#include <stdexcept>
#include <string>

namespace scan
{

/// What the program returns to the shell.
enum class ExitStatus
{
  done = 0,
  failed = 1,      ///< an operation failed, or an output could not be written
  usage = 2,       ///< a wrong command line or an unreadable input
  checkFailed = 3, ///< a check that the caller asked for
  cancelled = 4,
  overMemory = 5
};

/// Ends the program with a status and one line for the user.
class Failure : public std::runtime_error
{
public:
  Failure(ExitStatus status, const std::string& message)
    : std::runtime_error(message)
    , Status(status)
  {
  }

  ExitStatus status() const noexcept { return this->Status; }

private:
  ExitStatus Status;
};

} // namespace scan
