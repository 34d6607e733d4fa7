// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal_progress.h"

#include "app/cli/process.h"

#include <fmt/format.h>
#include <unistd.h>

namespace scan
{

TerminalProgress::TerminalProgress(ProgressMode mode, bool isQuiet)
{
  if (mode == ProgressMode::json)
  {
    this->Shown = Form::json;
  }
  else if (mode == ProgressMode::automatic && !isQuiet && ::isatty(STDERR_FILENO) != 0)
  {
    this->Shown = Form::bar;
  }
}

void TerminalProgress::start(const std::string& verb)
{
  this->Verb = verb;
  this->Next = {};
}

void TerminalProgress::show(std::string_view phase, double fraction)
{
  const auto now = std::chrono::steady_clock::now();
  if (this->Shown == Form::none || (now < this->Next && fraction < 1.0))
  {
    return;
  }
  this->Next = now + std::chrono::milliseconds(100);
  if (this->Shown == Form::json)
  {
    // verbs and phases are words of ours: nothing in them needs escaping
    say(fmt::format(
      "{{\"verb\":\"{}\",\"phase\":\"{}\",\"fraction\":{:.4f}}}\n", this->Verb, phase, fraction));
    return;
  }
  constexpr int kWidth = 30;
  const auto filled = static_cast<int>(fraction * kWidth);
  say(fmt::format("\r\x1b[K{:<10} [{:#<{}}{:.<{}}] {:3.0f}% {}", this->Verb, "", filled, "",
    kWidth - filled, fraction * 100.0, phase));
  this->IsBarVisible = true;
}

void TerminalProgress::finish()
{
  if (this->IsBarVisible)
  {
    say("\r\x1b[K");
    this->IsBarVisible = false;
  }
}

} // namespace scan
