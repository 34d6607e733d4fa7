// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command_line.h"
#include "filters/base/execution.h"

#include <span>
#include <string>

namespace scan
{

/// Runs the command line once for every file that --batch finds, each in a process of its own, so
/// that no file can spoil another one's result; ends with a table of what came out.
///
/// In names of outputs {name} stands for the name of the file without folder and extension, {n} for
/// its number, from 1. With --resume files whose outputs are all there, and not older than the file
/// and the template, are not done again.
/// @param words the command line
/// @throws Failure: usage; failed when a file failed; cancelled, after the table was told
void runBatch(
  const CommandLine& line, std::span<const std::string> words, const CancelToken& token);

} // namespace scan
