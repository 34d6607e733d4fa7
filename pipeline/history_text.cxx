// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/history_text.h"

#include "pipeline/result_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <variant>
#include <vector>

namespace scan
{

namespace
{

/// "9,238 triangles", or points where there are no triangles.
std::string sizeText(const Step& step)
{
  const auto numberOf = [&](const char* name)
  {
    const auto found = std::ranges::find(step.results, name, &Results::value_type::first);
    const auto* const number =
      found != step.results.end() ? std::get_if<std::int64_t>(&found->second) : nullptr;
    return number != nullptr ? *number : 0;
  };
  const std::int64_t triangles = numberOf("output-triangles");
  std::string digits = std::to_string(triangles > 0 ? triangles : numberOf("output-points"));
  for (std::size_t place = digits.size(); place > 3; place -= 3)
  {
    digits.insert(place - 3, 1, ',');
  }
  return digits + (triangles > 0 ? " triangles" : " points");
}

/// A line of the list before its columns are made even.
struct Line
{
  StepId id;
  std::string tree; ///< indentation and command
};

} // namespace

std::string commandOf(const Step& step)
{
  std::string text = step.verb;
  const std::vector<Parameter>* const parameters = parametersOf(step.verb);
  for (const auto& [name, value] : step.parameters)
  {
    if (name == "files")
    {
      for (const ReadFile& file : step.files)
      {
        text += " " + file.path;
      }
      continue;
    }
    const auto isDefault = [&](const Parameter& parameter)
    { return parameter.name == name && textOf(parameter.defaultValue) == value; };
    if (parameters == nullptr || std::ranges::none_of(*parameters, isDefault))
    {
      text += " --" + name + (value == "true" ? "" : "=" + value);
    }
  }
  return text;
}

std::string historyText(const Document& document)
{
  std::map<StepId, std::vector<StepId>> children;
  for (const Step& step : document.steps())
  {
    children[step.parent].push_back(step.id);
  }
  // a step's only child continues its line, several are branches below it
  struct Place
  {
    StepId id;
    std::string before; ///< of the line
    std::string below;  ///< of the lines of its branch
  };
  std::vector<Place> open;
  const auto push = [&](StepId parent, const std::string& indent)
  {
    const std::vector<StepId>& steps = children[parent];
    const bool isBranching = steps.size() > 1 && parent != 0;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    {
      const bool isLast = step == steps.rbegin();
      open.push_back({ *step, indent + (isBranching ? (isLast ? "└ " : "├ ") : ""),
        indent + (isBranching ? (isLast ? "  " : "│ ") : "") });
    }
  };
  constexpr std::size_t kWidest = 60;
  std::vector<Line> lines;
  std::vector<std::size_t> widths; // in characters, of which the tree has some of three bytes
  push(0, "");
  while (!open.empty())
  {
    const Place place = open.back();
    open.pop_back();
    std::string command = commandOf(document.step(place.id));
    if (command.size() > kWidest)
    {
      command = command.substr(0, kWidest - 3) + "...";
    }
    lines.push_back({ place.id, place.before + command });
    widths.push_back(static_cast<std::size_t>(std::ranges::count_if(
      lines.back().tree, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; })));
    push(place.id, place.below);
  }
  const std::size_t widest = widths.empty() ? 0 : *std::ranges::max_element(widths);
  const std::size_t digits = std::to_string(lines.empty() ? 0 : document.steps().back().id).size();
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const Step& step = document.step(lines[i].id);
    text += fmt::format("{} {:>{}}  {}{:{}}  {:>18}  {:>8.2f} s{}\n",
      step.id == document.current() ? '*' : ' ', step.id, digits, lines[i].tree, "",
      widest - widths[i], sizeText(step), step.seconds,
      step.name.empty() ? "" : "  '" + step.name + "'");
  }
  return text;
}

std::string stepText(const Step& step)
{
  Results lines{ { "step", step.id }, { "parent", step.parent }, { "verb", step.verb } };
  const auto addText = [&](const std::string& name, const std::string& text)
  {
    if (!text.empty())
    {
      lines.emplace_back(name, text);
    }
  };
  for (const auto& [name, value] : step.parameters)
  {
    if (name != "files")
    {
      lines.emplace_back("--" + name, value);
    }
  }
  for (const ReadFile& file : step.files)
  {
    lines.emplace_back("file", file.path);
    addText("  place", file.place);
    addText("  format", file.format);
    lines.emplace_back("  bytes", file.bytes);
    addText("  modified", file.modified);
    addText("  hash", file.hash);
  }
  addText("name", step.name);
  addText("input-hash", step.inputHash);
  addText("result-hash", step.resultHash);
  lines.emplace_back("seconds", step.seconds);
  lines.emplace_back("peak-bytes", step.peakBytes);
  lines.insert(lines.end(), step.results.begin(), step.results.end());
  addText("note", step.note);
  addText("program", step.program);
  addText("finished", step.finished);
  return tableOf(lines);
}

} // namespace scan
