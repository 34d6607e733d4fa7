// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/isolated_run.h"

#include "filters/base/error.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdint>
#include <new>
#include <system_error>
#include <type_traits>

namespace scan
{
namespace
{

using Work = std::function<Model(const ReportFraction& report)>;

constexpr int kPollMilliseconds = 50;

/// What the copy sends, each followed by `count` items.
enum class Kind : std::uint32_t
{
  fraction, // double
  points,
  triangles,
  curveCorners,
  curveEnds,
  colors,
  normals,
  unit,  // double
  note,  // characters
  error, // characters
  done
};

struct Frame
{
  Kind kind = Kind::done;
  ErrorCode code = ErrorCode::internal; // of an error
  std::uint64_t count = 0;
};

// ---- the copy

void send(int pipe, const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t put = ::write(pipe, at, size);
    if (put < 0 && errno != EINTR)
    {
      ::_exit(1); // nobody listens
    }
    at += std::max<ssize_t>(put, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(put, 0));
  }
}

template <class Items>
void send(int pipe, Frame frame, const Items& items)
{
  frame.count = items.size();
  send(pipe, &frame, sizeof(frame));
  send(pipe, items.data(), items.size() * sizeof(items[0]));
}

void detach()
{
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit none = { 0, 0 };
  ::setrlimit(RLIMIT_CORE, &none);
  // the parent decides what an interrupt means
  for (const int signal : { SIGINT, SIGTERM, SIGHUP, SIGQUIT })
  {
    std::signal(signal, SIG_IGN);
  }
  for (const int signal : { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE, SIGCHLD })
  {
    std::signal(signal, SIG_DFL);
  }
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(nothing, STDERR_FILENO);
  std::setlocale(LC_ALL, "C"); // NOLINT(concurrency-mt-unsafe): alone
}

[[noreturn]] void runCopy(const Work& work, int pipe) noexcept
{
  detach();
  const auto fail = [&](ErrorCode code, const std::string& message) {
    send(pipe, { Kind::error, code }, message);
  };
  try
  {
    const Model model = work(
      [&](double fraction) { send(pipe, { Kind::fraction }, std::vector<double>{ fraction }); });
    send(pipe, { Kind::points }, model.points);
    send(pipe, { Kind::triangles }, model.triangles);
    send(pipe, { Kind::curveCorners }, model.curves.corners);
    send(pipe, { Kind::curveEnds }, model.curves.ends);
    send(pipe, { Kind::colors }, model.colors);
    send(pipe, { Kind::normals }, model.normals);
    send(pipe, { Kind::unit }, std::vector<double>{ model.millimetresPerUnit });
    send(pipe, { Kind::note }, model.note);
    send(pipe, { Kind::done }, std::string());
  }
  catch (const Error& error)
  {
    fail(error.code(), error.what());
  }
  catch (const std::bad_alloc&)
  {
    fail(ErrorCode::memory, "not enough memory");
  }
  catch (...)
  {
    ::_exit(1);
  }
  ::_exit(0); // nothing of the parent's is flushed or destroyed
}

// ---- the parent

/// A pipe, and the process that writes to it; killed unless it has ended.
class Copy
{
public:
  Copy(const Work& work, Execution& execution)
    : Run(execution)
  {
    int ends[2] = { -1, -1 };
    if (::pipe2(ends, O_CLOEXEC) != 0)
    {
      failToStart();
    }
    this->Pipe = ends[0];
    this->Process = ::fork();
    if (this->Process == 0)
    {
      runCopy(work, ends[1]);
    }
    const int error = errno;
    ::close(ends[1]);
    if (this->Process < 0)
    {
      ::close(this->Pipe);
      errno = error;
      failToStart();
    }
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  ~Copy()
  {
    ::kill(this->Process, SIGKILL);
    while (::waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
    {
    }
    ::close(this->Pipe);
  }

  /// False at the end of the pipe.
  bool receive(void* data, std::size_t size)
  {
    char* at = static_cast<char*>(data);
    while (size > 0)
    {
      this->waitForBytes();
      const ssize_t got = ::read(this->Pipe, at, size);
      if (got == 0 || (got < 0 && errno != EINTR))
      {
        return false;
      }
      at += std::max<ssize_t>(got, 0);
      size -= static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    return true;
  }

  template <class Items>
  bool receive(std::uint64_t count, Items& items)
  {
    static_assert(std::is_trivially_copyable_v<typename Items::value_type>);
    items.resize(count);
    return this->receive(items.data(), items.size() * sizeof(items[0]));
  }

private:
  [[noreturn]] static void failToStart()
  {
    throw Error(
      ErrorCode::memory, "cannot start a process: " + std::generic_category().message(errno));
  }

  void waitForBytes()
  {
    pollfd state = { this->Pipe, POLLIN, 0 };
    do
    {
      if (this->Run.cancelled())
      {
        throw Cancelled();
      }
    } while (::poll(&state, 1, kPollMilliseconds) <= 0);
  }

  Execution& Run;
  pid_t Process = -1;
  int Pipe = -1;
};

} // namespace

Model runIsolated(const Work& work, const std::string& whenItDies, Execution& execution)
{
  constexpr std::size_t kSteps = 1000;
  execution.step("read", 0, kSteps);
  Copy copy(work, execution);
  Model model;
  std::vector<double> number;
  std::string message;
  const auto receive = [&](const Frame& frame)
  {
    switch (frame.kind)
    {
      case Kind::points:
        return copy.receive(frame.count, model.points);
      case Kind::triangles:
        return copy.receive(frame.count, model.triangles);
      case Kind::curveCorners:
        return copy.receive(frame.count, model.curves.corners);
      case Kind::curveEnds:
        return copy.receive(frame.count, model.curves.ends);
      case Kind::colors:
        return copy.receive(frame.count, model.colors);
      case Kind::normals:
        return copy.receive(frame.count, model.normals);
      case Kind::note:
        return copy.receive(frame.count, model.note);
      case Kind::fraction:
      case Kind::unit:
        return copy.receive(frame.count, number) && number.size() == 1;
      default:
        return copy.receive(frame.count, message);
    }
  };
  for (Frame frame; copy.receive(&frame, sizeof(frame)) && receive(frame);)
  {
    if (frame.kind == Kind::error)
    {
      throw Error(frame.code, message);
    }
    if (frame.kind == Kind::done)
    {
      return model;
    }
    if (frame.kind == Kind::unit)
    {
      model.millimetresPerUnit = number[0];
    }
    if (frame.kind == Kind::fraction)
    {
      execution.step("read", static_cast<std::size_t>(number[0] * kSteps), kSteps);
    }
  }
  execution.step("read", 0, kSteps); // ended by a cancel?
  throw Error(ErrorCode::parse, whenItDies);
}

} // namespace scan
