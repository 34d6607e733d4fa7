// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/import.h"
#include "pipeline/operation_table.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace scan
{

/// A verb with its options.
struct OperationWish
{
  const Operation* operation = nullptr;
  ParameterValues given;
};

/// -o FILE with the options of its format
struct OutputWish
{
  std::string path;
  ParameterValues given;
};

enum class ProgressMode
{
  automatic, ///< a bar when stderr is a terminal
  none,
  json
};

/// What the words on the command line ask for.
struct CommandLine
{
  enum class Action
  {
    run,
    help, ///< of the verb, or of the program
    formats,
    version
  };
  using Step = std::variant<OperationWish, OutputWish>;

  Action action = Action::run;
  const Operation* helpVerb = nullptr;
  std::vector<std::string> inputs;
  std::vector<Step> steps;

  unsigned threads = 0;       ///< 0: all cores
  std::int64_t maxMemory = 0; ///< bytes; 0: no limit
  bool quiet = false;
  bool verbose = false;
  bool dryRun = false;
  bool overwrite = false;
  ProgressMode progress = ProgressMode::automatic;
  std::string json;               ///< path of the record, "-" for standard output; empty: none
  std::string templateFile;       ///< operations to do first; empty: none
  std::vector<std::string> batch; ///< patterns of files, each to be done alone
  unsigned jobs = 1;              ///< files of a batch at a time
  bool resume = false;            ///< leave out files of a batch that are done
  ParameterValues reading;        ///< those of readParameters() that are given
  std::string encoding;           ///< for outputs that have it and do not give their own
};

/// The options that are not a verb's, for the parser and the help.
const std::vector<Parameter>& globalOptions();

/// @param words the command line without the program's name
/// @throws Error{badParameter} with a line for the user
CommandLine parseCommandLine(std::span<const std::string> words);

} // namespace scan
