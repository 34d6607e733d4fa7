// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/parameter.h"
#include "pipeline/runner.h"

#include <string>
#include <vector>

namespace scan
{

/// What happened, for --json: every step with its parameters, time, memory and results.
class Record
{
public:
  /// @param verb the operation's, or "open" and "save" for files
  void add(std::string verb, ParameterValues parameters, const StepResult& result);

  /// The record as JSON text. With `failure` empty the run went well.
  std::string json(int exitStatus, const std::string& failure) const;

private:
  struct Step
  {
    std::string verb;
    ParameterValues parameters;
    StepResult result; // without the output, which would keep memory alive
  };
  std::vector<Step> Steps;
};

} // namespace scan
