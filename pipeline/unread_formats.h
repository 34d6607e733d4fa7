// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace scan
{

/// What to do with a file of a format that is known but not read, by how the file starts: "is
/// compressed with gzip; unpack it first". Empty for all others.
std::string adviceOnUnread(std::span<const char> head);

/// The same for a file whose content says nothing, by the extension of its name in lower case.
std::string adviceOnUnreadName(const std::string& extension);

} // namespace scan
