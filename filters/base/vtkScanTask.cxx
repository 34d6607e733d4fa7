// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanTask.h"

#include "filters/base/note.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>

#include <new>

using State = vtkScanOutcome::State;

vtkScanOutcome vtkScanOutcomeOf(const std::function<void()>& body)
{
  try
  {
    body();
    return {};
  }
  catch (const scan::Cancelled&)
  {
    return { State::cancelled, {}, "cancelled" };
  }
  catch (const scan::Error& error)
  {
    return { State::failed, error.code(), error.what() };
  }
  catch (const std::bad_alloc&)
  {
    return { State::failed, scan::ErrorCode::memory,
      "out of memory; allow more memory or use fewer points" };
  }
  catch (const std::exception& error)
  {
    return { State::failed, scan::ErrorCode::internal, error.what() };
  }
  catch (...) // an unknown exception must not enter the executive either
  {
    return { State::failed, scan::ErrorCode::internal, "unknown exception" };
  }
}

int vtkScanTask::RunGuarded(
  vtkAlgorithm& self, vtkDataObject* output, const std::function<void(scan::Execution&)>& body)
{
  self.SetAbortExecute(0);
  this->Note.clear();
  const auto listener = [&self](std::string_view phase, double fraction)
  {
    self.SetProgressText(std::string(phase).c_str());
    self.UpdateProgress(fraction);
    if (self.GetAbortExecute() != 0)
    {
      throw scan::Cancelled();
    }
  };
  this->Outcome = vtkScanOutcomeOf(
    [&]
    {
      scan::Execution execution(this->Threads, this->Token, listener);
      body(execution);
    });
  if (this->Outcome.state == State::ok)
  {
    return 1;
  }
  if (output != nullptr)
  {
    output->Initialize();
  }
  if (this->Outcome.state == State::cancelled)
  {
    return 1;
  }
  vtkErrorWithObjectMacro(&self, << this->Outcome.message);
  return 0;
}

void vtkScanTask::AddNote(const std::string& text)
{
  scan::addToNote(this->Note, text);
}
