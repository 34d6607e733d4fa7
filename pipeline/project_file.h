// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "pipeline/data_form.h"
#include "pipeline/database.h"
#include "pipeline/step.h"

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace scan
{

/// What salvage() found.
struct SalvageReport
{
  std::int64_t steps = 0;   ///< that are saved
  std::int64_t results = 0; ///< steps that are saved with their results
  std::int64_t lost = 0;    ///< steps that are known to have been there and are lost
  std::vector<StepId> withoutResult;
  bool isListWhole = true; ///< else there may have been more
};

/// For the user.
std::string textOf(const SalvageReport& report);

/// Whether a file of that name is a project: NAME.wrp.
bool isProjectName(const std::string& path);

/// A project: the steps of a history and their results in one SQLite file (docs/project-file.md).
///
/// A step is durable when addStep() returns; until then the file holds nothing of it, whatever
/// happens. Results share arrays, and arrays share chunks of 256 KiB, by their hashes. What is read
/// is checked against its hash. The first program that opens a file for writing holds it; another
/// one can only read it meanwhile. Everything throws Error io, parse or limit, and names the file.
class ProjectFile
{
public:
  static constexpr int kSchema = 2;

  /// Whether a file that starts so is a project, of this or another version.
  static bool looksLike(std::span<const char> head);

  /// A new project without steps; replaces what has the name, unless a program has it open.
  static void create(const std::string& path);

  /// Copies a whole project; the copy appears under its name when it is complete.
  static void copy(const std::string& from, const std::string& path);

  /// Makes a new project of all that can be read of a damaged one.
  static SalvageReport salvage(
    const std::string& damaged, const std::string& path, Execution& execution);

  explicit ProjectFile(const std::string& path);

  const std::string& path() const { return this->Data.file(); }

  /// Why nothing can be added; empty when it can.
  const std::string& whyReadOnly() const { return this->ReadOnly; }

  /// @throws Error io with whyReadOnly() when nothing can be added
  void checkWritable() const;

  /// By their numbers.
  std::vector<Step> steps() const;

  /// The step that work goes on from; 0 in a project without steps.
  StepId current() const;
  void setCurrent(StepId step);

  /// Adds a step, makes it the current one and gives it its number, the hash of its input and of
  /// its result. Reports phase "store".
  void addStep(Step& step, vtkPolyData& result, Execution& execution);

  void setName(StepId step, const std::string& name);

  /// Removes these steps, which nothing else stands on, with what only they need.
  /// @param current the current step from then on
  void removeSteps(std::span<const StepId> steps, StepId current);

  bool hasResult(StepId step) const;

  /// How the result of a step is stored. Throws Error badInput for a step without one.
  StoredForm formOf(StepId step) const;

  /// Reports phase "read" and those of a complex.
  vtkSmartPointer<vtkPolyData> readResult(
    StepId step, LoadedComplexes& complexes, Execution& execution) const;

  /// Texts that the user keeps with the project, by name.
  /// @param kind "template" (see recipe.h) or "view" (as in the rules of regions)
  std::map<std::string, std::string> texts(const std::string& kind) const;
  void keepText(const std::string& kind, const std::string& name, const std::string& text);

  /// Reads and checks everything; the steps whose results are damaged.
  std::vector<StepId> findDamage(Execution& execution) const;

private:
  /// Held while the file is open for writing.
  class Lock
  {
  public:
    explicit Lock(const std::string& path);
    Lock(Lock&& other) noexcept;
    ~Lock();
    Lock(const Lock&) = delete;
    void operator=(const Lock&) = delete;

    const std::string& whyNot() const { return this->WhyNot; }

  private:
    int Descriptor = -1;
    std::string WhyNot;
  };

  friend class Salvager;
  struct Salvage
  {
  };
  ProjectFile(const std::string& path, Salvage);

  void check();
  void migrate();

  std::optional<std::int64_t> resultOf(StepId step) const; ///< its row
  StoredForm formOfResult(std::int64_t result) const;
  void readArray(
    const StoredForm::Array& array, std::span<char> values, Execution& execution) const;
  std::int64_t storeForm(const DataForm& form, std::string& hash, Execution& execution);
  std::int64_t storeArray(
    const ArrayForm& array, std::span<const Hash> chunks, const Hash& hash, Execution& execution);
  void insertStep(const Step& step, std::int64_t result);

  Lock Guard; // closed after the database: closing any descriptor of a file drops SQLite's locks
  std::string ReadOnly;
  Database Data;
  std::int64_t Schema = 0;
};

} // namespace scan
