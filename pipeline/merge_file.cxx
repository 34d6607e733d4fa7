// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/merge_file.h"

#include "pipeline/format_registry.h"
#include "pipeline/input_models.h"
#include "pipeline/runner.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

namespace scan
{

vtkStandardNewMacro(MergeFile);

int MergeFile::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* const input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* const output = vtkPolyData::GetData(outputVector);
  return this->RunGuarded(
    *this, output, [&](Execution& execution) { this->Merge(*input, *output, execution); });
}

void MergeFile::Merge(vtkPolyData& input, vtkPolyData& output, Execution& execution)
{
  constexpr std::size_t kSteps = 1000;
  execution.plan({ { "read", 4.0 }, { "merge", 1.0 } });
  execution.step("read", 0, kSteps);
  if (this->Path.empty() || this->Path == "-")
  {
    throw Error(ErrorCode::badInput, "there is no file to merge; name one with --file=PATH");
  }
  // the reader is an algorithm of its own, which a cancel of this one ends through its token
  RunOptions options;
  options.threads = execution.threads();
  options.progress = [&](std::string_view, double)
  {
    if (execution.cancelled())
    {
      options.token.cancel();
    }
  };
  const auto reader = formatToRead(this->Path, options.token).makeReader(this->Path, {});
  const StepResult read = runAlgorithm(*reader, nullptr, options);
  execution.step("read", kSteps, kSteps);
  if (read.outcome.state != vtkScanOutcome::State::ok)
  {
    throw Error(read.outcome.code, read.outcome.message);
  }
  this->AddNote(read.note);

  auto* const part = vtkPolyData::SafeDownCast(read.output);
  const InputModel merged = appendModel({ &input, {}, {} }, { part, this->Path, {} });
  this->AddNote(merged.note);
  output.ShallowCopy(merged.data);
  this->PointsBefore = input.GetNumberOfPoints();
  this->PointsAfter = output.GetNumberOfPoints();
  execution.step("merge", 1, 1);
}

} // namespace scan
