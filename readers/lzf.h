// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"

#include <span>

namespace scan
{

/// Expands LZF data (LibLZF's stream without a header) into exactly the bytes of `output`. Phase
/// "read", to its half.
/// @return false, with any output, when the data are malformed or give more or fewer bytes
bool expandLzf(std::span<const char> input, std::span<char> output, Execution& execution);

} // namespace scan
