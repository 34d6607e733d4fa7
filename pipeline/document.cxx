// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document.h"

#include "filters/base/error.h"
#include "filters/wrap/vtkScanWrapData.h"
#include "pipeline/form_hash.h"
#include "pipeline/time_text.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace scan
{

namespace
{

using State = vtkScanOutcome::State;

constexpr const char* kOpen = "open";
constexpr const char* kFiles = "files"; ///< its parameter
constexpr const char* kFile = "file";   ///< of operations that read another file

Execution executionFor(const RunOptions& options)
{
  return Execution(options.threads, options.token, options.progress);
}

/// Whether an operation only looks at the model, which stays as it is.
bool onlyLooks(const Operation& operation, const ParameterValues& values)
{
  const auto preview = values.find("preview");
  return operation.stage == Stage::analysis ||
    (preview != values.end() && preview->second == ParameterValue(true));
}

/// Bytes of a result in memory, about; what results share is counted once.
std::int64_t bytesOf(vtkPolyData& result, std::set<const ScanComplex*>& counted)
{
  constexpr std::int64_t kKilobyte = 1024;
  constexpr std::int64_t kBytesOfTet = 60; // of a complex and what it brings with it
  std::int64_t bytes = kKilobyte * static_cast<std::int64_t>(result.GetActualMemorySize());
  const auto* const wrap = vtkScanWrapData::SafeDownCast(&result);
  const auto scan = wrap != nullptr ? wrap->GetModel().scan : nullptr;
  if (scan)
  {
    const std::int64_t tets = scan->delaunay().tetCount();
    bytes += tets * (counted.insert(scan.get()).second ? kBytesOfTet : 1);
  }
  return bytes;
}

/// Where the files are now: under the paths that they were given by, or where these led to then.
TextList locate(const std::vector<ReadFile>& files)
{
  TextList paths;
  for (const ReadFile& file : files)
  {
    if (file.path == "-")
    {
      throw Error(ErrorCode::badInput, "standard input cannot be read again");
    }
    std::error_code ignored;
    paths.push_back(std::filesystem::exists(file.path, ignored) ? file.path : file.place);
    if (textOf(hashOfFile(paths.back())) != file.hash)
    {
      throw Error(ErrorCode::badInput, paths.back() + ": has changed since it was opened");
    }
  }
  return paths;
}

/// The files that a step with these parameters reads.
std::vector<ReadFile> filesOf(const ParameterValues& values, const CancelToken& token)
{
  TextList paths;
  if (const auto several = values.find(kFiles); several != values.end())
  {
    paths = std::get<TextList>(several->second);
  }
  else if (const auto one = values.find(kFile); one != values.end())
  {
    paths = { std::get<std::string>(one->second) };
  }
  std::vector<ReadFile> files;
  for (const std::string& path : paths)
  {
    files.push_back(describeFile(path, token));
  }
  return files;
}

std::optional<StepId> numberIn(const std::string& text)
{
  StepId number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc() && end == text.data() + text.size() ? std::optional(number)
                                                                   : std::nullopt;
}

} // namespace

const std::vector<Parameter>* parametersOf(const std::string& verb)
{
  const Operation* const operation = findOperation(verb);
  return verb == kOpen     ? &openParameters()
    : operation != nullptr ? &operation->parameters
                           : nullptr;
}

ParameterValues parseValues(const std::string& verb, const ParameterTexts& texts)
{
  const std::vector<Parameter>* const parameters = parametersOf(verb);
  if (parameters == nullptr)
  {
    throw Error(ErrorCode::badParameter,
      "this Scanwrap has no operation " + verb + "; use the one that the step was made with");
  }
  ParameterValues values;
  for (const auto& [name, text] : texts)
  {
    const auto parameter = std::ranges::find(*parameters, name, &Parameter::name);
    if (parameter == parameters->end())
    {
      std::string message = verb;
      message.append(": there is no option --").append(name);
      throw Error(ErrorCode::badParameter, message);
    }
    const bool isEmptyList = text.empty() &&
      (std::holds_alternative<PointList>(parameter->defaultValue) ||
        std::holds_alternative<IdList>(parameter->defaultValue));
    values[name] = isEmptyList ? parameter->defaultValue : parseValue(*parameter, text);
  }
  return completeValues(*parameters, values, verb);
}

ParameterTexts textsOf(const ParameterValues& values)
{
  ParameterTexts texts;
  for (const auto& [name, value] : values)
  {
    texts[name] = textOf(value);
  }
  return texts;
}

Document::Document(std::int64_t memoryBudget)
  : Budget(memoryBudget)
{
}

Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

Document Document::open(const std::string& project, std::int64_t memoryBudget)
{
  Document document(memoryBudget);
  document.File = std::make_unique<ProjectFile>(project);
  document.Steps = document.File->steps();
  document.Current = document.File->current();
  if (document.Current != 0)
  {
    document.step(document.Current); // must be there
  }
  return document;
}

Document Document::create(const std::string& project, std::int64_t memoryBudget)
{
  Document document(memoryBudget);
  document.NewFile = project;
  return document;
}

Document Document::withoutHashes()
{
  Document document;
  document.HasHashes = false;
  return document;
}

Step* Document::findStep(StepId id)
{
  const auto found = std::ranges::lower_bound(this->Steps, id, {}, &Step::id);
  return found != this->Steps.end() && found->id == id ? &*found : nullptr;
}

const Step& Document::step(StepId id) const
{
  const Step* const found = const_cast<Document*>(this)->findStep(id);
  if (found == nullptr)
  {
    throw Error(ErrorCode::badParameter,
      id == 0 ? "there are no steps; start from files again, as in: scanwrap FILE -o NAME.wrp"
              : "there is no step " + std::to_string(id) + "; history lists those there are");
  }
  return *found;
}

const Step& Document::find(const std::string& nameOrNumber) const
{
  if (const std::optional<StepId> number = numberIn(nameOrNumber))
  {
    return this->step(*number);
  }
  const auto named = std::ranges::find(this->Steps, nameOrNumber, &Step::name);
  if (nameOrNumber.empty() || named == this->Steps.end())
  {
    throw Error(ErrorCode::badParameter,
      "there is no step '" + nameOrNumber + "'; history lists those there are");
  }
  return *named;
}

void Document::goTo(StepId step)
{
  this->step(step);
  if (this->File)
  {
    this->File->setCurrent(step);
  }
  this->Current = step;
  this->trim();
}

std::vector<StepId> Document::pathTo(StepId step) const
{
  std::vector<StepId> path;
  for (StepId id = step; id != 0; id = this->step(id).parent)
  {
    path.push_back(id);
  }
  std::ranges::reverse(path);
  return path;
}

std::vector<StepId> Document::branchFrom(StepId step) const
{
  std::vector<StepId> branch = { this->step(step).id };
  for (const Step& other : this->Steps) // parents come before their children
  {
    if (std::ranges::binary_search(branch, other.parent))
    {
      branch.push_back(other.id);
    }
  }
  return branch;
}

void Document::hold(StepId step, vtkSmartPointer<vtkPolyData> result)
{
  this->Ages.push_front(step);
  this->Seen[step] = result;
  this->Results[step] = { std::move(result), this->Ages.begin() };
  this->trim();
}

void Document::trim()
{
  std::set<const ScanComplex*> counted;
  std::int64_t bytes = 0;
  if (const auto current = this->Results.find(this->Current); current != this->Results.end())
  {
    bytesOf(*current->second.result, counted); // is kept anyhow
  }
  for (auto age = this->Ages.begin(); age != this->Ages.end();)
  {
    const StepId step = *age;
    bytes += step == this->Current ? 0 : bytesOf(*this->Results.at(step).result, counted);
    if (step != this->Current && bytes > this->Budget)
    {
      this->Results.erase(step);
      age = this->Ages.erase(age);
    }
    else
    {
      ++age;
    }
  }
}

vtkSmartPointer<vtkPolyData> Document::result(StepId id, const RunOptions& options)
{
  const Step& step = this->step(id);
  if (const auto held = this->Results.find(id); held != this->Results.end())
  {
    this->Ages.splice(this->Ages.begin(), this->Ages, held->second.age);
    return held->second.result;
  }
  vtkSmartPointer<vtkPolyData> result = this->Seen[id].GetPointer();
  if (result != nullptr)
  {
    this->hold(id, result);
    return result;
  }
  if (this->File && this->File->hasResult(id))
  {
    Execution execution = executionFor(options);
    execution.plan({ { "read", 1.0 } });
    result = this->File->readResult(id, this->Complexes, execution);
  }
  else
  {
    const StepResult again = this->rerun(step, options);
    if (again.outcome.state == State::cancelled)
    {
      throw Cancelled();
    }
    if (again.outcome.state == State::failed)
    {
      throw Error(again.outcome.code,
        "step " + std::to_string(id) + " cannot be done again: " + again.outcome.message);
    }
    result = vtkPolyData::SafeDownCast(again.output);
  }
  this->hold(id, result);
  return result;
}

StepResult Document::runOn(StepId parent, const std::string& verb, const ParameterTexts& parameters,
  const RunOptions& options)
{
  return guardedStep(
    [&]
    {
      const ParameterValues values = parseValues(verb, parameters);
      if (verb == kOpen)
      {
        return Import(values, options.token).run(options, nullptr);
      }
      const vtkSmartPointer<vtkPolyData> input = this->result(parent, options);
      return runOperation(*findOperation(verb), values, *input, options);
    });
}

StepResult Document::rerun(const Step& step, const RunOptions& options)
{
  return guardedStep(
    [&]
    {
      ParameterTexts parameters = step.parameters;
      if (!step.files.empty())
      {
        parameters[step.verb == kOpen ? kFiles : kFile] = textOf(locate(step.files));
      }
      return this->runOn(step.parent, step.verb, parameters, options);
    });
}

void Document::keep(StepId parent, const std::string& verb, const ParameterValues& values,
  StepResult& result, const RunOptions& options)
{
  auto* const model = vtkPolyData::SafeDownCast(result.output);
  Step step;
  step.parent = parent;
  step.verb = verb;
  step.parameters = textsOf(values);
  step.seconds = result.seconds;
  step.peakBytes = result.peakBytes;
  step.results = result.results;
  step.note = result.note;
  step.program = SCAN_VERSION;
  step.finished = timeText();
  step.files = this->HasHashes ? filesOf(values, options.token) : std::vector<ReadFile>();
  Execution execution = executionFor(options);
  execution.plan({ { "store", 1.0 } });
  if (!this->NewFile.empty())
  {
    ProjectFile::create(this->NewFile);
    this->File = std::make_unique<ProjectFile>(std::exchange(this->NewFile, {}));
  }
  if (this->File)
  {
    this->File->addStep(step, *model, execution);
    auto* const wrap = vtkScanWrapData::SafeDownCast(model);
    if (wrap != nullptr && wrap->GetModel().scan)
    {
      this->Complexes[complexOf(this->File->formOf(step.id))] = wrap->GetModel().scan;
    }
  }
  else
  {
    step.id = this->Last + 1;
    step.inputHash = parent != 0 ? this->step(parent).resultHash : std::string();
    step.resultHash = this->HasHashes ? hashesOf(formOf(*model), execution).form : std::string();
  }
  this->Last = std::max(this->Last, step.id);
  this->Current = step.id;
  this->Steps.push_back(std::move(step));
  this->hold(this->Current, model);
}

StepResult Document::import(
  const ParameterValues& values, const RunOptions& options, const Import::Listener& listener)
{
  return guardedStep(
    [&]
    {
      StepResult result = Import(values, options.token).run(options, listener);
      if (result.outcome.state == State::ok)
      {
        this->keep(0, kOpen, values, result, options);
      }
      return result;
    });
}

StepResult Document::apply(
  const Operation& operation, const ParameterValues& given, const RunOptions& options)
{
  return guardedStep(
    [&]
    {
      const ParameterValues values = completeValues(operation, given);
      const bool isStep = !onlyLooks(operation, values);
      if (isStep && this->File)
      {
        this->File->checkWritable();
      }
      const vtkSmartPointer<vtkPolyData> input = this->result(this->Current, options);
      StepResult result = runOperation(operation, values, *input, options);
      if (isStep && result.outcome.state == State::ok)
      {
        this->keep(this->Current, operation.verb, values, result, options);
      }
      return result;
    });
}

Replay Document::edit(StepId id, const ParameterTexts& changes, const RunOptions& options)
{
  const Step& changed = this->step(id);
  ParameterTexts parameters = changed.parameters;
  for (const auto& [name, text] : changes)
  {
    parameters[name] = text;
  }
  parseValues(changed.verb, parameters);
  if (this->File)
  {
    this->File->checkWritable();
  }

  const StepId before = this->Current;
  Replay replay;
  std::map<StepId, StepId> counterparts = { { changed.parent, changed.parent } };
  for (const StepId old : this->branchFrom(id))
  {
    const Step step = this->step(old); // a copy: steps are added
    const auto parent = counterparts.find(step.parent);
    Replay::Entry entry{ old, 0, "the step before it failed" };
    if (parent != counterparts.end() && replay.outcome.state != State::cancelled)
    {
      const ParameterTexts& texts = old == id ? parameters : step.parameters;
      const StepResult result = guardedStep(
        [&]
        {
          StepResult again = this->runOn(parent->second, step.verb, texts, options);
          if (again.outcome.state == State::ok)
          {
            this->keep(parent->second, step.verb, parseValues(step.verb, texts), again, options);
          }
          return again;
        });
      if (result.outcome.state == State::ok)
      {
        entry = { old, this->Current, {} };
        counterparts[old] = this->Current;
      }
      else
      {
        entry.message = result.outcome.message;
        replay.outcome = replay.outcome.state == State::ok ? result.outcome : replay.outcome;
      }
    }
    replay.entries.push_back(std::move(entry));
  }
  const auto counterpart = counterparts.find(before);
  const auto first = counterparts.find(id);
  this->goTo(counterpart != counterparts.end() ? counterpart->second
      : first != counterparts.end()            ? first->second
                                               : before);
  return replay;
}

std::vector<std::pair<StepId, std::string>> Document::verify(const RunOptions& options)
{
  std::vector<std::pair<StepId, std::string>> wrong;
  for (const Step& step : this->Steps)
  {
    StepResult again = this->rerun(step, options);
    if (again.outcome.state == State::cancelled)
    {
      throw Cancelled();
    }
    if (again.outcome.state == State::failed)
    {
      wrong.emplace_back(step.id, again.outcome.message);
      continue;
    }
    Execution execution = executionFor(options);
    if (hashesOf(formOf(*vtkPolyData::SafeDownCast(again.output)), execution).form !=
      step.resultHash)
    {
      wrong.emplace_back(step.id, "the result comes out different");
    }
  }
  return wrong;
}

void Document::setName(StepId id, const std::string& name)
{
  this->step(id);
  const auto other = std::ranges::find(this->Steps, name, &Step::name);
  if (!name.empty() && other != this->Steps.end() && other->id != id)
  {
    throw Error(ErrorCode::badParameter,
      "step " + std::to_string(other->id) + " has the name '" + name + "' already");
  }
  if (numberIn(name))
  {
    throw Error(ErrorCode::badParameter, "'" + name + "' is a number; a name needs a letter, too");
  }
  if (this->File)
  {
    this->File->setName(id, name);
  }
  this->findStep(id)->name = name;
}

void Document::removeBranch(StepId id)
{
  const std::vector<StepId> branch = this->branchFrom(id);
  const auto isRemoved = [&](StepId step) { return std::ranges::binary_search(branch, step); };
  const StepId current = isRemoved(this->Current) ? this->step(id).parent : this->Current;
  if (this->File)
  {
    this->File->removeSteps(branch, current);
  }
  std::erase_if(this->Steps, [&](const Step& step) { return isRemoved(step.id); });
  std::erase_if(this->Results, [&](const auto& entry) { return isRemoved(entry.first); });
  std::erase_if(this->Ages, isRemoved);
  std::erase_if(this->Seen, [&](const auto& entry) { return isRemoved(entry.first); });
  this->Current = current;
}

} // namespace scan
