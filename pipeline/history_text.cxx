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

bool isDefault(
  const std::vector<Parameter>* parameters, const std::string& name, const std::string& value)
{
  return parameters != nullptr &&
    std::ranges::any_of(*parameters,
      [&](const Parameter& parameter)
      { return parameter.name == name && textOf(parameter.defaultValue) == value; });
}

/// A line of the list before its columns are made even.
struct Line
{
  StepId id = 0;
  std::string tree;      ///< indentation and command
  std::size_t width = 0; ///< of these in characters, of which some have three bytes
};

/// The steps as a tree: a step's only child continues its line, several are branches below it.
class HistoryTree
{
public:
  explicit HistoryTree(const Document& document)
    : Steps(document)
  {
    for (const Step& step : document.steps())
    {
      this->Children[step.parent].push_back(step.id);
    }
  }

  std::vector<Line> lines()
  {
    std::vector<Line> lines;
    this->open(0, "");
    while (!this->Open.empty())
    {
      const Place place = this->Open.back();
      this->Open.pop_back();
      lines.push_back(this->lineOf(place));
      this->open(place.id, place.below);
    }
    return lines;
  }

private:
  struct Place
  {
    StepId id = 0;
    std::string before; ///< its line
    std::string below;  ///< before the lines of its branch
  };

  /// Adds the children of a step, the first one on top.
  void open(StepId parent, const std::string& indent)
  {
    const std::vector<StepId>& steps = this->Children[parent];
    const bool isBranching = steps.size() > 1 && parent != 0;
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    {
      const bool isLast = step == steps.rbegin();
      this->Open.push_back({ *step,
        indent +
          (!isBranching ? ""
              : isLast  ? "└ "
                        : "├ "),
        indent +
          (!isBranching ? ""
              : isLast  ? "  "
                        : "│ ") });
    }
  }

  Line lineOf(const Place& place) const
  {
    constexpr std::size_t kWidest = 60;
    std::string command = commandOf(this->Steps.step(place.id));
    if (command.size() > kWidest)
    {
      command = command.substr(0, kWidest - 3) + "...";
    }
    Line line{ place.id, place.before + command };
    line.width = static_cast<std::size_t>(std::ranges::count_if(
      line.tree, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
    return line;
  }

  const Document& Steps;
  std::map<StepId, std::vector<StepId>> Children;
  std::vector<Place> Open;
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
      std::string paths = value;
      std::ranges::replace(paths, '\n', ' ');
      text.append(" ").append(paths);
      continue;
    }
    if (!isDefault(parameters, name, value))
    {
      text.append(" --").append(name);
      text.append(value == "true" ? "" : "=").append(value == "true" ? "" : value);
    }
  }
  return text;
}

std::string historyText(const Document& document)
{
  const std::vector<Line> lines = HistoryTree(document).lines();
  std::size_t widest = 0;
  for (const Line& line : lines)
  {
    widest = std::max(widest, line.width);
  }
  const std::size_t digits = std::to_string(lines.empty() ? 0 : document.steps().back().id).size();
  std::string text;
  for (const Line& line : lines)
  {
    const Step& step = document.step(line.id);
    text += fmt::format("{} {:>{}}  {}{:{}}  {:>18}  {:>8.2f} s{}\n",
      step.id == document.current() ? '*' : ' ', step.id, digits, line.tree, "",
      widest - line.width, sizeText(step), step.seconds,
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
