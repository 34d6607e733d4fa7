// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace scan
{

/// Peak resident memory of the program since its start, in bytes: never falls, and agrees with what
/// the system reports from outside. 0 where the system does not tell.
std::int64_t peakMemory();

} // namespace scan
