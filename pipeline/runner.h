// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/base/vtkScanTask.h"
#include "pipeline/operation_table.h"

#include <vtkSmartPointer.h>

#include <cstdint>
#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace scan
{

/// What a step is run with.
struct RunOptions
{
  unsigned threads = 0; ///< 0: all cores
  CancelToken token;
  Execution::Listener progress; ///< called on the thread that runs the step
};

/// One finished step. Whatever went wrong is said in the outcome; running never throws.
struct StepResult
{
  vtkScanOutcome outcome;
  double seconds = 0.0;
  std::int64_t peakBytes = 0; ///< peak resident memory of the program so far
  Results results;
  std::string note;                      ///< what the user should know, see Operation
  vtkSmartPointer<vtkDataObject> output; ///< null unless it went well; nobody changes it any more
};

/// Runs a fresh algorithm once: a reader (input null), a filter, or a writer. The algorithm must
/// not be used again. Errors of plain VTK algorithms are caught from their ErrorEvent.
StepResult runAlgorithm(vtkAlgorithm& fresh, vtkDataObject* input, const RunOptions& options);

/// What the body returns; what it throws becomes the outcome of a step without a result.
StepResult guardedStep(const std::function<StepResult()>& body);

/// Adds the numbers of points and triangles of the output to the results.
void addCounts(StepResult& step);

/// Runs an operation of the table on a fresh filter.
/// @param given parameters that differ from their defaults
StepResult runOperation(const Operation& operation, const ParameterValues& given,
  vtkDataObject& input, const RunOptions& options);

} // namespace scan
