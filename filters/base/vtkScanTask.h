// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/base/execution.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

/// How the last run of a task ended.
struct vtkScanOutcome
{
  enum class State
  {
    ok,
    failed,
    cancelled
  };
  State state = State::ok;
  scan::ErrorCode code = scan::ErrorCode::internal; ///< of a failure
  std::string message;                              ///< of a failure: one line
};

/// How the body ended; whatever it throws becomes the outcome. Never throws.
vtkScanOutcome vtkScanOutcomeOf(const std::function<void()>& body);

/// What every filter, reader and writer of the project shares: threads, cancel, and the guard
/// between kernels that throw and a VTK executive that must never see an exception.
///
/// A mixin beside the VTK superclass, not a vtkObject. After a failure or a cancel the output is
/// empty; use a fresh instance for the next run, VTK may take the empty output for up to date.
class vtkScanTask
{
public:
  /// The token is shared: raising it from any thread ends the run, soon, with an empty output.
  void SetCancelToken(const scan::CancelToken& token) { this->Token = token; }

  /// Number of threads; 0, the default, means all cores.
  void SetThreads(unsigned threads) { this->Threads = threads; }

  const vtkScanOutcome& GetOutcome() const { return this->Outcome; }

  /// One line on what the user should know about the last run, such as what was left out; empty
  /// when all went as expected.
  const std::string& GetNote() const { return this->Note; }

protected:
  vtkScanTask() = default;
  virtual ~vtkScanTask() = default;

  /// Runs `body` for the RequestData (or WriteData) of `self`; never throws. Progress goes to the
  /// observers of `self`, who may cancel by SetAbortExecute(1).
  /// @param output emptied unless the body finished; may be null (writers)
  /// @return what RequestData has to return: 0 after a failure, reported as one ErrorEvent;
  ///   1 otherwise, after a cancel too (VTK would report a 0 as an error)
  int RunGuarded(
    vtkAlgorithm& self, vtkDataObject* output, const std::function<void(scan::Execution&)>& body);

  /// Within the body: adds to the note of the run; an empty text adds nothing.
  void AddNote(const std::string& text);

private:
  scan::CancelToken Token;
  unsigned Threads = 0;
  vtkScanOutcome Outcome;
  std::string Note;
};
