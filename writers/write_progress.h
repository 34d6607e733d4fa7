// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"

#include <cstddef>

namespace scan
{

/// Counts records of the phase "write" and reports now and then; throws Cancelled.
class WriteProgress
{
public:
  /// @param total how many times next() will be called
  WriteProgress(Execution& execution, std::size_t total)
    : Run(execution)
    , Total(total)
  {
  }

  /// Ahead of each record.
  void next()
  {
    constexpr std::size_t kStep = 1U << 15U;
    if (this->Done++ % kStep == 0)
    {
      this->Run.step("write", this->Done - 1, this->Total);
    }
  }

private:
  Execution& Run;
  std::size_t Total;
  std::size_t Done = 0;
};

} // namespace scan
