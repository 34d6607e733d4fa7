// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"
#include "filters/base/execution.h"

namespace scan
{

/// Does what the command line asks for: opens the files, runs the verbs, writes the outputs and the
/// record. Everything that can be refused is refused before the first file is read.
/// @throws Failure, after the record is written
void runSession(const CommandLine& line, const CancelToken& token);

} // namespace scan
