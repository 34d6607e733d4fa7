// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/recipe.h"

#include "filters/base/error.h"
#include "readers/mapped_file.h"

#include <algorithm>

namespace scan
{

namespace
{

constexpr std::string_view kTitle = "scanwrap template 1";
constexpr std::string_view kAnyTitle = "scanwrap template ";

std::string_view trimmed(std::string_view text)
{
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t begin = text.find_first_not_of(kBlank);
  return begin == std::string_view::npos
    ? std::string_view()
    : text.substr(begin, text.find_last_not_of(kBlank) + 1 - begin);
}

class RecipeParser
{
public:
  explicit RecipeParser(std::string name)
    : Name(std::move(name))
  {
  }

  void line(std::string_view text)
  {
    ++this->Number;
    const std::string_view words = trimmed(text);
    if (words.empty() || words.front() == '#')
    {
      return;
    }
    if (!this->HasTitle)
    {
      this->title(words);
    }
    else if (text.front() == ' ' || text.front() == '\t')
    {
      this->parameter(words);
    }
    else
    {
      this->verb(words);
    }
  }

  Recipe recipe()
  {
    if (!this->HasTitle)
    {
      this->refuse("the file is empty; a template starts with '" + std::string(kTitle) + "'");
    }
    return std::move(this->Steps);
  }

private:
  [[noreturn]] void refuse(const std::string& what) const
  {
    throw Error(
      ErrorCode::parse, this->Name + ": line " + std::to_string(this->Number) + ": " + what);
  }

  void title(std::string_view words)
  {
    if (words != kTitle)
    {
      this->refuse(words.starts_with(kAnyTitle)
          ? "the template is of a newer Scanwrap; update the program"
          : "is no template; the first line must be '" + std::string(kTitle) + "'");
    }
    this->HasTitle = true;
  }

  void verb(std::string_view word)
  {
    const Operation* const operation = findOperation(word);
    if (operation == nullptr)
    {
      this->refuse("there is no operation '" + std::string(word) + "'; scanwrap --help lists them");
    }
    this->Steps.push_back({ operation, {} });
  }

  void parameter(std::string_view words)
  {
    const std::size_t equals = words.find('=');
    if (this->Steps.empty() || equals == std::string_view::npos)
    {
      this->refuse(this->Steps.empty() ? "expected the verb of an operation, not indented"
                                       : "expected 'name = value'");
    }
    RecipeStep& step = this->Steps.back();
    const std::string name(trimmed(words.substr(0, equals)));
    const auto& parameters = step.operation->parameters;
    const auto parameter = std::ranges::find(parameters, name, &Parameter::name);
    if (parameter == parameters.end())
    {
      this->refuse(step.operation->verb + " has no option " + name + "; see scanwrap " +
        step.operation->verb + " --help");
    }
    ParameterValue value;
    try
    {
      value = parseValue(*parameter, trimmed(words.substr(equals + 1)));
    }
    catch (const Error& error)
    {
      this->refuse(error.what());
    }
    const auto [place, isNew] = step.given.emplace(name, value);
    if (!isNew && !appendValue(place->second, value))
    {
      this->refuse(name + " is given twice; keep one of them");
    }
  }

  std::string Name;
  std::size_t Number = 0;
  bool HasTitle = false;
  Recipe Steps;
};

} // namespace

Recipe recipeOf(const Document& document, StepId id)
{
  Recipe recipe;
  for (const StepId place : document.pathTo(id))
  {
    const Step& step = document.step(place);
    if (step.parent == 0)
    {
      continue; // the files
    }
    RecipeStep made{ findOperation(step.verb), parseValues(step.verb, step.parameters) };
    for (const Parameter& parameter : made.operation->parameters)
    {
      if (made.given.at(parameter.name) == parameter.defaultValue)
      {
        made.given.erase(parameter.name);
      }
    }
    recipe.push_back(std::move(made));
  }
  return recipe;
}

std::string textOf(const Recipe& recipe)
{
  std::string text(kTitle);
  text += "\n# made by Scanwrap " SCAN_VERSION "; options that are not named have their defaults\n";
  for (const RecipeStep& step : recipe)
  {
    text.append("\n").append(step.operation->verb).append("\n");
    for (const auto& [name, value] : step.given)
    {
      const auto* const lines = std::get_if<TextList>(&value);
      for (const std::string& line : lines != nullptr ? *lines : TextList{ textOf(value) })
      {
        text.append("  ").append(name).append(" = ").append(line).append("\n");
      }
    }
  }
  return text;
}

Recipe parseRecipe(std::string_view text, const std::string& name)
{
  RecipeParser parser(name);
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    parser.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.recipe();
}

Recipe readRecipe(const std::string& place)
{
  const std::size_t colon = place.rfind(':');
  if (colon != std::string::npos && isProjectName(place.substr(0, colon)))
  {
    const auto kept = ProjectFile(place.substr(0, colon)).texts("template");
    const auto found = kept.find(place.substr(colon + 1));
    if (found == kept.end())
    {
      throw Error(ErrorCode::badParameter, place + ": there is no such template in the project");
    }
    return parseRecipe(found->second, place);
  }
  const MappedFile file(place);
  return parseRecipe({ file.bytes().data(), file.bytes().size() }, file.name());
}

} // namespace scan
