// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/import.h"
#include "pipeline/operation_table.h"
#include "pipeline/project_file.h"
#include "pipeline/runner.h"
#include "pipeline/step.h"

#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

namespace scan
{

/// What became of the steps that were to be done again.
struct Replay
{
  struct Entry
  {
    StepId from = 0;     ///< the step as it was
    StepId to = 0;       ///< the step that was made; 0: failed, or the one before failed
    std::string message; ///< why not
  };
  std::vector<Entry> entries;
  vtkScanOutcome outcome; ///< that of the first step that went wrong
};

/// A session: the tree of steps, the results that nobody changes, and the place in it.
///
/// Undo is goTo() the parent, a branch a step on another one than the last. A step that fails or is
/// cancelled leaves everything as it was. With a project every step is durable before it is told.
/// Results live in memory while they fit the budget; others are read from the project, or done
/// again from the nearest one that is there. Not for several threads. Functions throw Error for
/// steps that are not there, and what ProjectFile throws.
class Document
{
public:
  /// @param memoryBudget bytes of results beside the current one, about
  explicit Document(std::int64_t memoryBudget = 0);
  ~Document();
  Document(Document&&) noexcept;
  Document& operator=(Document&&) noexcept;

  /// Goes on with a project, where it was left.
  static Document open(const std::string& project, std::int64_t memoryBudget = 0);

  /// A new project, which takes its name, and the place of what had it, when its first step is
  /// done.
  static Document create(const std::string& project, std::int64_t memoryBudget = 0);

  /// In memory only, for one run: steps have no hashes, which take time.
  static Document withoutHashes();

  /// The file; null in memory, and in a new project without steps.
  const ProjectFile* project() const { return this->File.get(); }
  ProjectFile* project() { return this->File.get(); }

  /// By their numbers.
  const std::vector<Step>& steps() const { return this->Steps; }
  const Step& step(StepId id) const;

  /// The step that a user means by its number or its name.
  /// @throws Error badParameter
  const Step& find(const std::string& nameOrNumber) const;

  StepId current() const { return this->Current; } ///< 0 before the first step
  void goTo(StepId step);

  /// From the first step down to this one.
  std::vector<StepId> pathTo(StepId step) const;

  /// A step and all that stand on it, by their numbers.
  std::vector<StepId> branchFrom(StepId step) const;

  /// The result of a step; read or done again where it is not in memory.
  /// @throws Error, Cancelled
  vtkSmartPointer<vtkPolyData> result(StepId step, const RunOptions& options);

  /// Opens files: a new first step.
  /// @param values of openParameters()
  StepResult import(
    const ParameterValues& values, const RunOptions& options, const Import::Listener& listener);

  /// Runs an operation on the current result. It becomes a step, the current one, unless it leaves
  /// the model as it is: an analysis, a preview.
  StepResult apply(
    const Operation& operation, const ParameterValues& given, const RunOptions& options);

  /// Does a step again with other parameters, and all that stand on it: a new branch beside the old
  /// one. The current step moves to its counterpart, if it has one.
  /// @param changes texts of the parameters that are to be others
  /// @throws Error badParameter before anything is done
  Replay edit(StepId step, const ParameterTexts& changes, const RunOptions& options);

  /// Does all steps again, and keeps nothing of it: those whose results come out different, or not
  /// at all, with the reason.
  std::vector<std::pair<StepId, std::string>> verify(const RunOptions& options);

  /// @throws Error badParameter for a name that is a number or that another step has
  void setName(StepId step, const std::string& name);

  /// Deletes a step and all that stand on it. The current step, if it is one of them, becomes the
  /// parent.
  void removeBranch(StepId step);

private:
  struct Held
  {
    vtkSmartPointer<vtkPolyData> result;
    std::list<StepId>::iterator age;
  };

  Step* findStep(StepId id);
  StepResult runOn(StepId parent, const std::string& verb, const ParameterTexts& parameters,
    const RunOptions& options);
  StepResult rerun(const Step& step, const RunOptions& options);
  void keep(StepId parent, const std::string& verb, const ParameterValues& values,
    StepResult& result, const RunOptions& options);
  void hold(StepId step, vtkSmartPointer<vtkPolyData> result);
  void trim();

  std::unique_ptr<ProjectFile> File;
  bool HasHashes = true;
  std::string NewFile; ///< of a project to be
  std::vector<Step> Steps;
  StepId Current = 0;
  StepId Last = 0; ///< the highest number ever given
  std::int64_t Budget;
  std::map<StepId, Held> Results;
  std::map<StepId, vtkWeakPointer<vtkPolyData>> Seen; ///< results that others may still hold
  std::list<StepId> Ages;                             ///< the result used last in front
  LoadedComplexes Complexes;
};

/// The parameters of a verb, "open" too; null for a verb that this program does not know.
const std::vector<Parameter>* parametersOf(const std::string& verb);

/// @throws Error badParameter for an unknown verb, an unknown name or a wrong value
ParameterValues parseValues(const std::string& verb, const ParameterTexts& texts);

ParameterTexts textsOf(const ParameterValues& values);

} // namespace scan
