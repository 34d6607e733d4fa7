// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch.h"

#include "app/cli/child_process.h"
#include "app/cli/exit_status.h"
#include "app/cli/process.h"
#include "filters/base/error.h"
#include "pipeline/output_files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glob.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <thread>

namespace scan
{

namespace
{

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

enum class Outcome
{
  waiting,
  done,
  before, ///< its outputs were there
  failed,
  cancelled
};

std::string_view nameOf(Outcome outcome)
{
  switch (outcome)
  {
    case Outcome::waiting:
      return "not started";
    case Outcome::done:
      return "ok";
    case Outcome::before:
      return "done before";
    case Outcome::failed:
      return "failed";
    case Outcome::cancelled:
      return "cancelled";
  }
  return {};
}

/// A file and what became of it.
struct Item
{
  std::string file;
  std::vector<std::string> outputs;
  std::vector<std::string> words; ///< of its command line
  Outcome outcome = Outcome::waiting;
  double seconds = 0.0;
  std::string what; ///< came out, or went wrong; one line
  Json record;
  std::unique_ptr<ChildProcess> process;
  Clock::time_point start;
};

std::vector<std::string> filesLike(const std::vector<std::string>& patterns)
{
  std::vector<std::string> files;
  for (const std::string& pattern : patterns)
  {
    ::glob_t found = {};
    const int status = // NOLINTNEXTLINE(concurrency-mt-unsafe): alone
      ::glob(pattern.c_str(), GLOB_TILDE | GLOB_BRACE, nullptr, &found);
    for (std::size_t i = 0; status == 0 && i < found.gl_pathc; ++i)
    {
      files.emplace_back(found.gl_pathv[i]);
    }
    ::globfree(&found);
    if (status != 0)
    {
      throw Failure(ExitStatus::usage, "--batch=" + pattern + ": there is no such file");
    }
  }
  std::erase_if(files, [](const std::string& file) { return fs::is_directory(file); });
  std::ranges::sort(files);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t place = 0; (place = text.find(what, place)) != std::string::npos;)
  {
    text.replace(place, what.size(), by);
    place += by.size();
  }
  return text;
}

std::string outputFor(const std::string& pattern, const std::string& file, std::size_t number)
{
  return replaced(
    replaced(pattern, "{name}", fs::path(file).stem().string()), "{n}", std::to_string(number));
}

bool isBatchOption(const std::string& word)
{
  return std::ranges::any_of(std::array{ "--batch", "--jobs", "--resume", "--json" },
    [&](const std::string& name) { return word == name || word.starts_with(name + "="); });
}

/// The last line that the program said.
std::string lastLine(std::string_view errors)
{
  while (errors.ends_with('\n'))
  {
    errors.remove_suffix(1);
  }
  std::string line(errors.substr(errors.rfind('\n') + 1));
  constexpr std::string_view kPrefix = "scanwrap: ";
  return line.starts_with(kPrefix) ? line.substr(kPrefix.size()) : line;
}

/// "9908 triangles": of the last step that made a model.
std::string sizeIn(const Json& record)
{
  std::string size;
  for (const Json& step : record.value("steps", Json::array()))
  {
    const Json results = step.value("results", Json::object());
    const auto number = [&](const char* name)
    {
      const auto found = results.find(name);
      return found != results.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
    };
    if (results.contains("output-points"))
    {
      size = number("output-triangles") > 0
        ? std::to_string(number("output-triangles")) + " triangles"
        : std::to_string(number("output-points")) + " points";
    }
  }
  return size;
}

class Batch
{
public:
  Batch(const CommandLine& line, std::span<const std::string> words, const CancelToken& token)
    : Line(line)
    , Token(token)
  {
    const std::vector<std::string> files = filesLike(line.batch);
    for (std::size_t i = 0; i < files.size(); ++i)
    {
      this->Items.push_back(this->itemFor(files[i], i + 1, words));
    }
    this->refuseSharedOutputs();
    if (!line.json.empty())
    {
      checkOutput(line.json, line.overwrite);
    }
  }

  void run()
  {
    std::size_t next = 0;
    std::size_t running = 0;
    while (next < this->Items.size() || running > 0)
    {
      while (next < this->Items.size() && running < this->Line.jobs && !this->Token.cancelled())
      {
        running += this->start(this->Items[next]) ? 1 : 0;
        ++next;
      }
      for (Item& item : this->Items)
      {
        constexpr int kPatience = 20; // milliseconds
        if (item.process && !item.process->wait(kPatience))
        {
          this->finish(item);
          --running;
        }
      }
      if (this->Token.cancelled())
      {
        forgetCancel(); // this loop ends soon by itself, and tells what was done
        std::ranges::for_each(this->Items,
          [](const Item& item)
          {
            if (item.process)
            {
              item.process->cancel();
            }
          });
        next = this->Items.size();
      }
    }
  }

  /// The table, and a line that sums it up.
  std::string table() const
  {
    std::size_t width = 4;
    for (const Item& item : this->Items)
    {
      width = std::max(width, item.file.size());
    }
    std::string text = fmt::format("{:<{}}  {:<11}  {:>8}\n", "file", width, "result", "seconds");
    std::map<Outcome, int> counts;
    for (const Item& item : this->Items)
    {
      text += fmt::format("{:<{}}  {:<11}  {:>8.2f}  {}\n", item.file, width, nameOf(item.outcome),
        item.seconds, item.what);
      ++counts[item.outcome];
    }
    text += fmt::format("{} files", this->Items.size());
    for (const auto& [outcome, count] : counts)
    {
      text += fmt::format(
        "{} {} {}", &outcome == &counts.begin()->first ? ":" : ",", count, nameOf(outcome));
    }
    return text + "\n";
  }

  ExitStatus status() const
  {
    const auto has = [&](Outcome outcome)
    { return std::ranges::find(this->Items, outcome, &Item::outcome) != this->Items.end(); };
    return has(Outcome::cancelled) || has(Outcome::waiting) ? ExitStatus::cancelled
      : has(Outcome::failed)                                ? ExitStatus::failed
                                                            : ExitStatus::done;
  }

  void writeRecord() const
  {
    if (this->Line.json.empty())
    {
      return;
    }
    Json record;
    record["program"] = "scanwrap";
    record["version"] = SCAN_VERSION;
    record["status"] = static_cast<int>(this->status());
    record["batch"] = Json::array();
    for (const Item& item : this->Items)
    {
      record["batch"].push_back(
        { { "file", item.file }, { "result", nameOf(item.outcome) }, { "seconds", item.seconds },
          { "what", item.what }, { "outputs", item.outputs }, { "record", item.record } });
    }
    writeText(this->Line.json, record.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  }

private:
  Item itemFor(
    const std::string& file, std::size_t number, std::span<const std::string> words) const
  {
    Item item;
    item.file = file;
    // in front of all verbs; behind it, names may not start with a dash
    item.words.push_back(file.starts_with('-') ? "./" + file : file);
    bool isOutput = false;
    bool hasThreads = false;
    for (const std::string& word : words)
    {
      if (isOutput)
      {
        item.outputs.push_back(outputFor(word, file, number));
        item.words.push_back(item.outputs.back());
      }
      else if (!isBatchOption(word))
      {
        item.words.push_back(word);
      }
      hasThreads = hasThreads || word.starts_with("--threads");
      isOutput = word == "-o" && !isOutput;
    }
    if (!hasThreads && this->Line.jobs > 1)
    {
      const unsigned share = std::thread::hardware_concurrency() / this->Line.jobs;
      item.words.push_back("--threads=" + std::to_string(std::max(share, 1U)));
    }
    if (this->Line.resume && !this->Line.overwrite)
    {
      item.words.emplace_back("--overwrite"); // what is too old, or not all there
    }
    return item;
  }

  void refuseSharedOutputs() const
  {
    std::map<std::string, std::string> owners;
    for (const Item& item : this->Items)
    {
      for (const std::string& output : item.outputs)
      {
        const auto [owner, isNew] = owners.emplace(output, item.file);
        if (!isNew || output == "-")
        {
          throw Failure(ExitStatus::usage,
            output +
              ": would be the output of more than one file; put {name} into its name, as in "
              "-o 'out/{name}.stl'");
        }
      }
    }
  }

  /// Whether all outputs are there and newer than what they are made from.
  bool isDone(const Item& item) const
  {
    std::error_code error;
    fs::file_time_type newest = fs::last_write_time(item.file, error);
    if (!this->Line.templateFile.empty())
    {
      newest = std::max(newest, fs::last_write_time(this->Line.templateFile, error));
    }
    return !item.outputs.empty() &&
      std::ranges::all_of(item.outputs,
        [&](const std::string& output)
        {
          std::error_code missing;
          const fs::file_time_type time = fs::last_write_time(output, missing);
          return !missing && time >= newest;
        });
  }

  /// False when there is nothing to do.
  bool start(Item& item)
  {
    item.start = Clock::now();
    if (this->Line.resume && this->isDone(item))
    {
      item.outcome = Outcome::before;
      return false;
    }
    item.process = std::make_unique<ChildProcess>(item.words);
    return true;
  }

  void finish(Item& item)
  {
    const ChildProcess& process = *item.process;
    item.seconds = std::chrono::duration<double>(Clock::now() - item.start).count();
    item.record = Json::parse(process.record(), nullptr, false);
    if (!item.record.is_object())
    {
      item.record = nullptr;
    }
    const int status = process.status();
    item.outcome = status == static_cast<int>(ExitStatus::done) ? Outcome::done
      : status == static_cast<int>(ExitStatus::cancelled)       ? Outcome::cancelled
                                                                : Outcome::failed;
    item.what = item.outcome == Outcome::done ? (item.record.is_null() ? "" : sizeIn(item.record))
      : status > ChildProcess::kSignalled
      ? "the program ended by signal " + std::to_string(status - ChildProcess::kSignalled)
      : lastLine(process.errors());
    if (!this->Line.quiet)
    {
      writeText("-", process.output().empty() ? "" : item.file + "\n" + process.output() + "\n");
      say(this->Line.progress == ProgressMode::none
          ? ""
          : fmt::format("scanwrap: {}: {}\n", item.file, nameOf(item.outcome)));
    }
    item.process.reset();
  }

  const CommandLine& Line;
  const CancelToken& Token;
  std::vector<Item> Items;
};

} // namespace

void runBatch(const CommandLine& line, std::span<const std::string> words, const CancelToken& token)
{
  Batch batch(line, words, token);
  batch.run();
  writeText("-", batch.table());
  batch.writeRecord();
  switch (batch.status())
  {
    case ExitStatus::done:
      return;
    case ExitStatus::cancelled:
      throw Failure(
        ExitStatus::cancelled, "cancelled; run it again with --resume to do what is missing");
    default:
      throw Failure(ExitStatus::failed, "some files failed, see the table");
  }
}

} // namespace scan
