// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace scan
{

struct Operation;

/// What the program does, its options and operations.
std::string programHelp();

/// What an operation does, its options with defaults and ranges, and an example.
std::string operationHelp(const Operation& operation);

} // namespace scan
