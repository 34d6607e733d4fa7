// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/history_verb.h"

#include "filters/base/error.h"
#include "pipeline/comparison.h"
#include "pipeline/history_text.h"
#include "pipeline/operation_rows.h"
#include "pipeline/output_files.h"
#include "pipeline/recipe.h"
#include "pipeline/result_text.h"

#include <algorithm>
#include <functional>

namespace scan
{

namespace
{

using State = vtkScanOutcome::State;

struct Request
{
  Document& document;
  const ParameterValues& values;
  const RunOptions& options;
  bool mayReplace;

  std::string text(std::string_view name) const { return valueOf<std::string>(this->values, name); }

  /// The step that --step names, else the current one.
  StepId step() const
  {
    const std::string named = this->text("step");
    return named.empty() ? this->document.step(this->document.current()).id
                         : this->document.find(named).id;
  }
};

HistoryAnswer list(const Request& request)
{
  HistoryAnswer answer;
  answer.text = request.text("step").empty() ? historyText(request.document)
                                             : stepText(request.document.step(request.step()));
  answer.results = { { "steps", static_cast<std::int64_t>(request.document.steps().size()) },
    { "current", request.document.current() } };
  return answer;
}

HistoryAnswer go(const Request& request)
{
  request.document.goTo(request.document.find(request.text("go")).id);
  return { .results = { { "current", request.document.current() } } };
}

ParameterTexts changesIn(const TextList& assignments)
{
  ParameterTexts changes;
  for (const std::string& assignment : assignments)
  {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos)
    {
      throw Error(ErrorCode::badParameter,
        "--set=" + assignment + ": expected an option and its value, as in --set=deep=true");
    }
    changes[assignment.substr(0, equals)] = assignment.substr(equals + 1);
  }
  return changes;
}

HistoryAnswer edit(const Request& request)
{
  const StepId step = request.document.find(request.text("edit")).id;
  const Replay replay = request.document.edit(
    step, changesIn(valueOf<TextList>(request.values, "set")), request.options);
  HistoryAnswer answer;
  std::int64_t done = 0;
  for (const Replay::Entry& entry : replay.entries)
  {
    answer.text += "step " + std::to_string(entry.from) +
      (entry.to != 0 ? " again as step " + std::to_string(entry.to) : " failed: " + entry.message) +
      "\n";
    done += entry.to != 0 ? 1 : 0;
  }
  if (replay.outcome.state == State::cancelled)
  {
    throw Cancelled();
  }
  if (replay.outcome.state == State::failed)
  {
    throw Error(replay.outcome.code,
      std::to_string(done) + " of " + std::to_string(replay.entries.size()) +
        " steps were done again; then: " + replay.outcome.message);
  }
  answer.results = { { "steps-again", done }, { "current", request.document.current() } };
  return answer;
}

HistoryAnswer remove(const Request& request)
{
  const StepId step = request.document.find(request.text("delete")).id;
  const std::size_t count = request.document.branchFrom(step).size();
  request.document.removeBranch(step);
  return { .results = { { "steps-deleted", static_cast<std::int64_t>(count) },
             { "current", request.document.current() } } };
}

HistoryAnswer giveName(const Request& request)
{
  const StepId step = request.step();
  request.document.setName(step, request.text("name"));
  return { .results = { { "step", step }, { "name", request.text("name") } } };
}

HistoryAnswer compareSteps(const Request& request)
{
  const std::string pair = request.text("compare");
  const std::size_t comma = pair.find(',');
  if (comma == std::string::npos)
  {
    throw Error(
      ErrorCode::badParameter, "--compare=" + pair + ": expected two steps, as in --compare=2,5");
  }
  Document& document = request.document;
  const Comparison found = compare(document, document.find(pair.substr(0, comma)).id,
    document.find(pair.substr(comma + 1)).id, request.options);
  HistoryAnswer answer;
  const auto tell = [&](const char* which, const std::vector<StepId>& steps)
  {
    for (const StepId step : steps)
    {
      answer.text += std::string("only ") + which + "  " + std::to_string(step) + "  " +
        commandOf(document.step(step)) + "\n";
    }
  };
  tell("a", found.onlyA);
  tell("b", found.onlyB);
  answer.text += tableOf(found.measures);
  answer.results = found.measures;
  return answer;
}

HistoryAnswer saveTemplate(const Request& request)
{
  const std::string path = request.text("save-template");
  checkOutput(path, request.mayReplace);
  const Recipe recipe = recipeOf(request.document, request.step());
  writeText(path, textOf(recipe));
  return { .results = { { "operations", static_cast<std::int64_t>(recipe.size()) } } };
}

HistoryAnswer keepTemplate(const Request& request)
{
  ProjectFile* const project = request.document.project();
  if (project == nullptr)
  {
    throw Error(ErrorCode::badParameter,
      "there is no project to keep a template in; write it to a file: --save-template=FILE");
  }
  const std::string name = request.text("keep-template");
  project->keepText("template", name, textOf(recipeOf(request.document, request.step())));
  return { .results = { { "template", name } } };
}

HistoryAnswer check(const Request& request)
{
  const ProjectFile* const project = request.document.project();
  if (project == nullptr)
  {
    throw Error(ErrorCode::badParameter, "there is no project to check; make one with -o NAME.wrp");
  }
  Execution execution(request.options.threads, request.options.token, request.options.progress);
  execution.plan({ { "read", 1.0 } });
  HistoryAnswer answer;
  for (const StepId step : project->findDamage(execution))
  {
    answer.text += "the result of step " + std::to_string(step) + " is damaged\n";
    answer.hasFailedCheck = true;
  }
  if (!answer.hasFailedCheck)
  {
    answer.text = "every result is as it was stored\n";
  }
  answer.results = { { "whole", !answer.hasFailedCheck } };
  return answer;
}

HistoryAnswer verify(const Request& request)
{
  HistoryAnswer answer;
  for (const auto& [step, reason] : request.document.verify(request.options))
  {
    answer.text += "step " + std::to_string(step) + ": " + reason + "\n";
    answer.hasFailedCheck = true;
  }
  const auto count = static_cast<std::int64_t>(request.document.steps().size());
  if (!answer.hasFailedCheck)
  {
    answer.text = "all " + std::to_string(count) + " steps come out the same\n";
  }
  answer.results = { { "steps", count }, { "same", !answer.hasFailedCheck } };
  return answer;
}

struct Action
{
  Parameter option;
  HistoryAnswer (*run)(const Request&);
};

const std::vector<Action>& actions()
{
  static const std::vector<Action> kActions{
    { { .name = "go", .defaultValue = "", .help = "go to this step, by its number or name" }, go },
    { { .name = "edit",
        .defaultValue = "",
        .help = "do this step again with what --set says, and all that stand on it" },
      edit },
    { { .name = "name", .defaultValue = "", .help = "give the step a name" }, giveName },
    { { .name = "delete", .defaultValue = "", .help = "delete this step and all that stand on it" },
      remove },
    { { .name = "compare",
        .defaultValue = "",
        .help = "tell what is different between two steps, as in 2,5" },
      compareSteps },
    { { .name = "save-template",
        .defaultValue = "",
        .help = "write the operations that lead to the step to this file, for --template" },
      saveTemplate },
    { { .name = "keep-template",
        .defaultValue = "",
        .help = "keep them in the project by this name, for --template=PROJECT.wrp:NAME" },
      keepTemplate },
    { { .name = "check",
        .defaultValue = false,
        .help = "read every result and compare it with its hash; status 3 if one is damaged" },
      check },
    { { .name = "verify",
        .defaultValue = false,
        .help = "do all steps again and compare the results; status 3 if one is different" },
      verify },
  };
  return kActions;
}

} // namespace

const Operation& historyOperation()
{
  static const Operation kRow = []
  {
    Operation row;
    row.verb = "history";
    row.stage = Stage::history;
    row.help = "List the steps of a project, go to one, change one, compare two";
    row.example = "scanwrap part.wrp history --go=3 push --at=0,0,0";
    for (const Action& action : actions())
    {
      row.parameters.push_back(action.option);
    }
    row.parameters.push_back({ .name = "salvage",
      .defaultValue = "",
      .help = "save what is whole of a damaged project as this new one" });
    row.parameters.push_back({ .name = "set",
      .defaultValue = TextList(),
      .help = "with --edit: an option and its new value, as in --set=deep=true" });
    row.parameters.push_back({ .name = "step",
      .defaultValue = "",
      .help = "the step to show, to name, to make a template of; else the current one" });
    return row;
  }();
  return kRow;
}

HistoryAnswer runHistory(
  Document& document, const ParameterValues& given, const RunOptions& options, bool mayReplace)
{
  const ParameterValues values =
    completeValues(historyOperation().parameters, given, historyOperation().verb);
  const Request request{ document, values, options, mayReplace };
  const Action* wanted = nullptr;
  for (const Action& action : actions())
  {
    const auto asked = given.find(action.option.name);
    if (asked == given.end() || asked->second == action.option.defaultValue)
    {
      continue;
    }
    if (wanted != nullptr)
    {
      throw Error(ErrorCode::badParameter,
        "--" + wanted->option.name + " and --" + action.option.name +
          " are two things; say history twice");
    }
    wanted = &action;
  }
  if (wanted != nullptr)
  {
    return wanted->run(request);
  }
  if (given.contains("set"))
  {
    throw Error(ErrorCode::badParameter, "--set changes a step; say which: --edit=STEP");
  }
  return list(request);
}

} // namespace scan
