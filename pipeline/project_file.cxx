// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/project_file.h"

#include "filters/base/error.h"
#include "filters/base/note.h"
#include "pipeline/array_codec.h"
#include "pipeline/form_hash.h"
#include "pipeline/json_text.h"
#include "readers/mapped_file.h"
#include "writers/output_file.h"

#include <vtkPolyData.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

namespace scan
{

namespace
{

constexpr std::size_t kBatch = 64; // chunks that are coded at a time

// "SWRP", at byte 68 of the file: https://www.sqlite.org/fileformat2.html#application_id
constexpr std::string_view kApplication = "SWRP";
constexpr std::size_t kApplicationPlace = 68;
constexpr std::string_view kMagic{ "SQLite format 3\0", 16 };

// docs/project-file.md explains it
constexpr const char* kSchemaSql = R"(
PRAGMA page_size = 16384;
PRAGMA auto_vacuum = INCREMENTAL;
PRAGMA application_id = 0x53575250;
PRAGMA user_version = 2;
CREATE TABLE project (key TEXT PRIMARY KEY, value) WITHOUT ROWID;
CREATE TABLE chunk (
  id INTEGER PRIMARY KEY, hash BLOB NOT NULL UNIQUE, size INTEGER NOT NULL, code BLOB NOT NULL);
CREATE TABLE array (
  id INTEGER PRIMARY KEY, hash BLOB NOT NULL, type TEXT NOT NULL, components INTEGER NOT NULL,
  tuples INTEGER NOT NULL, UNIQUE (hash, type, components));
CREATE TABLE array_chunk (
  array INTEGER NOT NULL REFERENCES array, number INTEGER NOT NULL,
  chunk INTEGER NOT NULL REFERENCES chunk, PRIMARY KEY (array, number)) WITHOUT ROWID;
CREATE TABLE result (
  id INTEGER PRIMARY KEY, hash TEXT NOT NULL UNIQUE, kind TEXT NOT NULL, facts TEXT NOT NULL);
CREATE TABLE result_array (
  result INTEGER NOT NULL REFERENCES result, role TEXT NOT NULL,
  array INTEGER NOT NULL REFERENCES array, PRIMARY KEY (result, role)) WITHOUT ROWID;
CREATE TABLE step (
  id INTEGER PRIMARY KEY AUTOINCREMENT, parent INTEGER REFERENCES step, verb TEXT NOT NULL,
  parameters TEXT NOT NULL, name TEXT UNIQUE, result INTEGER REFERENCES result,
  input_hash TEXT NOT NULL, result_hash TEXT NOT NULL, seconds REAL NOT NULL,
  peak_bytes INTEGER NOT NULL, results TEXT NOT NULL, note TEXT NOT NULL, program TEXT NOT NULL,
  finished TEXT NOT NULL, seal TEXT NOT NULL);
CREATE TABLE read_file (
  step INTEGER NOT NULL REFERENCES step, number INTEGER NOT NULL, path TEXT NOT NULL,
  place TEXT NOT NULL, format TEXT NOT NULL, bytes INTEGER NOT NULL, modified TEXT NOT NULL,
  hash TEXT NOT NULL, PRIMARY KEY (step, number)) WITHOUT ROWID;
CREATE TABLE kept_text (
  kind TEXT NOT NULL, name TEXT NOT NULL, text TEXT NOT NULL, PRIMARY KEY (kind, name)) WITHOUT ROWID;
CREATE VIEW region AS SELECT id AS step, json_extract(parameters, '$.name') AS name,
  json_extract(parameters, '$.rule') AS rule FROM step WHERE verb = 'select';
INSERT INTO project VALUES ('current', NULL);
)";

// Projects of schema 1 kept templates only
constexpr const char* kSchema2Sql = R"(
CREATE TABLE kept_text (
  kind TEXT NOT NULL, name TEXT NOT NULL, text TEXT NOT NULL, PRIMARY KEY (kind, name)) WITHOUT ROWID;
INSERT INTO kept_text SELECT 'template', name, text FROM template;
DROP TABLE template;
PRAGMA user_version = 2;
)";

constexpr const char* kStepColumns =
  "id, ifnull(parent, 0), verb, parameters, ifnull(name, ''), input_hash, result_hash, seconds, "
  "peak_bytes, results, note, program, finished, seal";

std::span<const char> bytesOf(const Hash& hash)
{
  return hash.bytes;
}

Hash hashIn(std::span<const char> bytes)
{
  Hash hash;
  if (bytes.size() != hash.bytes.size())
  {
    throw Error(ErrorCode::parse, "a hash in the project is damaged");
  }
  std::ranges::copy(bytes, hash.bytes.begin());
  return hash;
}

ValueLayout layoutOf(const ArrayShape& shape)
{
  return { widthOf(shape.type), static_cast<std::size_t>(shape.components),
    !shape.type.starts_with("float") };
}

/// Of a step, but for its name: tells whether its row was damaged.
std::string sealOf(const Step& step)
{
  std::string text = std::to_string(step.id);
  text += '\n';
  text += std::to_string(step.parent);
  const std::string parameters = jsonOf(step.parameters);
  const std::string results = jsonOf(step.results);
  for (const std::string* part : { &step.verb, &parameters, &step.inputHash, &step.resultHash,
         &results, &step.note, &step.program, &step.finished })
  {
    text += '\n';
    text += *part;
  }
  for (const ReadFile& file : step.files)
  {
    text += "\n" + file.path + "\n" + file.hash;
  }
  return textOf(hashOf(std::span<const char>(text)));
}

void readFiles(const Database& data, Step& step)
{
  Statement files = data.prepare("SELECT path, place, format, bytes, modified, hash FROM read_file "
                                 "WHERE step = ? ORDER BY number");
  files.with(step.id);
  while (files.next())
  {
    step.files.push_back({ files.text(0), files.text(1), files.text(2), files.integer(3),
      files.text(4), files.text(5) });
  }
}

/// The step of a row with kStepColumns; none when it is damaged.
std::optional<Step> stepIn(const Database& data, const Statement& row)
{
  Step step;
  step.id = row.integer(0);
  step.parent = row.integer(1);
  step.verb = row.text(2);
  step.parameters = parseTexts(row.text(3));
  step.name = row.text(4);
  step.inputHash = row.text(5);
  step.resultHash = row.text(6);
  step.seconds = row.real(7);
  step.peakBytes = row.integer(8);
  step.results = parseResults(row.text(9));
  step.note = row.text(10);
  step.program = row.text(11);
  step.finished = row.text(12);
  readFiles(data, step);
  return sealOf(step) == row.text(13) ? std::optional(std::move(step)) : std::nullopt;
}

std::optional<std::string_view> textOrNull(const std::string& text)
{
  return text.empty() ? std::nullopt : std::optional<std::string_view>(text);
}

std::optional<std::int64_t> stepOrNull(StepId step)
{
  return step == 0 ? std::nullopt : std::optional(step);
}

[[noreturn]] void refuseDamage(const std::string& file, const std::string& what)
{
  throw Error(ErrorCode::parse,
    file + ": " + what + " is damaged; save what is whole with: history --salvage=NEW.wrp");
}

/// An unfinished write to a project of that name is taken back: it must not be taken for one of the
/// project that takes its place.
void leaveNoJournal(const std::string& path)
{
  if (std::filesystem::exists(path))
  {
    try
    {
      const ProjectFile earlier(path);
      if (!earlier.whyReadOnly().empty())
      {
        throw Error(ErrorCode::io,
          path + ": cannot be replaced: " + earlier.whyReadOnly() + "; choose another name");
      }
      earlier.steps();
    }
    catch (const Error& error)
    {
      if (error.code() == ErrorCode::io)
      {
        throw;
      }
    }
  }
  std::filesystem::remove(behindLinks(path) + "-journal");
}

} // namespace

ProjectFile::Lock::Lock(const std::string& path)
{
  this->Descriptor = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (this->Descriptor < 0)
  {
    this->WhyNot = std::generic_category().message(errno);
    return;
  }
  // far behind the bytes that SQLite locks; it belongs to the descriptor, not to the process
  struct flock range = {};
  range.l_type = F_WRLCK;
  range.l_whence = SEEK_SET;
  range.l_start = off_t{ 1 } << 62U;
  range.l_len = 1;
  if (::fcntl(this->Descriptor, F_OFD_SETLK, &range) != 0)
  {
    this->WhyNot = errno == EAGAIN || errno == EACCES ? "another program has it open"
                                                      : std::generic_category().message(errno);
  }
}

ProjectFile::Lock::Lock(Lock&& other) noexcept
  : Descriptor(std::exchange(other.Descriptor, -1))
  , WhyNot(std::move(other.WhyNot))
{
}

ProjectFile::Lock::~Lock()
{
  if (this->Descriptor >= 0)
  {
    ::close(this->Descriptor);
  }
}

bool ProjectFile::looksLike(std::span<const char> head)
{
  const std::string_view text(head.data(), head.size());
  return text.starts_with(kMagic) && text.size() >= kApplicationPlace + kApplication.size() &&
    text.substr(kApplicationPlace, kApplication.size()) == kApplication;
}

void ProjectFile::create(const std::string& path)
{
  leaveNoJournal(path);
  OutputFile file(path);
  file.write(Database::imageOf(kSchemaSql));
  file.commit();
}

void ProjectFile::copy(const std::string& from, const std::string& path)
{
  leaveNoJournal(path);
  // nobody writes while a transaction reads
  Database source(from, Database::Access::readOnly);
  source.execute("BEGIN; SELECT count(*) FROM project");
  const MappedFile bytes(from);
  OutputFile file(path);
  file.write({ bytes.bytes().data(), bytes.bytes().size() });
  file.commit();
}

bool isProjectName(const std::string& path)
{
  return path.ends_with(".wrp") || path.ends_with(".WRP");
}

ProjectFile::ProjectFile(const std::string& path)
  : Guard(path)
  , ReadOnly(Guard.whyNot())
  , Data(path, ReadOnly.empty() ? Database::Access::readWrite : Database::Access::readOnly)
{
  this->check();
  if (this->ReadOnly.empty())
  {
    this->Data.execute("PRAGMA journal_mode = DELETE; PRAGMA synchronous = EXTRA; "
                       "PRAGMA foreign_keys = ON; PRAGMA cache_size = -32768");
    this->migrate();
  }
}

void ProjectFile::check()
{
  const auto pragma = [&](std::string_view sql)
  {
    Statement statement = this->Data.prepare(sql);
    return statement.next() ? statement.integer(0) : 0;
  };
  if (pragma("PRAGMA application_id") != 0x53575250)
  {
    throw Error(
      ErrorCode::parse, this->path() + ": is an SQLite database, but no Scanwrap project");
  }
  this->Schema = pragma("PRAGMA user_version");
  if (this->Schema > kSchema)
  {
    throw Error(ErrorCode::parse,
      this->path() + ": was made by a newer Scanwrap (schema " + std::to_string(this->Schema) +
        ", this one knows " + std::to_string(kSchema) + "); update the program");
  }
}

void ProjectFile::migrate()
{
  if (this->Schema < 2)
  {
    Transaction transaction(this->Data);
    this->Data.execute(kSchema2Sql);
    transaction.commit();
    this->Schema = 2;
  }
}

void ProjectFile::checkWritable() const
{
  if (!this->ReadOnly.empty())
  {
    throw Error(ErrorCode::io,
      this->path() + ": nothing can be saved: " + this->ReadOnly + "; work on a copy: -o COPY.wrp");
  }
}

std::vector<Step> ProjectFile::steps() const
{
  std::vector<Step> steps;
  Statement rows =
    this->Data.prepare(std::string("SELECT ") + kStepColumns + " FROM step ORDER BY id");
  while (rows.next())
  {
    std::optional<Step> step = stepIn(this->Data, rows);
    if (!step || step->parent >= step->id)
    {
      refuseDamage(this->path(), "step " + std::to_string(rows.integer(0)));
    }
    steps.push_back(std::move(*step));
  }
  return steps;
}

StepId ProjectFile::current() const
{
  Statement row = this->Data.prepare("SELECT value FROM project WHERE key = 'current'");
  return row.next() ? row.integer(0) : 0;
}

void ProjectFile::setCurrent(StepId step)
{
  this->checkWritable();
  this->Data.prepare("UPDATE project SET value = ? WHERE key = 'current'")
    .with(stepOrNull(step))
    .run();
}

void ProjectFile::setName(StepId step, const std::string& name)
{
  this->checkWritable();
  this->Data.prepare("UPDATE step SET name = ? WHERE id = ?").with(textOrNull(name), step).run();
}

void ProjectFile::addStep(Step& step, vtkPolyData& result, Execution& execution)
{
  this->checkWritable();
  execution.step("store", 0, 1);
  const DataForm form = scan::formOf(result);
  Transaction transaction(this->Data);
  step.inputHash.clear();
  if (step.parent != 0)
  {
    Statement parent = this->Data.prepare("SELECT result_hash FROM step WHERE id = ?");
    parent.with(step.parent);
    step.inputHash = parent.next() ? parent.text(0) : "";
  }
  const std::int64_t stored = this->storeForm(form, step.resultHash, execution);
  Statement last = this->Data.prepare("SELECT seq FROM sqlite_sequence WHERE name = 'step'");
  step.id = (last.next() ? last.integer(0) : 0) + 1;
  this->insertStep(step, stored);
  this->setCurrent(step.id);
  transaction.commit();
  execution.step("store", 1, 1);
}

void ProjectFile::insertStep(const Step& step, std::int64_t result)
{
  this->Data
    .prepare(
      "INSERT INTO step (id, parent, verb, parameters, name, result, input_hash, result_hash, "
      "seconds, peak_bytes, results, note, program, finished, seal) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
    .with(step.id, stepOrNull(step.parent), std::string_view(step.verb),
      std::string_view(jsonOf(step.parameters)), textOrNull(step.name), stepOrNull(result),
      std::string_view(step.inputHash), std::string_view(step.resultHash), step.seconds,
      step.peakBytes, std::string_view(jsonOf(step.results)), std::string_view(step.note),
      std::string_view(step.program), std::string_view(step.finished),
      std::string_view(sealOf(step)))
    .run();
  Statement insert = this->Data.prepare("INSERT INTO read_file VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < step.files.size(); ++i)
  {
    const ReadFile& file = step.files[i];
    insert
      .with(step.id, static_cast<std::int64_t>(i + 1), std::string_view(file.path),
        std::string_view(file.place), std::string_view(file.format), file.bytes,
        std::string_view(file.modified), std::string_view(file.hash))
      .run();
  }
}

std::int64_t ProjectFile::storeForm(const DataForm& form, std::string& hash, Execution& execution)
{
  const FormHashes hashes = hashesOf(form, execution);
  hash = hashes.form;
  Statement known = this->Data.prepare("SELECT id FROM result WHERE hash = ?");
  known.with(std::string_view(hash));
  if (known.next())
  {
    return known.integer(0);
  }
  this->Data.prepare("INSERT INTO result (hash, kind, facts) VALUES (?, ?, ?)")
    .with(std::string_view(hash), std::string_view(form.kind), std::string_view(jsonOf(form.facts)))
    .run();
  const std::int64_t result = this->Data.lastRow();
  Statement insert = this->Data.prepare("INSERT INTO result_array VALUES (?, ?, ?)");
  for (const auto& [role, array] : form.arrays)
  {
    const std::int64_t stored =
      this->storeArray(array, hashes.chunks.at(role), hashes.arrays.at(role), execution);
    insert.with(result, std::string_view(role), stored).run();
  }
  return result;
}

std::int64_t ProjectFile::storeArray(
  const ArrayForm& array, std::span<const Hash> chunks, const Hash& hash, Execution& execution)
{
  const ArrayShape& shape = array.shape;
  Statement known =
    this->Data.prepare("SELECT id FROM array WHERE hash = ? AND type = ? AND components = ?");
  known.with(bytesOf(hash), std::string_view(shape.type), std::int64_t{ shape.components });
  if (known.next())
  {
    return known.integer(0);
  }
  this->Data.prepare("INSERT INTO array (hash, type, components, tuples) VALUES (?, ?, ?, ?)")
    .with(
      bytesOf(hash), std::string_view(shape.type), std::int64_t{ shape.components }, shape.tuples)
    .run();
  const std::int64_t id = this->Data.lastRow();
  Statement findChunk = this->Data.prepare("SELECT id FROM chunk WHERE hash = ?");
  Statement addChunk = this->Data.prepare("INSERT INTO chunk (hash, size, code) VALUES (?, ?, ?)");
  Statement addPlace = this->Data.prepare("INSERT INTO array_chunk VALUES (?, ?, ?)");
  const std::size_t size = chunkSize(shape);
  const auto valuesOf = [&](std::size_t i)
  { return array.bytes.subspan(i * size, std::min(size, array.bytes.size() - i * size)); };
  for (std::size_t begin = 0; begin < chunks.size(); begin += kBatch)
  {
    const std::size_t count = std::min(kBatch, chunks.size() - begin);
    std::vector<std::int64_t> ids(count, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      findChunk.with(bytesOf(chunks[begin + i]));
      ids[i] = findChunk.next() ? findChunk.integer(0) : 0;
    }
    std::vector<std::vector<char>> codes(count);
    execution.parallelFor(count, 1,
      [&](std::size_t first, std::size_t end)
      {
        for (std::size_t i = first; i < end; ++i)
        {
          if (ids[i] == 0)
          {
            codes[i] = encodeValues(valuesOf(begin + i), layoutOf(shape));
          }
        }
      });
    for (std::size_t i = 0; i < count; ++i)
    {
      const Hash& chunk = chunks[begin + i];
      if (ids[i] == 0)
      {
        findChunk.with(bytesOf(chunk)); // a batch may hold the same chunk twice
        if (findChunk.next())
        {
          ids[i] = findChunk.integer(0);
        }
        else
        {
          addChunk
            .with(bytesOf(chunk), static_cast<std::int64_t>(valuesOf(begin + i).size()),
              std::span<const char>(codes[i]))
            .run();
          ids[i] = this->Data.lastRow();
        }
      }
      addPlace.with(id, static_cast<std::int64_t>(begin + i), ids[i]).run();
    }
    execution.step("store", begin + count, chunks.size() + 1);
  }
  return id;
}

void ProjectFile::removeSteps(std::span<const StepId> steps, StepId current)
{
  this->checkWritable();
  Transaction transaction(this->Data);
  this->setCurrent(current);
  Statement removeFiles = this->Data.prepare("DELETE FROM read_file WHERE step = ?");
  Statement remove = this->Data.prepare("DELETE FROM step WHERE id = ?");
  std::vector<StepId> childrenFirst(steps.begin(), steps.end());
  std::ranges::sort(childrenFirst, std::ranges::greater());
  for (const StepId step : childrenFirst)
  {
    removeFiles.with(step).run();
    remove.with(step).run();
  }
  this->Data.execute(R"(
DELETE FROM result_array WHERE result NOT IN (SELECT result FROM step WHERE result IS NOT NULL);
DELETE FROM result WHERE id NOT IN (SELECT result FROM step WHERE result IS NOT NULL);
DELETE FROM array_chunk WHERE array NOT IN (SELECT array FROM result_array);
DELETE FROM array WHERE id NOT IN (SELECT array FROM result_array);
DELETE FROM chunk WHERE id NOT IN (SELECT chunk FROM array_chunk);
)");
  transaction.commit();
  this->Data.execute("PRAGMA incremental_vacuum");
}

std::optional<std::int64_t> ProjectFile::resultOf(StepId step) const
{
  Statement row = this->Data.prepare("SELECT result FROM step WHERE id = ?");
  row.with(step);
  return row.next() && !row.isNull(0) ? std::optional(row.integer(0)) : std::nullopt;
}

bool ProjectFile::hasResult(StepId step) const
{
  return this->resultOf(step).has_value();
}

StoredForm ProjectFile::formOfResult(std::int64_t result) const
{
  StoredForm form;
  Statement head = this->Data.prepare("SELECT hash, kind, facts FROM result WHERE id = ?");
  head.with(result);
  if (!head.next())
  {
    refuseDamage(this->path(), "a result");
  }
  form.kind = head.text(1);
  form.facts = parseTexts(head.text(2));
  Statement arrays = this->Data.prepare(
    "SELECT role, type, components, tuples, hash, id FROM result_array JOIN array ON array = id "
    "WHERE result = ? ORDER BY role");
  arrays.with(result);
  while (arrays.next())
  {
    form.arrays[arrays.text(0)] = { { arrays.text(1), static_cast<int>(arrays.integer(2)),
                                      arrays.integer(3) },
      hashIn(arrays.bytes(4)), arrays.integer(5) };
  }
  if (hashOf(form) != head.text(0))
  {
    refuseDamage(this->path(), "a result");
  }
  return form;
}

void ProjectFile::readArray(
  const StoredForm::Array& array, std::span<char> values, Execution& execution) const
{
  struct Chunk
  {
    std::vector<char> code;
    Hash hash;
  };
  const std::size_t size = chunkSize(array.shape);
  Statement rows = this->Data.prepare(
    "SELECT hash, code FROM array_chunk JOIN chunk ON chunk = id WHERE array = ? ORDER BY number");
  rows.with(array.place);
  std::vector<Hash> hashes;
  std::atomic<bool> isWhole = true;
  for (std::size_t begin = 0; begin < values.size();)
  {
    std::vector<Chunk> batch;
    while (batch.size() < kBatch && begin + batch.size() * size < values.size() && rows.next())
    {
      const std::span<const char> code = rows.bytes(1);
      batch.push_back({ { code.begin(), code.end() }, hashIn(rows.bytes(0)) });
      hashes.push_back(batch.back().hash);
    }
    execution.parallelFor(batch.size(), 1,
      [&](std::size_t first, std::size_t end)
      {
        for (std::size_t i = first; i < end; ++i)
        {
          const std::size_t place = begin + i * size;
          const std::span<char> part = values.subspan(place, std::min(size, values.size() - place));
          try
          {
            decodeValues(batch[i].code, part);
          }
          catch (const std::exception&)
          {
            isWhole = false;
          }
          if (hashOf(std::span<const char>(part)) != batch[i].hash)
          {
            isWhole = false;
          }
        }
      });
    isWhole = isWhole && !batch.empty();
    if (!isWhole)
    {
      break;
    }
    begin += batch.size() * size;
    execution.step("read", std::min(begin, values.size()), values.size());
  }
  if (!isWhole || hashOf(std::span<const Hash>(hashes)) != array.hash)
  {
    refuseDamage(this->path(), "a result");
  }
}

StoredForm ProjectFile::formOf(StepId step) const
{
  const std::optional<std::int64_t> result = this->resultOf(step);
  if (!result)
  {
    throw Error(
      ErrorCode::badInput, this->path() + ": has no result of step " + std::to_string(step));
  }
  return this->formOfResult(*result);
}

vtkSmartPointer<vtkPolyData> ProjectFile::readResult(
  StepId step, LoadedComplexes& complexes, Execution& execution) const
{
  return modelOf(
    this->formOf(step),
    [&](const StoredForm::Array& array, std::span<char> values)
    { this->readArray(array, values, execution); },
    complexes, execution);
}

std::map<std::string, std::string> ProjectFile::texts(const std::string& kind) const
{
  std::map<std::string, std::string> texts;
  if (this->Schema < 2)
  {
    return texts; // an older project that can only be read
  }
  Statement rows = this->Data.prepare("SELECT name, text FROM kept_text WHERE kind = ?");
  rows.with(std::string_view(kind));
  while (rows.next())
  {
    texts[rows.text(0)] = rows.text(1);
  }
  return texts;
}

void ProjectFile::keepText(
  const std::string& kind, const std::string& name, const std::string& text)
{
  this->checkWritable();
  this->Data.prepare("INSERT OR REPLACE INTO kept_text VALUES (?, ?, ?)")
    .with(std::string_view(kind), std::string_view(name), std::string_view(text))
    .run();
}

std::vector<StepId> ProjectFile::findDamage(Execution& execution) const
{
  std::map<std::int64_t, bool> isWhole; // by array
  const auto isReadable = [&](const StoredForm::Array& array)
  {
    const auto known = isWhole.find(array.place);
    if (known != isWhole.end())
    {
      return known->second;
    }
    bool& whole = isWhole[array.place];
    try
    {
      std::vector<char> values(sizeOf(array.shape));
      this->readArray(array, values, execution);
      whole = true;
    }
    catch (const Error&)
    {
      whole = false;
    }
    return whole;
  };
  std::vector<StepId> damaged;
  Statement rows = this->Data.prepare("SELECT id, result FROM step WHERE result IS NOT NULL");
  while (rows.next())
  {
    try
    {
      const StoredForm form = this->formOfResult(rows.integer(1));
      if (std::ranges::all_of(
            form.arrays, isReadable, [](const auto& entry) { return entry.second; }))
      {
        continue;
      }
    }
    catch (const Error&)
    {
      // said below
    }
    damaged.push_back(rows.integer(0));
  }
  return damaged;
}

/// What can be read of a damaged project.
class Salvager
{
public:
  Salvager(const std::string& damaged, const std::string& path, Execution& execution)
    : Source(damaged, ProjectFile::Salvage{})
    , Path(path)
    , Run(execution)
  {
  }

  SalvageReport save()
  {
    this->Run.plan({ { "salvage", 1.0 } });
    const std::optional<StepId> last = this->lastStep();
    this->Report.isListWhole = last.has_value();
    StepId end = last.value_or(kMostMissing);
    for (StepId id = 1; id <= end; ++id)
    {
      this->Run.step("salvage", static_cast<std::size_t>(id), static_cast<std::size_t>(end) + 1);
      if (std::optional<Step> step = this->readStep(id))
      {
        this->saveStep(std::move(*step));
        end = last.value_or(id + kMostMissing);
      }
    }
    if (!this->Target)
    {
      throw Error(
        ErrorCode::parse, this->Source.path() + ": no step can be read, so nothing can be saved");
    }
    this->finish();
    return this->Report;
  }

private:
  /// The highest number that a step has had; none when that is lost.
  std::optional<StepId> lastStep()
  {
    for (const char* const sql :
      { "SELECT seq FROM sqlite_sequence WHERE name = 'step'", "SELECT max(id) FROM step" })
    {
      try
      {
        Statement row = this->Source.Data.prepare(sql);
        if (row.next() && !row.isNull(0))
        {
          return row.integer(0);
        }
      }
      catch (const Error&)
      {
        continue; // the other way
      }
    }
    return std::nullopt;
  }

  std::optional<Step> readStep(StepId id)
  {
    try
    {
      Statement row = this->Source.Data.prepare(
        std::string("SELECT ") + kStepColumns + " FROM step WHERE id = ?");
      row.with(id);
      if (!row.next())
      {
        return std::nullopt; // deleted by the user, or its page holds something else
      }
      std::optional<Step> step = stepIn(this->Source.Data, row);
      this->Report.lost += step ? 0 : 1;
      return step;
    }
    catch (const Error&)
    {
      this->Report.lost += this->Report.isListWhole ? 1 : 0;
      return std::nullopt;
    }
  }

  void saveStep(Step step)
  {
    if (!this->Target)
    {
      ProjectFile::create(this->Path);
      this->Target.emplace(this->Path);
    }
    vtkSmartPointer<vtkPolyData> result;
    try
    {
      result = this->Source.readResult(step.id, this->Complexes, this->Run);
    }
    catch (const Error&)
    {
      this->Report.withoutResult.push_back(step.id);
    }
    if (step.parent != 0 && !this->Saved.contains(step.parent))
    {
      addToNote(step.note, "step " + std::to_string(step.parent) + " before it was lost");
      step.parent = 0;
    }
    Transaction transaction(this->Target->Data);
    std::string hash;
    this->Target->insertStep(
      step, result ? this->Target->storeForm(scan::formOf(*result), hash, this->Run) : 0);
    transaction.commit();
    this->Saved.insert(step.id);
    ++this->Report.steps;
    this->Report.results += result ? 1 : 0;
  }

  void finish()
  {
    StepId current = 0;
    try
    {
      current = this->Source.current();
      for (const char* const kind : { "template", "view" })
      {
        for (const auto& [name, text] : this->Source.texts(kind))
        {
          this->Target->keepText(kind, name, text);
        }
      }
    }
    catch (const Error&)
    {
      this->Report.isListWhole = false;
    }
    this->Target->setCurrent(this->Saved.contains(current) ? current : *this->Saved.rbegin());
  }

  static constexpr StepId kMostMissing = 1000; // one after the other, where the end is not known

  ProjectFile Source;
  std::string Path;
  Execution& Run;
  std::optional<ProjectFile> Target;
  LoadedComplexes Complexes;
  std::set<StepId> Saved;
  SalvageReport Report;
};

ProjectFile::ProjectFile(const std::string& path, Salvage)
  : Guard(path)
  , ReadOnly("it is being salvaged")
  , Data(path, Database::Access::damaged)
  , Schema(kSchema)
{
}

SalvageReport ProjectFile::salvage(
  const std::string& damaged, const std::string& path, Execution& execution)
{
  return Salvager(damaged, path, execution).save();
}

std::string textOf(const SalvageReport& report)
{
  std::string text = "saved " + std::to_string(report.steps) + " steps, " +
    std::to_string(report.results) + " of them with their results\n";
  for (const StepId step : report.withoutResult)
  {
    text += "the result of step " + std::to_string(step) + " is lost\n";
  }
  if (report.lost > 0)
  {
    text += std::to_string(report.lost) + " more steps are lost\n";
  }
  if (!report.isListWhole)
  {
    text += "the list of steps is damaged: others may have been there\n";
  }
  return text;
}

} // namespace scan
