// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanMeshBridge.h"
#include "pipeline/format_registry.h"
#include "pipeline/runner.h"

#include <vtkAlgorithm.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <stdexcept>
#include <string>

/// Files of any format through the registry, as the program reads and writes them.
namespace scan::test
{

/// A failed run as an exception, with its message.
inline StepResult expectRun(StepResult result)
{
  if (result.outcome.state != vtkScanOutcome::State::ok)
  {
    throw std::runtime_error(result.outcome.message);
  }
  return result;
}

inline Model readFile(const std::string& path, const ReadOptions& options = {})
{
  const auto reader = formatToRead(path, {}).makeReader(path, options);
  const StepResult result = expectRun(runAlgorithm(*reader, nullptr, {}));
  Model model = bridge::modelOf(*vtkPolyData::SafeDownCast(result.output));
  model.note = result.note;
  return model;
}

/// @param given options that differ from their defaults
/// @return the note of the writer
inline std::string writeFile(
  const std::string& path, const Model& model, const ParameterValues& given = {})
{
  vtkNew<vtkPolyData> data;
  bridge::setModel(*data, model);
  const Format& format = formatToWrite(path);
  const auto writer =
    format.makeWriter(path, completeValues(format.writeParameters, given, format.name));
  return expectRun(runAlgorithm(*writer, data, {})).note;
}

} // namespace scan::test
