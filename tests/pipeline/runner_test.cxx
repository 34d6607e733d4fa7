// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/runner.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "filters/wrap/vtkScanWrapFilter.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace scan;
using State = vtkScanOutcome::State;

namespace
{

vtkSmartPointer<vtkPolyData> sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

StepResult run(const char* verb, vtkPolyData& input, const RunOptions& options = {})
{
  return runOperation(*findOperation(verb), {}, input, options);
}

} // namespace

TEST(Runner, GivesTheResultAndWhatItTook)
{
  const auto points = sphere(20);
  std::vector<double> progress;
  RunOptions options;
  options.progress = [&](std::string_view, double fraction) { progress.push_back(fraction); };
  const StepResult step = run("wrap", *points, options);
  ASSERT_EQ(step.outcome.state, State::ok) << step.outcome.message;
  EXPECT_GT(vtkPolyData::SafeDownCast(step.output)->GetNumberOfPolys(), 0);
  EXPECT_GT(step.seconds, 0.0);
  EXPECT_GT(step.peakBytes, 1000000);
  EXPECT_EQ(step.results.front(),
    Results::value_type("points-read", std::int64_t{ points->GetNumberOfPoints() }));
  EXPECT_TRUE(std::ranges::is_sorted(progress));
  EXPECT_EQ(progress.back(), 1.0);
}

TEST(Runner, FailureSaysWhyAndHasNoOutput)
{
  vtkNew<vtkPolyData> onePoint;
  bridge::setMesh(*onePoint, { { { 1, 2, 3 } }, {} });
  const StepResult step = run("wrap", *onePoint);
  EXPECT_EQ(step.outcome.state, State::failed);
  EXPECT_EQ(step.outcome.code, ErrorCode::badInput);
  EXPECT_FALSE(step.outcome.message.empty());
  EXPECT_EQ(step.output, nullptr);
}

TEST(Runner, WrongParametersFailWithoutARun)
{
  const auto points = sphere(8);
  const StepResult step = runOperation(*findOperation("wrap"), { { "fit", "some" } }, *points, {});
  EXPECT_EQ(step.outcome.state, State::failed);
  EXPECT_EQ(step.outcome.code, ErrorCode::badParameter);
}

TEST(Runner, EveryOperationStopsWhenCancelledAndLeavesItsInputAlone)
{
  const StepResult wrap = run("wrap", *sphere(20)); // what edits need, and others take
  for (const Operation& operation : operationTable())
  {
    auto* const input = vtkPolyData::SafeDownCast(wrap.output);
    const auto before = bridge::meshOf(*input);
    RunOptions options;
    options.token.cancel();
    const StepResult step = runOperation(operation, {}, *input, options);
    EXPECT_EQ(step.outcome.state, State::cancelled) << operation.verb;
    EXPECT_EQ(step.output, nullptr) << operation.verb;
    const auto after = bridge::meshOf(*input);
    EXPECT_EQ(after.points, before.points) << operation.verb;
    EXPECT_EQ(after.triangles, before.triangles) << operation.verb;
  }
}

TEST(Runner, EveryOperationSurvivesAnEmptyModel)
{
  for (const Operation& operation : operationTable())
  {
    vtkNew<vtkPolyData> empty;
    ParameterValues needed;
    for (const Parameter& parameter : operation.parameters)
    {
      if (parameter.name == "name" || parameter.name == "rule" || parameter.name == "region")
      {
        needed[parameter.name] = parameter.name == "name" ? "part" : "all";
      }
    }
    const StepResult step = runOperation(operation, needed, *empty, {});
    EXPECT_TRUE(step.outcome.state == State::ok || step.outcome.code == ErrorCode::badInput)
      << operation.verb << ": " << step.outcome.message;
  }
}

TEST(Runner, SameAsTheFilterInAPlainPipeline)
{
  const auto points = sphere(30);
  vtkNew<vtkScanWrapFilter> filter;
  filter->SetInputData(points);
  filter->Update();
  const TriMesh byHand = bridge::meshOf(*filter->GetOutput());
  const StepResult step = run("wrap", *points);
  const TriMesh byRunner = bridge::meshOf(*vtkPolyData::SafeDownCast(step.output));
  EXPECT_EQ(byRunner.points, byHand.points);
  EXPECT_EQ(byRunner.triangles, byHand.triangles);
}

TEST(Runner, WrapNamesTheScanPointOfEveryVertex)
{
  const auto points = sphere(20);
  const StepResult step = run("wrap", *points);
  auto* const surface = vtkPolyData::SafeDownCast(step.output);
  const std::vector<vtkIdType> ids = bridge::scanPointIdsOf(*surface);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> vertex{};
    std::array<double, 3> origin{};
    surface->GetPoint(i, vertex.data());
    points->GetPoint(ids[static_cast<std::size_t>(i)], origin.data());
    ASSERT_EQ(vertex, origin);
  }
}

TEST(Runner, SaysWhatAPlainVtkAlgorithmComplainedAbout)
{
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName("no-such-file.stl");
  const StepResult step = runAlgorithm(*reader, nullptr, {});
  EXPECT_EQ(step.outcome.state, State::failed);
  EXPECT_EQ(step.outcome.message.find("ERROR"), std::string::npos) << step.outcome.message;
  EXPECT_NE(step.outcome.message.find("no-such-file.stl"), std::string::npos)
    << step.outcome.message;
}
