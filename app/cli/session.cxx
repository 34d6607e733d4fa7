// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session.h"

#include "app/cli/process.h"
#include "app/cli/record.h"
#include "app/cli/terminal_progress.h"
#include "filters/base/error.h"
#include "pipeline/input_models.h"
#include "pipeline/output_files.h"
#include "pipeline/runner.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>

namespace scan
{

namespace
{

using State = vtkScanOutcome::State;

ExitStatus statusOf(ErrorCode code, ExitStatus otherwise)
{
  switch (code)
  {
    case ErrorCode::memory:
      return ExitStatus::overMemory;
    case ErrorCode::badParameter:
      return ExitStatus::usage;
    case ErrorCode::internal:
      return ExitStatus::failed;
    default:
      return otherwise;
  }
}

/// Turns the errors of preparations into the program's status.
template <class Body>
auto translated(ExitStatus otherwise, const Body& body)
{
  try
  {
    return body();
  }
  catch (const Cancelled&)
  {
    throw Failure(ExitStatus::cancelled, "cancelled");
  }
  catch (const Error& error)
  {
    throw Failure(statusOf(error.code(), otherwise), error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(ExitStatus::overMemory, "out of memory; allow more or use fewer points");
  }
}

void refuseSameFiles(const std::vector<std::string>& outputs, const CommandLine& line)
{
  for (auto output = outputs.begin(); output != outputs.end(); ++output)
  {
    const auto isSame = [&](const std::string& other) { return isSameFile(*output, other); };
    if (std::any_of(outputs.begin(), output, isSame))
    {
      throw Failure(ExitStatus::usage, *output + ": is an output twice; give each its own name");
    }
    if (*output == line.json && *output != "-" && std::ranges::any_of(line.inputs, isSame))
    {
      throw Failure(ExitStatus::usage, *output + ": is an input; give the record its own name");
    }
  }
}

class Session
{
public:
  Session(const CommandLine& line, const CancelToken& token)
    : Line(line)
    , Progress(line.progress, line.quiet)
  {
    this->Options.threads = line.threads;
    this->Options.token = token;
    this->Options.progress = [this](std::string_view phase, double fraction)
    { this->Progress.show(phase, fraction); };
  }

  /// Everything that can be refused without reading a model.
  void check()
  {
    translated(ExitStatus::usage, [&] { checkReadOptions(this->Line.reading); });
    std::vector<std::string> outputs;
    for (const CommandLine::Step& step : this->Line.steps)
    {
      if (const auto* output = std::get_if<OutputWish>(&step))
      {
        translated(ExitStatus::usage, [&] { formatToWrite(output->path); });
        outputs.push_back(output->path);
      }
    }
    if (!this->Line.json.empty())
    {
      outputs.push_back(this->Line.json);
    }
    this->IsOutputFree = std::ranges::find(outputs, "-") == outputs.end();
    refuseSameFiles(outputs, this->Line);
    for (const std::string& output : outputs)
    {
      translated(ExitStatus::usage, [&] { checkOutput(output, this->Line.overwrite); });
    }
    if (std::ranges::count(this->Line.inputs, "-") > 1)
    {
      throw Failure(ExitStatus::usage, "standard input can be read only once");
    }
    if (outputs.empty() && !this->hasAnalysis() && !this->Line.verbose && !this->Line.dryRun)
    {
      throw Failure(
        ExitStatus::usage, "the result would be lost; add -o FILE, or info to measure it");
    }
    if (!this->Line.transforms.empty())
    {
      translated(ExitStatus::usage, [&] { this->Transforms.emplace(this->Line.transforms); });
    }
    for (const std::string& input : this->Line.inputs)
    {
      if (this->Transforms)
      {
        translated(ExitStatus::usage, [&] { this->Transforms->placeOf(input); });
      }
      this->InputFormats.push_back(
        translated(ExitStatus::usage, [&] { return &formatToRead(input, this->Options.token); }));
    }
  }

  void describe() const
  {
    std::string text;
    for (std::size_t i = 0; i < this->Line.inputs.size(); ++i)
    {
      text += "open " + this->Line.inputs[i] + " (" + this->InputFormats[i]->name + ")\n";
    }
    for (const CommandLine::Step& step : this->Line.steps)
    {
      if (const auto* output = std::get_if<OutputWish>(&step))
      {
        text += "save " + output->path + " (" + formatToWrite(output->path).name + ")\n";
        continue;
      }
      const auto& wish = std::get<OperationWish>(step);
      text += wish.operation->verb;
      for (const auto& [name, value] : completeValues(*wish.operation, wish.given))
      {
        text += " --" + name + "=" + textOf(value);
      }
      text += "\n";
    }
    writeText("-", text);
  }

  void run()
  {
    std::vector<InputModel> parts;
    for (std::size_t i = 0; i < this->Line.inputs.size(); ++i)
    {
      parts.push_back(this->open(this->Line.inputs[i], *this->InputFormats[i]));
    }
    const InputModel merged = translated(ExitStatus::usage, [&] { return mergeModels(parts); });
    this->note(merged.note);
    this->Model = merged.data;
    for (const CommandLine::Step& step : this->Line.steps)
    {
      if (const auto* output = std::get_if<OutputWish>(&step))
      {
        this->save(*output);
      }
      else
      {
        this->apply(std::get<OperationWish>(step));
      }
    }
    say(this->Notes);
  }

  void writeRecord(ExitStatus status, const std::string& message) const
  {
    if (!this->Line.json.empty())
    {
      translated(ExitStatus::failed,
        [&] { writeText(this->Line.json, this->Steps.json(static_cast<int>(status), message)); });
    }
  }

private:
  bool hasAnalysis() const
  {
    return std::ranges::any_of(this->Line.steps,
      [](const CommandLine::Step& step)
      {
        const auto* wish = std::get_if<OperationWish>(&step);
        return wish != nullptr && wish->operation->stage == Stage::analysis;
      });
  }

  InputModel open(const std::string& path, const Format& format)
  {
    const auto reader =
      translated(ExitStatus::usage, [&] { return format.makeReader(path, this->Line.reading); });
    this->Progress.start("open");
    const StepResult step = this->finish("open", { { "file", path } },
      runAlgorithm(*reader, nullptr, this->Options), ExitStatus::usage);
    this->note(step.note, path);
    InputModel model{ vtkPolyData::SafeDownCast(step.output), path, {} };
    return translated(ExitStatus::usage,
      [&]
      {
        if (this->Line.unit > 0.0)
        {
          model = withUnit(std::move(model), this->Line.unit);
          this->note(model.note);
        }
        return this->Transforms ? placed(std::move(model), this->Transforms->placeOf(path)) : model;
      });
  }

  /// What the user should know, told when everything went well.
  void note(const std::string& text, const std::string& about = {})
  {
    if (!text.empty() && !this->Line.quiet)
    {
      this->Notes += "scanwrap: " + about + (about.empty() ? "" : ": ") + text + "\n";
    }
  }

  void apply(const OperationWish& wish)
  {
    const Operation& operation = *wish.operation;
    this->Progress.start(operation.verb);
    StepResult found = runOperation(operation, wish.given, *this->Model, this->Options);
    const std::string table = tableOf(found.results);
    const StepResult step = this->finish(
      operation.verb, completeValues(operation, wish.given), std::move(found), ExitStatus::failed);
    this->note(step.note, operation.verb);
    if (auto* const model = vtkPolyData::SafeDownCast(step.output))
    {
      this->Model = model;
      this->Picture = nullptr;
    }
    else
    {
      this->Picture = step.output;
    }
    if (operation.stage == Stage::analysis && !table.empty() && !this->Line.quiet)
    {
      if (this->IsOutputFree)
      {
        translated(ExitStatus::failed, [&] { writeText("-", table); });
      }
      else
      {
        say(table);
      }
    }
  }

  void save(const OutputWish& wish)
  {
    const std::string& path = wish.path;
    const Format& format = formatToWrite(path);
    ParameterValues values = wish.given;
    if (std::ranges::find(format.writeParameters, "encoding", &Parameter::name) !=
      format.writeParameters.end())
    {
      values.emplace("encoding", this->Line.encoding);
    }
    values = completeValues(format.writeParameters, values, path);
    vtkDataObject* data = this->Model;
    if (format.isPicture)
    {
      if (this->Picture == nullptr)
      {
        this->apply({ findOperation("render"), {} });
      }
      data = this->Picture;
    }
    const auto writer = format.makeWriter(path, values);
    this->Progress.start("save");
    values.emplace("file", path);
    StepResult saved = runAlgorithm(*writer, data, this->Options);
    const std::string losses = lossesOf(format, *this->Model);
    saved.note += (saved.note.empty() || losses.empty() ? "" : "; ") + losses;
    this->note(this->finish("save", values, std::move(saved), ExitStatus::failed).note, path);
  }

  /// Records a step and throws unless it went well.
  StepResult finish(const std::string& verb, const ParameterValues& parameters, StepResult step,
    ExitStatus ifFailed)
  {
    this->Progress.finish();
    if (auto* const model = vtkPolyData::SafeDownCast(step.output))
    {
      step.results.emplace_back("output-points", std::int64_t{ model->GetNumberOfPoints() });
      step.results.emplace_back("output-triangles", std::int64_t{ model->GetNumberOfPolys() });
    }
    this->Steps.add(verb, parameters, step);
    if (step.outcome.state == State::cancelled)
    {
      throw Failure(ExitStatus::cancelled, "cancelled");
    }
    if (step.outcome.state == State::failed)
    {
      const bool isFile = verb == "open" || verb == "save"; // their messages name the file
      throw Failure(statusOf(step.outcome.code, ifFailed),
        isFile ? step.outcome.message : verb + ": " + step.outcome.message);
    }
    if (this->Line.verbose)
    {
      say(fmt::format("{}: {:.2f} s, {:.0f} MB\n{}", verb, step.seconds,
        static_cast<double>(step.peakBytes) / 1e6, tableOf(step.results)));
    }
    return step;
  }

  const CommandLine& Line;
  TerminalProgress Progress;
  RunOptions Options;
  Record Steps;
  std::vector<const Format*> InputFormats;
  std::optional<TransformList> Transforms;
  bool IsOutputFree = true; // nobody asked for data on standard output
  vtkSmartPointer<vtkPolyData> Model;
  vtkSmartPointer<vtkDataObject> Picture; // of the model as it is
  std::string Notes;
};

} // namespace

void runSession(const CommandLine& line, const CancelToken& token)
{
  Session session(line, token);
  session.check();
  if (line.dryRun)
  {
    session.describe();
    return;
  }
  try
  {
    session.run();
  }
  catch (const Failure& failure)
  {
    session.writeRecord(failure.status(), failure.what());
    throw;
  }
  session.writeRecord(ExitStatus::done, "");
}

} // namespace scan
