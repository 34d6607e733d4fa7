// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command_line.h"

#include <chrono>
#include <string>
#include <string_view>

namespace scan
{

/// Shows on stderr how far a step is: a bar that overwrites itself, or JSON lines
/// {"verb":"wrap","phase":"delaunay","fraction":0.25}. At most ten times a second.
class TerminalProgress
{
public:
  explicit TerminalProgress(ProgressMode mode, bool isQuiet);

  /// Names the step that the next shows belong to.
  void start(const std::string& verb);
  void show(std::string_view phase, double fraction);
  /// Removes the bar.
  void finish();

private:
  enum class Form
  {
    none,
    bar,
    json
  };
  Form Shown = Form::none;
  std::string Verb;
  std::chrono::steady_clock::time_point Next;
  bool IsBarVisible = false;
};

} // namespace scan
