// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace scan
{

/// Refuses an output that could not be written, before any work is done for it. "-", standard
/// output, is always fine.
/// @throws Error{badParameter} when the file exists and must not be replaced, is a directory, or
///   its folder is missing or not writable
void checkOutput(const std::string& path, bool mayReplace);

/// Whether two names, of files that need not exist, mean one file.
bool isSameFile(const std::string& a, const std::string& b);

/// Removes what outputs in the making have left under a name, ahead of a sudden end of the program.
/// Async-signal-safe.
void removeUnfinishedOutputs() noexcept;

/// Writes a text to a file, which appears only when it is complete, or to standard output ("-").
/// @throws Error{io}
void writeText(const std::string& path, std::string_view text);

} // namespace scan
