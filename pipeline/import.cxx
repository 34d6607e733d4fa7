// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/import.h"

#include "filters/base/error.h"
#include "filters/base/note.h"
#include "filters/base/unit.h"
#include "pipeline/hash.h"
#include "pipeline/operation_rows.h"
#include "pipeline/time_text.h"

#include <vtkAlgorithm.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

namespace scan
{

namespace
{

using State = vtkScanOutcome::State;

/// What --unit takes.
std::vector<std::string> unitChoices()
{
  std::vector<std::string> choices = { "file" };
  std::ranges::transform(
    kUnits, std::back_inserter(choices), [](const Unit& unit) { return std::string(unit.symbol); });
  return choices;
}

} // namespace

const std::vector<Parameter>& readParameters()
{
  static const std::vector<Parameter> kParameters{
    { .name = "as",
      .defaultValue = "auto",
      .help = "what to take from the input files: what they hold, points only, or meshes only",
      .choices = { "auto", "points", "mesh" } },
    { .name = "unit",
      .defaultValue = "file",
      .help = "of input files that do not tell theirs; file for what they tell, or none",
      .choices = unitChoices() },
    { .name = "tolerance",
      .defaultValue = ReadOptions().tolerance,
      .help = "distance of the triangles of STEP and IGES files from their surfaces; % of the size",
      .minimum = 0 },
    { .name = "transforms",
      .defaultValue = "",
      .help = "a list that places the input files: a name and 16, 12 or 7 numbers for each" },
  };
  return kParameters;
}

const std::vector<Parameter>& openParameters()
{
  static const std::vector<Parameter> kParameters = []
  {
    std::vector<Parameter> parameters = readParameters();
    parameters.push_back({ .name = "files", .defaultValue = TextList(), .help = "the files" });
    return parameters;
  }();
  return kParameters;
}

Import::Import(const ParameterValues& values, const CancelToken& token)
  : Paths(valueOf<TextList>(values, "files"))
{
  const auto as = valueOf<std::string>(values, "as");
  this->Reading.as = as == "points" ? ReadAs::points
    : as == "mesh"                  ? ReadAs::mesh
                                    : ReadAs::automatic;
  this->Reading.tolerance = valueOf<Length>(values, "tolerance");
  checkReadOptions(this->Reading);
  const auto symbol = valueOf<std::string>(values, "unit");
  const auto* const unit = std::ranges::find(kUnits, symbol, &Unit::symbol);
  this->Unit = unit != kUnits.end() ? unit->millimetres : 0.0;
  if (std::ranges::count(this->Paths, "-") > 1)
  {
    throw Error(ErrorCode::badParameter, "standard input can be read only once");
  }
  const auto transforms = valueOf<std::string>(values, "transforms");
  if (!transforms.empty())
  {
    this->Transforms.emplace(transforms);
  }
  for (const std::string& path : this->Paths)
  {
    if (path.find('\n') != std::string::npos)
    {
      throw Error(ErrorCode::badParameter, path + ": the name has a line end; rename the file");
    }
    if (this->Transforms)
    {
      this->Transforms->placeOf(path);
    }
    this->Formats.push_back(&formatToRead(path, token));
  }
}

StepResult Import::read(std::size_t file, const RunOptions& options) const
{
  const std::string& path = this->Paths[file];
  const auto reader = this->Formats[file]->makeReader(path, this->Reading);
  StepResult step = runAlgorithm(*reader, nullptr, options);
  auto* const data = vtkPolyData::SafeDownCast(step.output);
  if (data == nullptr)
  {
    return step;
  }
  InputModel model{ data, path, {} };
  if (this->Unit > 0.0)
  {
    model = withUnit(std::move(model), this->Unit);
  }
  if (this->Transforms)
  {
    model = placed(std::move(model), this->Transforms->placeOf(path));
  }
  step.output = model.data;
  addToNote(step.note, model.note);
  addCounts(step);
  return step;
}

StepResult Import::run(const RunOptions& options, const Listener& listener) const
{
  std::vector<InputModel> parts;
  StepResult all;
  for (std::size_t i = 0; i < this->Paths.size(); ++i)
  {
    StepResult step = guardedStep([&] { return this->read(i, options); });
    if (listener)
    {
      listener(this->Paths[i], step);
    }
    all.seconds += step.seconds;
    all.peakBytes = step.peakBytes;
    if (step.outcome.state != State::ok)
    {
      all.outcome = step.outcome;
      return all;
    }
    if (!step.note.empty())
    {
      addToNote(all.note, this->Paths[i] + ": " + step.note);
    }
    parts.push_back({ vtkPolyData::SafeDownCast(step.output), this->Paths[i], {} });
  }
  StepResult merging = guardedStep(
    [&]
    {
      StepResult step;
      const InputModel merged = mergeModels(parts);
      step.output = merged.data;
      step.note = merged.note;
      return step;
    });
  if (listener && parts.size() > 1)
  {
    listener({}, merging);
  }
  merging.seconds = all.seconds;
  merging.peakBytes = all.peakBytes;
  addToNote(all.note, merging.note);
  merging.note = all.note;
  addCounts(merging);
  return merging;
}

ReadFile describeFile(const std::string& path, const CancelToken& token)
{
  namespace fs = std::filesystem;
  ReadFile file;
  file.path = path;
  file.format = formatToRead(path, token).name;
  if (path != "-")
  {
    std::error_code ignored;
    file.place = fs::absolute(path, ignored).string();
    file.bytes = static_cast<std::int64_t>(fs::file_size(path, ignored));
    file.modified = timeTextOfFile(path);
    file.hash = textOf(hashOfFile(path));
  }
  return file;
}

} // namespace scan
