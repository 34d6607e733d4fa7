// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/help.h"

#include "app/cli/command_line.h"
#include "pipeline/history_verb.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace scan
{

namespace
{

std::string usageOf(const Parameter& parameter)
{
  if (const bool* const isOn = std::get_if<bool>(&parameter.defaultValue))
  {
    return "--" + parameter.name + (*isOn ? "=false" : "");
  }
  return "--" + parameter.name + "=" +
    (parameter.choices.empty() ? std::string("VALUE") : rangeText(parameter));
}

/// The options of outputs, each once, with the formats that have it.
std::string outputOptions()
{
  struct Option
  {
    const Parameter* parameter = nullptr;
    std::string formats;
  };
  std::vector<Option> options;
  for (const Format& format : formats())
  {
    for (const Parameter& parameter : format.writeParameters)
    {
      const auto known = std::ranges::find_if(options,
        [&](const Option& option) {
          return option.parameter->name == parameter.name &&
            option.parameter->help == parameter.help;
        });
      if (known != options.end())
      {
        known->formats += ", " + format.extensions.front();
      }
      else
      {
        options.push_back({ &parameter, format.extensions.front() });
      }
    }
  }
  std::string text;
  for (const auto& [parameter, names] : options)
  {
    text += fmt::format("  {:<28} {}: {}\n", usageOf(*parameter), names, parameter->help);
  }
  return text;
}

std::string verbLine(const Operation& operation)
{
  return fmt::format("  {:<15} {:<10} {}\n", operation.verb,
    fmt::format("({})", nameOf(operation.stage)), operation.help);
}

} // namespace

std::string programHelp()
{
  std::string text =
    "scanwrap - turns 3D scan points into surfaces\n\n"
    "usage: scanwrap [options] FILE... [VERB [--option=value ...]]... [-o FILE]...\n"
    "       scanwrap VERB --help\n\n"
    "The files are opened, several as one model; the verbs work on it from left to\n"
    "right; -o writes what there is at that place, a picture if it ends in .png.\n"
    "-o PART.wrp makes a project that keeps every step; scanwrap PART.wrp goes on with it.\n"
    "- is standard input or output; behind -- files may have names that start with -.\n"
    "\noperations:\n";
  for (const Operation& operation : operationTable())
  {
    text += verbLine(operation);
  }
  text += verbLine(historyOperation());
  text += "\noptions:\n";
  for (const Parameter& parameter : globalOptions())
  {
    text += fmt::format("  {:<28} {}\n", usageOf(parameter), parameter.help);
  }
  text += "\noptions of outputs, behind -o FILE:\n" + outputOptions();
  text += fmt::format(
    "\nreads:  {}\nwrites: {}\n\nexamples:\n", readableExtensions(), writableExtensions());
  for (const Operation& operation : operationTable())
  {
    text += "  " + operation.example + "\n";
  }
  text += "  " + historyOperation().example + "\n";
  text += "  scanwrap --batch='scans/*.xyz' --template=part.txt -o 'parts/{name}.stl'\n";
  text += "\nexit status: 0 done, 1 an operation failed, 2 wrong usage or unreadable input,\n"
          "  3 a check failed, 4 cancelled, 5 over the memory limit\n";
  return text;
}

std::string operationHelp(const Operation& operation)
{
  const bool isOfProjects = operation.stage == Stage::history;
  std::string text = fmt::format("scanwrap {} {} [--option=value ...]\n\n{}.\n",
    isOfProjects ? "PROJECT.wrp" : "FILE...", operation.verb, operation.help);
  if (!operation.parameters.empty())
  {
    text += "\noptions:\n";
  }
  for (const Parameter& parameter : operation.parameters)
  {
    const std::string defaultText = textOf(parameter.defaultValue);
    text += fmt::format("  --{}={}\n      {}{}\n", parameter.name, rangeText(parameter),
      parameter.help, defaultText.empty() ? "" : "; default " + defaultText);
  }
  return text + "\nexample:\n  " + operation.example + "\n";
}

} // namespace scan
