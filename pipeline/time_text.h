// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace scan
{

/// Now, as 2026-01-31T23:59:59Z.
std::string timeText();

/// When a file was changed; empty when it is not there.
std::string timeTextOfFile(const std::string& path);

} // namespace scan
