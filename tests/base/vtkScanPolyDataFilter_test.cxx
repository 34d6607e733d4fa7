// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanPolyDataFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <new>
#include <stdexcept>
#include <vector>

namespace
{

/// Copies its input, then does what the test wants to see go wrong.
class Filter : public vtkScanPolyDataFilter
{
public:
  static Filter* New();
  vtkTypeMacro(Filter, vtkScanPolyDataFilter);
  std::function<void(scan::Execution&)> Body = [](scan::Execution&) {};

protected:
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override
  {
    output.ShallowCopy(&input);
    this->Body(execution);
  }
};
vtkStandardNewMacro(Filter);

struct Events
{
  int errors = 0;
  std::vector<double> progress;
};

void observe(vtkObject* caller, unsigned long event, void* client, void*)
{
  auto& events = *static_cast<Events*>(client);
  if (event == vtkCommand::ErrorEvent)
  {
    ++events.errors;
  }
  else
  {
    events.progress.push_back(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
  }
}

struct FilterRun : testing::Test
{
  FilterRun()
  {
    this->Observer->SetClientData(&this->Seen);
    this->Observer->SetCallback(observe);
    this->Subject->SetInputConnection(this->Source->GetOutputPort());
    this->Subject->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Subject->AddObserver(vtkCommand::ProgressEvent, this->Observer);
    this->Subject->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Quiet);
  }

  int update() { return this->Subject->GetExecutive()->Update(); }
  vtkIdType points() { return this->Subject->GetOutput()->GetNumberOfPoints(); }
  vtkScanOutcome::State state() { return this->Subject->GetOutcome().state; }

  Events Seen;
  vtkNew<vtkCallbackCommand> Observer;
  vtkNew<vtkCallbackCommand> Quiet;
  vtkNew<vtkSphereSource> Source;
  vtkNew<Filter> Subject;
};

} // namespace

TEST_F(FilterRun, ReportsProgressAndOutcome)
{
  this->Subject->Body = [](scan::Execution& execution)
  {
    execution.plan({ { "work" } });
    execution.step("work", 1, 4);
    execution.step("work", 4, 4);
  };
  EXPECT_EQ(this->update(), 1);
  EXPECT_EQ(this->state(), vtkScanOutcome::State::ok);
  EXPECT_GT(this->points(), 0);
  EXPECT_EQ(this->Seen.errors, 0);
  EXPECT_NE(std::ranges::find(this->Seen.progress, 0.25), this->Seen.progress.end());
  EXPECT_EQ(this->Seen.progress.back(), 1.0);
}

TEST_F(FilterRun, ErrorEmptiesTheOutputAndIsReportedOnce)
{
  this->Subject->Body = [](scan::Execution&)
  { throw scan::Error(scan::ErrorCode::badInput, "all points in one plane"); };
  EXPECT_EQ(this->update(), 0);
  EXPECT_EQ(this->points(), 0);
  EXPECT_EQ(this->Seen.errors, 1);
  EXPECT_EQ(this->state(), vtkScanOutcome::State::failed);
  EXPECT_EQ(this->Subject->GetOutcome().code, scan::ErrorCode::badInput);
  EXPECT_EQ(this->Subject->GetOutcome().message, "all points in one plane");
}

TEST_F(FilterRun, NoExceptionOfAnyKindPasses)
{
  this->Subject->Body = [](scan::Execution&) { throw std::bad_alloc(); };
  EXPECT_EQ(this->update(), 0);
  EXPECT_EQ(this->Subject->GetOutcome().code, scan::ErrorCode::memory);
  this->Subject->Modified();
  this->Subject->Body = [](scan::Execution&) { throw std::runtime_error("surprise"); };
  EXPECT_EQ(this->update(), 0);
  EXPECT_EQ(this->Subject->GetOutcome().code, scan::ErrorCode::internal);
  this->Subject->Modified();
  this->Subject->Body = [](scan::Execution&) { throw 42; };
  EXPECT_EQ(this->update(), 0);
  EXPECT_EQ(this->Subject->GetOutcome().code, scan::ErrorCode::internal);
}

TEST_F(FilterRun, CancelEmptiesTheOutputWithoutAnError)
{
  const scan::CancelToken token;
  this->Subject->SetCancelToken(token);
  this->Subject->Body = [&](scan::Execution& execution)
  {
    token.cancel();
    execution.step("work", 0, 1);
  };
  EXPECT_EQ(this->update(), 1);
  EXPECT_EQ(this->points(), 0);
  EXPECT_EQ(this->Seen.errors, 0);
  EXPECT_EQ(this->state(), vtkScanOutcome::State::cancelled);
}

TEST_F(FilterRun, AnObserverOfProgressMayAbort)
{
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  this->Subject->AddObserver(vtkCommand::ProgressEvent, abort);
  this->Subject->Body = [](scan::Execution& execution)
  {
    execution.plan({ { "work" } });
    execution.step("work", 1, 2);
    FAIL() << "the run went on";
  };
  this->update();
  EXPECT_EQ(this->points(), 0);
  EXPECT_EQ(this->state(), vtkScanOutcome::State::cancelled);
}

TEST_F(FilterRun, PassesTheNumberOfThreadsOn)
{
  unsigned threads = 0;
  this->Subject->SetThreads(3);
  this->Subject->Body = [&](scan::Execution& execution) { threads = execution.threads(); };
  this->update();
  EXPECT_EQ(threads, 3U);
}
