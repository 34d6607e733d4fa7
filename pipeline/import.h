// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/format_registry.h"
#include "pipeline/input_models.h"
#include "pipeline/parameter.h"
#include "pipeline/runner.h"
#include "pipeline/step.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace scan
{

/// How files are opened: "as", "unit", "tolerance", "transforms".
const std::vector<Parameter>& readParameters();

/// The parameters of the step "open": these, and "files", a TextList.
const std::vector<Parameter>& openParameters();

/// What a file is now, with its format and the hash of its content; standard input has no hash.
/// @throws Error, Cancelled as formatToRead()
ReadFile describeFile(const std::string& path, const CancelToken& token);

/// Files that become one model.
class Import
{
public:
  /// Told of each file after it was read, well or not; at last, without a path, of what several
  /// files became.
  using Listener = std::function<void(const std::string& path, const StepResult& step)>;

  /// Checks all that can be refused without reading a model.
  /// @param values of openParameters()
  /// @throws Error, Cancelled as checkReadOptions(), TransformList and formatToRead()
  Import(const ParameterValues& values, const CancelToken& token);

  const std::vector<std::string>& paths() const { return this->Paths; }
  const Format& format(std::size_t file) const { return *this->Formats[file]; }

  /// Reads the files and makes one model of them: gives it the unit, puts them in their places.
  /// @param listener may be null
  StepResult run(const RunOptions& options, const Listener& listener) const;

private:
  StepResult read(std::size_t file, const RunOptions& options) const;

  std::vector<std::string> Paths;
  std::vector<const Format*> Formats;
  ReadOptions Reading;
  double Unit = 0.0; ///< of files that do not tell theirs, in millimetres; 0: none
  std::optional<TransformList> Transforms;
};

} // namespace scan
