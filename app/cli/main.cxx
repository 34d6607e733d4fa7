// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch.h"
#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"
#include "app/cli/help.h"
#include "app/cli/process.h"
#include "app/cli/session.h"
#include "filters/base/error.h"
#include "pipeline/output_files.h"

#include <vtkLogger.h>
#include <vtkOutputWindow.h>

#include <malloc.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace
{

using scan::ExitStatus;

void run(const std::vector<std::string>& words, const scan::CancelToken& token)
{
  using Action = scan::CommandLine::Action;
  const scan::CommandLine line = scan::parseCommandLine(words);
  switch (line.action)
  {
    case Action::help:
      scan::writeText(
        "-", line.helpVerb != nullptr ? scan::operationHelp(*line.helpVerb) : scan::programHelp());
      return;
    case Action::formats:
      scan::writeText("-", scan::formatTable());
      return;
    case Action::version:
      scan::writeText("-", "scanwrap " SCAN_VERSION "\n");
      return;
    case Action::run:
      if (!line.batch.empty())
      {
        scan::runBatch(line, words, token);
        return;
      }
      scan::limitMemory(line.maxMemory);
      scan::runSession(line, token);
      return;
  }
}

/// One line on stderr, whatever names of files hold.
int fail(ExitStatus status, std::string message)
{
  std::ranges::replace_if(
    message, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  scan::say("scanwrap: " + message + "\n");
  return static_cast<int>(status);
}

int statusOf(const std::vector<std::string>& words, const scan::CancelToken& token)
{
  try
  {
    run(words, token);
    scan::forgetCancel();
    return static_cast<int>(ExitStatus::done);
  }
  catch (const scan::Failure& failure)
  {
    scan::forgetCancel();
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

} // namespace

int main(int argc, char** argv)
{
  const scan::CancelToken token;
  scan::reserveStandardDescriptors();
  scan::cancelOnSignals(token);
  // each phase uses the pages of the last: fresh ones are slow
  ::mallopt(M_MMAP_MAX, 0);                                // NOLINT(concurrency-mt-unsafe): alone
  ::mallopt(M_TRIM_THRESHOLD, INT_MAX);                    // NOLINT(concurrency-mt-unsafe): alone
  ::setenv("EGL_LOG_LEVEL", "fatal", 0);                   // NOLINT(concurrency-mt-unsafe): alone
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // errors are reported once, by us
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  return statusOf({ argv + 1, argv + argc }, token);
}
