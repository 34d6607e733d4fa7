// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"
#include "app/cli/help.h"
#include "app/cli/session.h"
#include "filters/base/error.h"
#include "pipeline/output_files.h"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>

#include <fmt/format.h>
#include <sys/resource.h>

#include <csignal>
#include <new>
#include <string>
#include <vector>

namespace
{

using scan::ExitStatus;

/// Raised by the signal handler, hence global.
const scan::CancelToken kInterrupted;

void handleSignals()
{
  struct sigaction action = {};
  action.sa_handler = [](int) { kInterrupted.cancel(); };
  action.sa_flags = static_cast<int>(SA_RESETHAND); // a second Ctrl-C ends the program at once
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  // a limit on file sizes and a closed pipe become errors of the write
  ::signal(SIGXFSZ, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
}

void limitMemory(std::int64_t bytes)
{
  if (bytes > 0)
  {
    const rlimit limit{ static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes) };
    ::setrlimit(RLIMIT_DATA, &limit);
  }
}

void run(const std::vector<std::string>& words)
{
  using Action = scan::CommandLine::Action;
  const scan::CommandLine line = scan::parseCommandLine(words);
  switch (line.action)
  {
    case Action::help:
      scan::writeText(
        "-", line.helpVerb != nullptr ? scan::operationHelp(*line.helpVerb) : scan::programHelp());
      return;
    case Action::version:
      scan::writeText("-", "scanwrap " SCAN_VERSION "\n");
      return;
    case Action::run:
      limitMemory(line.maxMemory);
      scan::runSession(line, kInterrupted);
      return;
  }
}

int fail(ExitStatus status, const char* message)
{
  fmt::print(stderr, "scanwrap: {}\n", message);
  return static_cast<int>(status);
}

} // namespace

int main(int argc, char** argv)
{
  handleSignals();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // errors are reported once, by us
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  try
  {
    run({ argv + 1, argv + argc });
    return static_cast<int>(ExitStatus::done);
  }
  catch (const scan::Failure& failure)
  {
    return fail(failure.status(), failure.what());
  }
  catch (const scan::Error& error)
  {
    return fail(
      error.code() == scan::ErrorCode::badParameter ? ExitStatus::usage : ExitStatus::failed,
      error.what());
  }
  catch (const std::bad_alloc&)
  {
    return fail(ExitStatus::overMemory, "out of memory; allow more or use fewer points");
  }
  catch (const std::exception& error)
  {
    return fail(ExitStatus::failed, error.what());
  }
}
