// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace scan
{

/// Peak resident memory of the program since the construction of the object. Where the system does
/// not let a program reset its peak, since the program's start; 0 where it does not tell.
class PeakMemory
{
public:
  PeakMemory();
  std::int64_t bytes() const;
};

} // namespace scan
