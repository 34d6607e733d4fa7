// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/child_process.h"

#include "filters/base/error.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>

extern char** environ;

namespace scan
{

namespace
{

constexpr int kRecord = 3; // the descriptor of the record in the child

[[noreturn]] void fail(int error)
{
  throw Error(
    ErrorCode::io, "cannot start another process: " + std::generic_category().message(error));
}

} // namespace

ChildProcess::ChildProcess(std::vector<std::string> words)
{
  words.insert(words.begin(), "scanwrap");
  words.push_back("--json=/dev/fd/" + std::to_string(kRecord));
  std::vector<char*> arguments;
  std::ranges::transform(
    words, std::back_inserter(arguments), [](std::string& word) { return word.data(); });
  arguments.push_back(nullptr);

  ::posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  std::array<int, 3> ends{ -1, -1, -1 };
  int error = 0;
  for (std::size_t i = 0; i < this->Pipes.size() && error == 0; ++i)
  {
    std::array<int, 2> pipe{};
    error = ::pipe2(pipe.data(), O_CLOEXEC) == 0 ? 0 : errno;
    if (error == 0)
    {
      this->Pipes[i] = pipe[0];
      // above the numbers that the child will use
      ends[i] = ::fcntl(pipe[1], F_DUPFD_CLOEXEC, kRecord + 1);
      ::close(pipe[1]);
      const int target = i == 2 ? kRecord : static_cast<int>(i) + STDOUT_FILENO;
      ::posix_spawn_file_actions_adddup2(&actions, ends[i], target);
    }
  }
  if (error == 0)
  {
    error =
      ::posix_spawn(&this->Id, "/proc/self/exe", &actions, nullptr, arguments.data(), environ);
  }
  ::posix_spawn_file_actions_destroy(&actions);
  std::ranges::for_each(ends, ::close);
  if (error != 0)
  {
    std::ranges::for_each(this->Pipes, ::close);
    fail(error);
  }
}

ChildProcess::~ChildProcess()
{
  while (this->wait(-1))
  {
  }
}

bool ChildProcess::wait(int milliseconds)
{
  if (this->Id < 0)
  {
    return false;
  }
  std::array<::pollfd, 3> events{};
  for (std::size_t i = 0; i < events.size(); ++i)
  {
    events[i] = { this->Pipes[i], POLLIN, 0 };
  }
  ::poll(events.data(), events.size(), milliseconds);
  for (std::size_t i = 0; i < events.size(); ++i)
  {
    if (events[i].revents == 0)
    {
      continue;
    }
    std::array<char, 65536> buffer{};
    const ::ssize_t size = ::read(this->Pipes[i], buffer.data(), buffer.size());
    if (size > 0)
    {
      this->Texts[i].append(buffer.data(), static_cast<std::size_t>(size));
    }
    else if (size == 0 || errno != EINTR)
    {
      ::close(this->Pipes[i]);
      this->Pipes[i] = -1;
    }
  }
  if (std::ranges::any_of(this->Pipes, [](int pipe) { return pipe >= 0; }))
  {
    return true;
  }
  int status = 0;
  while (::waitpid(this->Id, &status, 0) < 0 && errno == EINTR)
  {
  }
  this->Status = WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
  this->Id = -1;
  return false;
}

void ChildProcess::cancel() const
{
  if (this->Id >= 0)
  {
    ::kill(this->Id, SIGTERM);
  }
}

} // namespace scan
