// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"

#include <cstdint>
#include <string_view>

/// What the program owes the shell that runs it: descriptors, signals, memory limit.
namespace scan
{

/// Takes the places of standard descriptors that the caller closed, so that no file of ours gets
/// their numbers; using one remains an error. Before any file is opened.
void reserveStandardDescriptors();

/// SIGINT, SIGTERM and SIGHUP raise the token. Work that does not answer within 0.25 s, inside a
/// library or on a pipe that nobody reads, is then ended with the status of a cancel; outputs have
/// their names only when complete. A second signal ends the program at once.
void cancelOnSignals(const CancelToken& token);

/// The work is over: a cancel that comes now is too late.
void forgetCancel();

/// No more memory than this; libraries that crash for want of it end the program with the status
/// overMemory.
void limitMemory(std::int64_t bytes);

/// Writes to stderr; there is nobody to tell if that fails.
void say(std::string_view text) noexcept;

} // namespace scan
