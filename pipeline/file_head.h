// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"

#include <string>
#include <vector>

namespace scan
{

/// The first bytes of a file, enough to recognise its format; empty for an empty file.
/// @throws Error{io} for a file that is missing, a directory or unreadable
std::vector<char> headOfFile(const std::string& path);

/// The first bytes of standard input. A pipe is read to its end into memory that takes the pipe's
/// place, so that a reader still finds everything.
/// @throws Error{io}; Cancelled when the token is raised while waiting
std::vector<char> headOfStandardInput(const CancelToken& token);

} // namespace scan
