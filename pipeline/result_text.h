// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/result.h"

#include <string>

namespace scan
{

/// A line per result: its name and its value.
std::string tableOf(const Results& results);

} // namespace scan
