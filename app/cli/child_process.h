// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <array>
#include <string>
#include <vector>

namespace scan
{

/// This program with another command line, running at the same time. Its record, standard output
/// and standard error are collected.
class ChildProcess
{
public:
  /// @throws Error io when no process can be started
  explicit ChildProcess(std::vector<std::string> words);
  ~ChildProcess(); ///< waits for the end
  ChildProcess(const ChildProcess&) = delete;
  void operator=(const ChildProcess&) = delete;

  /// Takes what has been written, for up to so long; false when the process has ended.
  bool wait(int milliseconds);

  /// Asks it to stop.
  void cancel() const;

  static constexpr int kSignalled = 128;

  /// Exit status, or kSignalled + the signal that ended it; valid behind the end.
  int status() const { return this->Status; }

  const std::string& output() const { return this->Texts[0]; }
  const std::string& errors() const { return this->Texts[1]; }
  const std::string& record() const { return this->Texts[2]; } ///< JSON; empty after a crash

private:
  ::pid_t Id = -1;
  int Status = -1;
  std::array<int, 3> Pipes{ -1, -1, -1 }; // output, errors, record
  std::array<std::string, 3> Texts;
};

} // namespace scan
