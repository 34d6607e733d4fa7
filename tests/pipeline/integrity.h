// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sqlite3.h>

#include <string>

/// What SQLite itself says of a whole file: "ok".
inline std::string integrityOf(const std::string& path)
{
  sqlite3* handle = nullptr;
  std::string answer;
  sqlite3_open(path.c_str(), &handle);
  sqlite3_exec(
    handle, "PRAGMA integrity_check",
    [](void* text, int, char** values, char**)
    {
      *static_cast<std::string*>(text) += values[0];
      return 0;
    },
    &answer, nullptr);
  sqlite3_close(handle);
  return answer;
}
