// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session.h"

#include "app/cli/process.h"
#include "app/cli/record.h"
#include "app/cli/terminal_progress.h"
#include "filters/base/error.h"
#include "filters/base/note.h"
#include "pipeline/document.h"
#include "pipeline/file_head.h"
#include "pipeline/history_verb.h"
#include "pipeline/output_files.h"
#include "pipeline/peak_memory.h"
#include "pipeline/recipe.h"
#include "pipeline/result_text.h"
#include "pipeline/runner.h"

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <new>

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

bool isHistory(const OperationWish& wish)
{
  return wish.operation->stage == Stage::history;
}

/// Where --salvage wants what is whole of a damaged project; empty when it is not given.
std::string salvageIn(const OperationWish& wish)
{
  const auto given = wish.given.find("salvage");
  return isHistory(wish) && given != wish.given.end() ? std::get<std::string>(given->second) : "";
}

class Session
{
public:
  Session(const CommandLine& line, const CancelToken& token)
    : Line(line)
    , Progress(line.progress, line.quiet)
    , Doc(Document::withoutHashes())
  {
    this->Options.threads = line.threads;
    this->Options.token = token;
    this->Options.progress = [this](std::string_view phase, double fraction)
    { this->Progress.show(phase, fraction); };
  }

  /// Everything that can be refused without reading a model.
  void check()
  {
    const std::vector<std::string> outputs = this->findOutputs();
    this->IsOutputFree = std::ranges::find(outputs, "-") == outputs.end();
    refuseSameFiles(outputs, this->Line);
    for (const std::string& output : outputs)
    {
      translated(ExitStatus::usage, [&] { checkOutput(output, this->Line.overwrite); });
    }
    this->findProject();
    this->readTemplate();
    if (outputs.empty() && !this->HasProject && !this->hasAnalysis() && !this->Line.verbose &&
      !this->Line.dryRun)
    {
      throw Failure(
        ExitStatus::usage, "the result would be lost; add -o FILE, or info to measure it");
    }
    if (this->OldProject.empty())
    {
      ParameterValues values = this->Line.reading;
      values.emplace("files", this->Line.inputs);
      this->Opening = completeValues(openParameters(), values, "open");
      this->Files = translated(ExitStatus::usage,
        [&] { return std::make_unique<const Import>(this->Opening, this->Options.token); });
    }
  }

  void describe() const
  {
    constexpr const char* kProject = "Scanwrap project";
    std::string text;
    for (std::size_t i = 0; i < this->Line.inputs.size(); ++i)
    {
      text += "open " + this->Line.inputs[i] + " (" +
        (this->Files ? this->Files->format(i).name : kProject) + ")\n";
    }
    for (const RecipeStep& step : this->Template)
    {
      text += described(step.operation, step.given);
    }
    for (const CommandLine::Step& step : this->Line.steps)
    {
      if (const auto* output = std::get_if<OutputWish>(&step))
      {
        text += "save " + output->path + " (" +
          (isProjectName(output->path) ? kProject : formatToWrite(output->path).name) + ")\n";
        continue;
      }
      const auto& wish = std::get<OperationWish>(step);
      text += described(wish.operation, wish.given);
    }
    writeText("-", text);
  }

  void run()
  {
    if (!this->salvage())
    {
      this->openDocument();
      for (const RecipeStep& step : this->Template)
      {
        this->apply({ step.operation, step.given });
      }
      for (const CommandLine::Step& step : this->Line.steps)
      {
        this->runStep(step);
      }
      if (!this->OldProject.empty() && this->Line.steps.empty())
      {
        this->tellHistory({});
      }
    }
    say(this->Notes);
    if (this->HasFailedCheck)
    {
      throw Failure(ExitStatus::checkFailed, "a check failed, see above");
    }
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
  static std::string described(const Operation* operation, const ParameterValues& given)
  {
    std::string text = operation->verb;
    for (const auto& [name, value] : completeValues(*operation, given))
    {
      text.append(" --").append(name).append("=").append(textOf(value));
    }
    return text + "\n";
  }

  void runStep(const CommandLine::Step& step)
  {
    if (const auto* output = std::get_if<OutputWish>(&step))
    {
      this->save(*output);
    }
    else if (const auto& wish = std::get<OperationWish>(step); isHistory(wish))
    {
      this->tellHistory(wish.given);
    }
    else
    {
      this->apply(wish);
    }
  }

  /// The files that the line wants written, each of a known format; a project is noted.
  std::vector<std::string> findOutputs()
  {
    std::vector<std::string> outputs;
    for (const CommandLine::Step& step : this->Line.steps)
    {
      const auto* const output = std::get_if<OutputWish>(&step);
      const std::string path =
        output != nullptr ? output->path : salvageIn(std::get<OperationWish>(step));
      if (output != nullptr && !isProjectName(path))
      {
        translated(ExitStatus::usage, [&] { formatToWrite(path); });
      }
      else if (output != nullptr)
      {
        if (!this->NewProject.empty())
        {
          throw Failure(ExitStatus::usage,
            path + ": is the second project; keep the steps in one, copy it afterwards");
        }
        this->NewProject = path;
      }
      if (output != nullptr || !path.empty())
      {
        outputs.push_back(path);
      }
    }
    if (!this->Line.json.empty())
    {
      outputs.push_back(this->Line.json);
    }
    return outputs;
  }

  /// Whether the input is a project.
  void findProject()
  {
    const auto isProject = [&](const std::string& path)
    {
      return path != "-" &&
        translated(ExitStatus::usage, [&] { return ProjectFile::looksLike(headOfFile(path)); });
    };
    const std::vector<std::string>& inputs = this->Line.inputs;
    if (inputs.size() == 1 && isProject(inputs.front()))
    {
      this->OldProject = inputs.front();
    }
    else if (inputs.size() == 1 && isProjectName(inputs.front()))
    {
      throw Failure(ExitStatus::usage,
        inputs.front() + ": is no Scanwrap project, or its beginning is damaged");
    }
    else if (std::ranges::any_of(inputs, isProject))
    {
      throw Failure(ExitStatus::usage, "a project is opened alone; leave out the other files");
    }
    if (!this->OldProject.empty() && !this->NewProject.empty() &&
      isSameFile(this->OldProject, this->NewProject))
    {
      throw Failure(ExitStatus::usage,
        this->OldProject + ": keeps every step already; leave out -o " + this->NewProject);
    }
    this->HasProject = !this->OldProject.empty() || !this->NewProject.empty();
  }

  void readTemplate()
  {
    if (!this->Line.templateFile.empty())
    {
      this->Template =
        translated(ExitStatus::usage, [&] { return readRecipe(this->Line.templateFile); });
    }
  }

  bool hasAnalysis() const
  {
    return std::ranges::any_of(this->Line.steps,
      [](const CommandLine::Step& step)
      {
        const auto* wish = std::get_if<OperationWish>(&step);
        return wish != nullptr && (wish->operation->stage == Stage::analysis || isHistory(*wish));
      });
  }

  /// Whether what is whole of a damaged project was to be saved.
  bool salvage()
  {
    const auto* const first =
      this->Line.steps.empty() ? nullptr : std::get_if<OperationWish>(&this->Line.steps.front());
    const std::string path = first != nullptr ? salvageIn(*first) : "";
    if (path.empty())
    {
      return false;
    }
    this->Progress.start("salvage");
    const std::string told = translated(ExitStatus::usage,
      [&]
      {
        Execution execution(this->Options.threads, this->Options.token, this->Options.progress);
        return textOf(ProjectFile::salvage(this->Line.inputs.front(), path, execution));
      });
    this->Progress.finish();
    this->tell(told);
    return true;
  }

  void openDocument()
  {
    if (this->OldProject.empty())
    {
      this->openFiles();
      return;
    }
    translated(ExitStatus::usage,
      [&]
      {
        if (!this->NewProject.empty())
        {
          ProjectFile::copy(this->OldProject, this->NewProject);
        }
        this->Doc = Document::open(this->NewProject.empty() ? this->OldProject : this->NewProject);
      });
    const std::string& why = this->Doc.project()->whyReadOnly();
    this->note(why.empty() ? "" : "can only be read: " + why, this->Doc.project()->path());
  }

  void openFiles()
  {
    if (!this->NewProject.empty())
    {
      this->Doc = Document::create(this->NewProject);
    }
    this->Progress.start("open");
    const StepResult opened = this->Doc.import(this->Opening, this->Options,
      [&](const std::string& path, const StepResult& step)
      {
        this->note(step.note, path);
        if (!path.empty())
        {
          this->record("open", { { "file", path } }, step);
          this->Progress.start("open");
        }
      });
    this->Progress.finish();
    throwUnlessOk(opened.outcome, "", ExitStatus::usage);
  }

  /// What the user should know, told when everything went well.
  void note(const std::string& text, const std::string& about = {})
  {
    if (!text.empty() && !this->Line.quiet)
    {
      this->Notes += "scanwrap: " + about + (about.empty() ? "" : ": ") + text + "\n";
    }
  }

  /// Text that was asked for.
  void tell(const std::string& text) const
  {
    if (text.empty() || this->Line.quiet)
    {
      return;
    }
    if (this->IsOutputFree)
    {
      translated(ExitStatus::failed, [&] { writeText("-", text); });
    }
    else
    {
      say(text);
    }
  }

  void apply(const OperationWish& wish)
  {
    const Operation& operation = *wish.operation;
    this->Progress.start(operation.verb);
    const StepResult step = this->Doc.apply(operation, wish.given, this->Options);
    this->finish(operation.verb, completeValues(operation, wish.given), step, ExitStatus::failed);
    this->note(step.note, operation.verb);
    this->Picture = vtkPolyData::SafeDownCast(step.output) == nullptr ? step.output : nullptr;
    if (operation.stage == Stage::analysis)
    {
      Results found = step.results;
      std::erase_if(found, [](const auto& result) { return result.first.starts_with("output-"); });
      this->tell(tableOf(found));
    }
  }

  void tellHistory(const ParameterValues& given)
  {
    this->Progress.start("history");
    HistoryAnswer answer;
    const StepResult step = guardedStep(
      [&]
      {
        const auto start = std::chrono::steady_clock::now();
        answer = runHistory(this->Doc, given, this->Options, this->Line.overwrite);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        StepResult done;
        done.seconds = time.count();
        done.peakBytes = peakMemory();
        done.results = answer.results;
        return done;
      });
    this->finish("history", given, step, ExitStatus::failed);
    this->HasFailedCheck = this->HasFailedCheck || answer.hasFailedCheck;
    this->Picture = nullptr;
    this->tell(answer.text);
  }

  void save(const OutputWish& wish)
  {
    const std::string& path = wish.path;
    if (isProjectName(path))
    {
      return; // holds every step already
    }
    const Format& format = formatToWrite(path);
    ParameterValues values = wish.given;
    if (std::ranges::find(format.writeParameters, "encoding", &Parameter::name) !=
      format.writeParameters.end())
    {
      values.emplace("encoding", this->Line.encoding);
    }
    values = completeValues(format.writeParameters, values, path);
    const vtkSmartPointer<vtkPolyData> model = translated(
      ExitStatus::failed, [&] { return this->Doc.result(this->Doc.current(), this->Options); });
    if (format.isPicture && this->Picture == nullptr)
    {
      this->apply({ findOperation("render"), {} });
    }
    vtkDataObject* const data = format.isPicture ? this->Picture.Get() : model.Get();
    const auto writer = format.makeWriter(path, values);
    this->Progress.start("save");
    values.emplace("file", path);
    StepResult saved = runAlgorithm(*writer, data, this->Options);
    addToNote(saved.note, lossesOf(format, *model));
    this->finish("save", values, saved, ExitStatus::failed);
    this->note(saved.note, path);
  }

  void record(const std::string& verb, const ParameterValues& parameters, const StepResult& step)
  {
    this->Progress.finish();
    this->Steps.add(verb, parameters, step);
    if (this->Line.verbose && step.outcome.state == State::ok)
    {
      say(fmt::format("{}: {:.2f} s, {:.0f} MB\n{}", verb, step.seconds,
        static_cast<double>(step.peakBytes) / 1e6, tableOf(step.results)));
    }
  }

  /// Records a step and throws unless it went well.
  void finish(const std::string& verb, const ParameterValues& parameters, const StepResult& step,
    ExitStatus ifFailed)
  {
    this->record(verb, parameters, step);
    // messages about files name them
    throwUnlessOk(step.outcome, verb == "save" ? "" : verb + ": ", ifFailed);
  }

  static void throwUnlessOk(
    const vtkScanOutcome& outcome, const std::string& prefix, ExitStatus ifFailed)
  {
    if (outcome.state == State::cancelled)
    {
      throw Failure(ExitStatus::cancelled, "cancelled");
    }
    if (outcome.state == State::failed)
    {
      throw Failure(statusOf(outcome.code, ifFailed), prefix + outcome.message);
    }
  }

  const CommandLine& Line;
  TerminalProgress Progress;
  RunOptions Options;
  Record Steps;
  std::string OldProject; // the input, if it is one
  std::string NewProject; // the output, if one is
  bool HasProject = false;
  Recipe Template;
  ParameterValues Opening;
  std::unique_ptr<const Import> Files;
  bool IsOutputFree = true; // nobody asked for data on standard output
  Document Doc;
  vtkSmartPointer<vtkDataObject> Picture; // of the model as it is
  bool HasFailedCheck = false;
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
