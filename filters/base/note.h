// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace scan
{

/// Adds a text to a note, which is one line; an empty text adds nothing.
inline void addToNote(std::string& note, const std::string& text)
{
  note.append(note.empty() || text.empty() ? "" : "; ").append(text);
}

} // namespace scan
