// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/process.h"

#include "app/cli/exit_status.h"
#include "pipeline/output_files.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <optional>

namespace scan
{

namespace
{

constexpr suseconds_t kPatience = 250000; // microseconds; the end itself takes time, too

/// Raised by the signal handler, hence global.
std::optional<CancelToken> cancelToken;

/// Async-signal-safe.
[[noreturn]] void leave(ExitStatus status, std::string_view message)
{
  removeUnfinishedOutputs();
  say(message);
  ::_exit(static_cast<int>(status));
}

void setPatience(suseconds_t microseconds)
{
  const itimerval timer = { {}, { 0, microseconds } };
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void onSignal(int)
{
  cancelToken->cancel();
  setPatience(kPatience);
}

void onTimeout(int)
{
  // behind the progress bar, if there is one
  leave(ExitStatus::cancelled,
    ::isatty(STDERR_FILENO) != 0 ? "\r\x1b[Kscanwrap: cancelled\n" : "scanwrap: cancelled\n");
}

void onCrash(int)
{
  leave(ExitStatus::overMemory,
    "scanwrap: a library crashed under the memory limit; allow more with --max-memory\n");
}

void onLostInput(int)
{
  leave(ExitStatus::usage,
    "scanwrap: an input became shorter while it was read; run again when it is complete\n");
}

void handle(int signal, void (*handler)(int), int flags = 0)
{
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  ::sigaction(signal, &action, nullptr);
}

} // namespace

void reserveStandardDescriptors()
{
  for (const int descriptor : { STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO })
  {
    if (::fcntl(descriptor, F_GETFD) < 0)
    {
      // the lowest free number is this one; opened the wrong way round
      [[maybe_unused]] const int same =
        ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

void cancelOnSignals(const CancelToken& token)
{
  cancelToken = token;
  handle(SIGALRM, onTimeout);
  handle(SIGINT, onSignal, static_cast<int>(SA_RESETHAND));
  handle(SIGTERM, onSignal, static_cast<int>(SA_RESETHAND));
  struct sigaction hangUp = {};
  ::sigaction(SIGHUP, nullptr, &hangUp);
  if (hangUp.sa_handler != SIG_IGN) // nohup
  {
    handle(SIGHUP, onSignal, static_cast<int>(SA_RESETHAND));
  }
  handle(SIGBUS, onLostInput);
  // a limit on file sizes and a closed pipe become errors of the write
  handle(SIGXFSZ, SIG_IGN);
  handle(SIGPIPE, SIG_IGN);
}

void forgetCancel()
{
  handle(SIGALRM, SIG_IGN);
  setPatience(0);
}

void limitMemory(std::int64_t bytes)
{
  if (bytes > 0)
  {
    const rlimit limit{ static_cast<rlim_t>(bytes), static_cast<rlim_t>(bytes) };
    ::setrlimit(RLIMIT_DATA, &limit);
    handle(SIGSEGV, onCrash);
    handle(SIGABRT, onCrash);
  }
}

void say(std::string_view text) noexcept
{
  while (!text.empty())
  {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0)
    {
      return;
    }
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

} // namespace scan
