// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/parameter.h"
#include "pipeline/result.h"

#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

class vtkAlgorithm;

namespace scan
{

/// The part of the work that an operation belongs to.
enum class Stage
{
  history, ///< the steps themselves
  input,
  points,
  wrap,
  surface,
  analysis,
  output
};

std::string_view nameOf(Stage stage);

/// All that the command line, dialogs, templates and the manual know about an operation.
struct Operation
{
  std::string verb;
  Stage stage;
  std::string help;    ///< one line
  std::string example; ///< a whole command line
  std::vector<Parameter> parameters;

  /// A fresh filter, one input and one output port, with its properties set. The values are those
  /// of completeValues().
  std::function<vtkSmartPointer<vtkAlgorithm>(const ParameterValues&)> make;

  /// What the filter found out in its last run.
  std::function<Results(vtkAlgorithm&)> results;

  /// One line on what the user should know about the last run, such as what was left out; empty
  /// when all went as expected. May be null.
  std::function<std::string(vtkAlgorithm&)> note;
};

/// Every operation, by stage.
const std::vector<Operation>& operationTable();

/// The operation of that verb, or null.
const Operation* findOperation(std::string_view verb);

/// Every parameter of the operation with its given or default value.
/// @throws Error{badParameter} for an unknown name, a wrong type or a value out of range
ParameterValues completeValues(const Operation& operation, const ParameterValues& given);

} // namespace scan
