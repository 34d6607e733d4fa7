// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/runner.h"

#include "pipeline/peak_memory.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <chrono>
#include <exception>
#include <new>
#include <string>

namespace scan
{

namespace
{

using State = vtkScanOutcome::State;

/// "ERROR: In file, line 7\nvtkClass (0x1234): text\n\n" -> "text", in one line.
std::string plainMessage(std::string text)
{
  const std::size_t start = text.find("): ");
  text = start == std::string::npos ? text : text.substr(start + 3);
  text.erase(text.find_last_not_of('\n') + 1);
  return text.substr(0, text.find('\n'));
}

/// Keeps the first error instead of letting VTK print it, and passes progress on.
class Observer : public vtkCommand
{
public:
  static Observer* New() { return new Observer; }
  vtkTypeMacro(Observer, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ErrorEvent)
    {
      if (this->Message.empty() && data != nullptr)
      {
        this->Message = plainMessage(static_cast<const char*>(data));
      }
      return;
    }
    auto* const algorithm = vtkAlgorithm::SafeDownCast(caller);
    const char* const text = algorithm != nullptr ? algorithm->GetProgressText() : nullptr;
    if (text != nullptr && this->Options->progress)
    {
      this->Options->progress(text, algorithm->GetProgress());
    }
  }

  const RunOptions* Options = nullptr;
  std::string Message;
};

vtkScanOutcome updateOnce(vtkAlgorithm& fresh, const RunOptions& options)
{
  vtkNew<Observer> observer;
  observer->Options = &options;
  fresh.AddObserver(vtkCommand::ErrorEvent, observer);
  fresh.AddObserver(vtkCommand::ProgressEvent, observer);
  fresh.GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  auto* const task = dynamic_cast<vtkScanTask*>(&fresh);
  if (task != nullptr)
  {
    task->SetThreads(options.threads);
    task->SetCancelToken(options.token);
  }
  const bool isUpdated = fresh.GetExecutive()->Update() != 0;
  if (task != nullptr && task->GetOutcome().state != State::ok)
  {
    return task->GetOutcome();
  }
  if (isUpdated && observer->Message.empty())
  {
    return {};
  }
  return { State::failed, ErrorCode::internal,
    observer->Message.empty() ? "the filter refused its input" : observer->Message };
}

} // namespace

StepResult runAlgorithm(vtkAlgorithm& fresh, vtkDataObject* input, const RunOptions& options)
{
  const auto start = std::chrono::steady_clock::now();
  StepResult step = guardedStep( // plain VTK algorithms have no guard
    [&]
    {
      StepResult run;
      if (input != nullptr)
      {
        fresh.SetInputDataObject(input);
      }
      run.outcome = updateOnce(fresh, options);
      const auto* const task = dynamic_cast<vtkScanTask*>(&fresh);
      run.note = task != nullptr ? task->GetNote() : std::string();
      return run;
    });
  if (step.outcome.state == State::ok && fresh.GetNumberOfOutputPorts() > 0)
  {
    // a copy that shares the arrays, so that the filter can go
    vtkDataObject* const output = fresh.GetOutputDataObject(0);
    step.output = vtk::TakeSmartPointer(output->NewInstance());
    step.output->ShallowCopy(output);
  }
  step.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  step.peakBytes = peakMemory();
  return step;
}

void addCounts(StepResult& step)
{
  if (auto* const model = vtkPolyData::SafeDownCast(step.output))
  {
    step.results.emplace_back("output-points", std::int64_t{ model->GetNumberOfPoints() });
    step.results.emplace_back("output-triangles", std::int64_t{ model->GetNumberOfPolys() });
  }
}

StepResult guardedStep(const std::function<StepResult()>& body)
{
  StepResult step;
  const vtkScanOutcome outcome = vtkScanOutcomeOf([&] { step = body(); });
  if (outcome.state != State::ok)
  {
    step = {};
    step.outcome = outcome;
  }
  return step;
}

StepResult runOperation(const Operation& operation, const ParameterValues& given,
  vtkDataObject& input, const RunOptions& options)
{
  return guardedStep(
    [&]
    {
      const auto filter = operation.make(completeValues(operation, given));
      StepResult step = runAlgorithm(*filter, &input, options);
      if (step.outcome.state == State::ok)
      {
        step.results = operation.results ? operation.results(*filter) : Results();
        step.note = operation.note ? operation.note(*filter) : step.note;
        addCounts(step);
      }
      return step;
    });
}

} // namespace scan
