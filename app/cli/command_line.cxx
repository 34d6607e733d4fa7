// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include "app/cli/suggestion.h"
#include "filters/base/error.h"
#include "pipeline/history_verb.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace scan
{

namespace
{

[[noreturn]] void refuse(const std::string& message)
{
  throw Error(ErrorCode::badParameter, message);
}

/// "512M", "4G": a number and a power of 1024.
std::int64_t parseBytes(const std::string& text)
{
  constexpr std::string_view kUnits = "KMGT";
  double number = 0.0;
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, number);
  const std::size_t power = end == last ? 0 : kUnits.find(*end) + 1;
  if (status != std::errc() || last - end > 1 || (end != last && power == 0) ||
    !(number >= 0.0 && number <= 1e6))
  {
    refuse("--max-memory=" + text + ": expected a size such as 512M or 4G");
  }
  for (std::size_t i = 0; i < power; ++i)
  {
    number *= 1024.0;
  }
  return static_cast<std::int64_t>(number);
}

std::vector<std::string> namesOf(const std::vector<Parameter>& parameters)
{
  std::vector<std::string> names(parameters.size());
  std::ranges::transform(parameters, names.begin(), &Parameter::name);
  return names;
}

std::vector<std::string> verbs()
{
  std::vector<std::string> names = { historyOperation().verb };
  std::ranges::transform(operationTable(), std::back_inserter(names), &Operation::verb);
  return names;
}

/// The operation or history verb of that name, or null.
const Operation* findVerb(const std::string& word)
{
  return word == historyOperation().verb ? &historyOperation() : findOperation(word);
}

const Parameter* findParameter(const std::vector<Parameter>& parameters, std::string_view name)
{
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  return found != parameters.end() ? &*found : nullptr;
}

/// Empty for a name that no format has, which is refused later.
const std::vector<Parameter>& writeParametersOf(const std::string& path)
{
  static const std::vector<Parameter> kNone;
  const Format* const format = findFormatToWrite(path);
  return format != nullptr ? format->writeParameters : kNone;
}

class Parser
{
public:
  explicit Parser(std::span<const std::string> words)
    : Words(words)
  {
  }

  CommandLine parse()
  {
    while (!this->Words.empty())
    {
      this->word(this->next());
    }
    this->finish();
    return std::move(this->Line);
  }

private:
  std::string next()
  {
    std::string word = this->Words.front();
    this->Words = this->Words.subspan(1);
    return word;
  }

  void word(const std::string& word)
  {
    const bool isName = this->AreDashesNames && word.starts_with('-');
    if (!isName && word == "--")
    {
      this->AreDashesNames = true;
    }
    else if (!isName && word == "-o")
    {
      if (this->Words.empty())
      {
        refuse("-o: expected the name of a file after it");
      }
      this->Line.steps.emplace_back(OutputWish{ this->next(), {} });
    }
    else if (!isName && word == "-h")
    {
      this->option("help");
    }
    else if (!isName && word.starts_with("--"))
    {
      this->option(word.substr(2));
    }
    else if (!isName && word.size() > 1 && word.front() == '-')
    {
      refuse(word + ": there is no such option; see scanwrap --help");
    }
    else if (const Operation* operation = findVerb(word))
    {
      this->Line.steps.emplace_back(OperationWish{ operation, {} });
      this->VerbIndex = this->Line.steps.size() - 1;
      this->AreDashesNames = false;
    }
    else
    {
      this->input(word);
    }
  }

  void input(const std::string& word)
  {
    std::error_code unknown; // the reader says best what is wrong with a name
    const bool isFile = word == "-" || std::filesystem::exists(word, unknown) || unknown;
    const std::string similar = isFile ? "" : suggestion(word, verbs());
    if (this->currentVerb() != nullptr)
    {
      refuse("'" + word + "' is no operation" +
        (similar.empty() ? "; files stand before the first operation, see scanwrap --help"
                         : similar));
    }
    if (!similar.empty())
    {
      refuse("'" + word + "' is neither a file nor an operation" + similar);
    }
    this->Line.inputs.push_back(word);
  }

  /// The verb that options belong to, or null before the first one.
  OperationWish* currentVerb()
  {
    return this->VerbIndex ? &std::get<OperationWish>(this->Line.steps[*this->VerbIndex]) : nullptr;
  }

  /// The output that options right behind it belong to, or null.
  OutputWish* currentOutput()
  {
    return this->Line.steps.empty() ? nullptr : std::get_if<OutputWish>(&this->Line.steps.back());
  }

  /// name=value, or the bare name of a switch
  void option(const std::string& text)
  {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    OperationWish* const verb = this->currentVerb();
    OutputWish* const output = this->currentOutput();
    const Parameter* parameter =
      output != nullptr ? findParameter(writeParametersOf(output->path), name) : nullptr;
    ParameterValues* given = parameter != nullptr ? &output->given : nullptr;
    if (parameter == nullptr && verb != nullptr)
    {
      parameter = findParameter(verb->operation->parameters, name);
      given = &verb->given;
    }
    const bool isGlobal = parameter == nullptr;
    if (isGlobal)
    {
      parameter = findParameter(globalOptions(), name);
      given = &this->Globals;
    }
    if (parameter == nullptr)
    {
      refuseOption(name, verb, output);
    }
    const bool isSwitch = std::holds_alternative<bool>(parameter->defaultValue);
    if (equals == std::string::npos && !isSwitch)
    {
      refuse("--" + name + ": expected --" + name + "=VALUE, " + rangeText(*parameter));
    }
    const std::string value = equals == std::string::npos ? "true" : text.substr(equals + 1);
    const ParameterValue parsed = parseValue(*parameter, value);
    const auto [place, isNew] = given->emplace(name, parsed);
    if (!isNew && !appendValue(place->second, parsed))
    {
      refuse("--" + name + ": is given twice; keep one of them");
    }
    if (isGlobal && name == "help" && verb != nullptr)
    {
      this->Line.helpVerb = verb->operation;
    }
  }

  [[noreturn]] static void refuseOption(
    const std::string& name, const OperationWish* verb, const OutputWish* output)
  {
    std::vector<std::string> names = namesOf(globalOptions());
    std::string help = "scanwrap --help";
    std::string where;
    if (verb != nullptr)
    {
      const std::vector<std::string> own = namesOf(verb->operation->parameters);
      names.insert(names.begin(), own.begin(), own.end());
      help = "scanwrap " + verb->operation->verb + " --help";
      where = verb->operation->verb + ": ";
    }
    const bool isOfOutputs = std::ranges::any_of(formats(),
      [&](const Format& format)
      {
        const std::vector<std::string> own = namesOf(format.writeParameters);
        return std::ranges::find(own, name) != own.end();
      });
    if (isOfOutputs && output != nullptr)
    {
      refuse(output->path + ": " + formatToWrite(output->path).name + " has no option --" + name);
    }
    if (isOfOutputs)
    {
      refuse("--" + name + " is an option of outputs; put it right behind an -o FILE");
    }
    for (std::string& candidate : names)
    {
      candidate.insert(0, "--");
    }
    const std::string similar = suggestion("--" + name, names);
    refuse(where + "there is no option --" + name + (similar.empty() ? "; see " + help : similar));
  }

  template <class T>
  T global(std::string_view name) const
  {
    const auto given = this->Globals.find(name);
    return std::get<T>(given != this->Globals.end()
        ? given->second
        : findParameter(globalOptions(), name)->defaultValue);
  }

  void finish()
  {
    CommandLine& line = this->Line;
    const auto progress = this->global<std::string>("progress");
    line.threads = static_cast<unsigned>(this->global<std::int64_t>("threads"));
    line.maxMemory = parseBytes(this->global<std::string>("max-memory"));
    line.quiet = this->global<bool>("quiet");
    line.verbose = this->global<bool>("verbose");
    line.dryRun = this->global<bool>("dry-run");
    line.overwrite = this->global<bool>("overwrite");
    line.json = this->global<std::string>("json");
    if (line.json.empty() && this->Globals.contains("json"))
    {
      refuse("--json=: expected the name of a file, or - for standard output");
    }
    line.progress = progress == "json" ? ProgressMode::json
      : progress == "none"             ? ProgressMode::none
                                       : ProgressMode::automatic;
    for (const Parameter& parameter : readParameters())
    {
      if (const auto given = this->Globals.find(parameter.name); given != this->Globals.end())
      {
        line.reading.insert(*given);
      }
    }
    line.encoding = this->global<std::string>("encoding");
    line.templateFile = this->global<std::string>("template");
    line.batch = this->global<TextList>("batch");
    line.jobs = static_cast<unsigned>(this->global<std::int64_t>("jobs"));
    line.resume = this->global<bool>("resume");
    if (this->global<bool>("help"))
    {
      line.action = CommandLine::Action::help;
    }
    else if (this->global<bool>("formats"))
    {
      line.action = CommandLine::Action::formats;
    }
    else if (this->global<bool>("version"))
    {
      line.action = CommandLine::Action::version;
    }
    else if (!line.batch.empty() && !line.inputs.empty())
    {
      refuse("--batch finds the files; leave out " + line.inputs.front());
    }
    else if (line.batch.empty() && (line.resume || this->Globals.contains("jobs")))
    {
      refuse("--jobs and --resume are for batches; add --batch='scans/*.xyz'");
    }
    else if (line.batch.empty() && line.inputs.empty())
    {
      refuse("no input; name the files to open, or - for standard input, see scanwrap --help");
    }
  }

  std::span<const std::string> Words;
  CommandLine Line;
  ParameterValues Globals;
  std::optional<std::size_t> VerbIndex;
  bool AreDashesNames = false; // behind --, up to the first verb
};

} // namespace

const std::vector<Parameter>& globalOptions()
{
  static const std::vector<Parameter> kOptions = []
  {
    std::vector<Parameter> options = readParameters();
    const std::vector<Parameter> others{
      { .name = "encoding",
        .defaultValue = "binary",
        .help = "of PLY and STL outputs",
        .choices = { "binary", "ascii" } },
      { .name = "template",
        .defaultValue = "",
        .help = "do the operations of this template first; history --save-template makes one" },
      { .name = "batch",
        .defaultValue = TextList(),
        .help = "do all this for every file like 'scans/*.xyz'; {name} in outputs is its name" },
      { .name = "jobs",
        .defaultValue = std::int64_t{ 1 },
        .help = "files of a batch at a time",
        .minimum = 1,
        .maximum = 1024 },
      { .name = "resume",
        .defaultValue = false,
        .help = "leave out files of a batch whose outputs are there and not too old" },
      { .name = "overwrite", .defaultValue = false, .help = "replace outputs that exist" },
      { .name = "json",
        .defaultValue = "",
        .help =
          "write a record of every step to this file, or to standard output (-); peak-bytes is the "
          "program's peak memory so far" },
      { .name = "progress",
        .defaultValue = "auto",
        .help = "on stderr: a bar on a terminal, nothing, or a JSON object a line",
        .choices = { "auto", "none", "json" } },
      { .name = "threads",
        .defaultValue = std::int64_t{ 0 },
        .help = "number of threads; 0 for all cores",
        .minimum = 0,
        .maximum = 1024 },
      { .name = "max-memory",
        .defaultValue = "0",
        .help = "give up (status 5) rather than use more memory, e.g. 4G; 0 for no limit" },
      { .name = "dry-run", .defaultValue = false, .help = "check everything, then only say what" },
      { .name = "quiet", .defaultValue = false, .help = "no progress and no tables" },
      { .name = "verbose", .defaultValue = false, .help = "a line on stderr for every step" },
      { .name = "help", .defaultValue = false, .help = "this help, or that of the verb before it" },
      { .name = "formats", .defaultValue = false, .help = "a table of the formats of files" },
      { .name = "version", .defaultValue = false, .help = "the version" },
    };
    options.insert(options.end(), others.begin(), others.end());
    return options;
  }();
  return kOptions;
}

CommandLine parseCommandLine(std::span<const std::string> words)
{
  return Parser(words).parse();
}

} // namespace scan
