// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/parameter.h"

#include "filters/base/error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace scan
{

namespace
{

template <class Number>
std::string numberText(Number number)
{
  std::array<char, 32> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  return { digits.data(), result.ptr };
}

template <class Number>
std::optional<Number> parseNumber(std::string_view text)
{
  Number number{};
  const char* const last = text.data() + text.size();
  const auto [end, status] = std::from_chars(text.data(), last, number);
  return status == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

/// The numbers between separators; none when one of them is malformed.
template <class Number>
std::optional<std::vector<Number>> parseNumbers(std::string_view text, char separator)
{
  std::vector<Number> numbers;
  while (true)
  {
    const std::size_t end = text.find(separator);
    const auto number = parseNumber<Number>(text.substr(0, end));
    if (!number)
    {
      return std::nullopt;
    }
    numbers.push_back(*number);
    if (end == std::string_view::npos)
    {
      return numbers;
    }
    text.remove_prefix(end + 1);
  }
}

TextList linesOf(std::string_view text)
{
  TextList lines;
  while (!text.empty())
  {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<PointList> parsePoints(std::string_view text)
{
  PointList points;
  while (true)
  {
    const std::size_t end = text.find(';');
    const auto numbers = parseNumbers<double>(text.substr(0, end), ',');
    if (!numbers || numbers->size() != 3)
    {
      return std::nullopt;
    }
    points.push_back({ (*numbers)[0], (*numbers)[1], (*numbers)[2] });
    if (end == std::string_view::npos)
    {
      return points;
    }
    text.remove_prefix(end + 1);
  }
}

bool hasMinimum(const Parameter& parameter)
{
  return parameter.minimum != std::numeric_limits<double>::lowest();
}

bool hasMaximum(const Parameter& parameter)
{
  return parameter.maximum != std::numeric_limits<double>::max();
}

std::string between(const Parameter& parameter)
{
  std::string text;
  if (hasMinimum(parameter))
  {
    text += " from " + numberText(parameter.minimum);
  }
  if (hasMaximum(parameter))
  {
    text += (hasMinimum(parameter) ? " to " : " up to ") + numberText(parameter.maximum);
  }
  else if (hasMinimum(parameter))
  {
    text += " up";
  }
  return text;
}

std::string joined(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : "|") + word;
  }
  return text;
}

[[noreturn]] void refuse(const Parameter& parameter, const std::string& text)
{
  throw Error(ErrorCode::badParameter,
    "--" + parameter.name + "=" + text + ": expected " + rangeText(parameter));
}

struct IsInRange
{
  const Parameter& parameter;

  bool operator()(bool) const { return true; }
  bool operator()(std::int64_t value) const { return (*this)(static_cast<double>(value)); }
  bool operator()(double value) const
  {
    return value >= this->parameter.minimum && value <= this->parameter.maximum;
  }
  bool operator()(const Length& value) const { return (*this)(value.value()); }
  bool operator()(const PointList& points) const
  {
    return std::ranges::all_of(points,
      [](const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); });
  }
  bool operator()(const IdList&) const { return true; }
  bool operator()(const TextList&) const { return true; }
  bool operator()(const std::string& value) const
  {
    const std::vector<std::string>& choices = this->parameter.choices;
    return choices.empty() || std::ranges::find(choices, value) != choices.end();
  }
};

/// Parses a text into the type of the default value; none when it is malformed.
struct Parse
{
  std::string_view text;

  std::optional<ParameterValue> operator()(bool) const
  {
    if (this->text == "true" || this->text == "false")
    {
      return this->text == "true";
    }
    return std::nullopt;
  }
  std::optional<ParameterValue> operator()(std::int64_t) const
  {
    return parseNumber<std::int64_t>(this->text);
  }
  std::optional<ParameterValue> operator()(double) const { return parseNumber<double>(this->text); }
  std::optional<ParameterValue> operator()(const Length&) const
  {
    return Length::parse(this->text);
  }
  std::optional<ParameterValue> operator()(const std::string&) const
  {
    return std::string(this->text);
  }
  std::optional<ParameterValue> operator()(const PointList&) const
  {
    return parsePoints(this->text);
  }
  std::optional<ParameterValue> operator()(const IdList&) const
  {
    return parseNumbers<std::int64_t>(this->text, ',');
  }
  std::optional<ParameterValue> operator()(const TextList&) const { return linesOf(this->text); }
};

struct RangeText
{
  const Parameter& parameter;

  std::string operator()(bool) const { return "true|false"; }
  std::string operator()(std::int64_t) const { return "a whole number" + between(this->parameter); }
  std::string operator()(double) const { return "a number" + between(this->parameter); }
  std::string operator()(const Length&) const
  {
    return "a length such as 0.5mm, 1% or 3x" + between(this->parameter);
  }
  std::string operator()(const std::string&) const
  {
    return this->parameter.choices.empty() ? "a text" : joined(this->parameter.choices);
  }
  std::string operator()(const PointList&) const { return "x,y,z or more points, x,y,z;x,y,z"; }
  std::string operator()(const IdList&) const { return "a whole number or more, 1,2,3"; }
  std::string operator()(const TextList&) const { return "a text; may be given more than once"; }
};

struct Text
{
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return numberText(value); }
  std::string operator()(double value) const { return numberText(value); }
  std::string operator()(const Length& value) const { return value.text(); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const PointList& points) const
  {
    std::string text;
    for (const Vec3& p : points)
    {
      text.append(text.empty() ? "" : ";").append(numberText(p.x)).append(",");
      text.append(numberText(p.y)).append(",").append(numberText(p.z));
    }
    return text;
  }
  std::string operator()(const IdList& ids) const
  {
    std::string text;
    for (const std::int64_t id : ids)
    {
      text.append(text.empty() ? "" : ",").append(numberText(id));
    }
    return text;
  }
  std::string operator()(const TextList& texts) const
  {
    std::string text;
    for (const std::string& line : texts)
    {
      text.append(&line == &texts.front() ? "" : "\n").append(line);
    }
    return text;
  }
};

} // namespace

std::string rangeText(const Parameter& parameter)
{
  return std::visit(RangeText{ parameter }, parameter.defaultValue);
}

ParameterValue parseValue(const Parameter& parameter, std::string_view text)
{
  const auto value = std::visit(Parse{ text }, parameter.defaultValue);
  if (!value)
  {
    refuse(parameter, std::string(text));
  }
  checkValue(parameter, *value);
  return *value;
}

void checkValue(const Parameter& parameter, const ParameterValue& value)
{
  if (value.index() != parameter.defaultValue.index() || !std::visit(IsInRange{ parameter }, value))
  {
    refuse(parameter, textOf(value));
  }
  const auto* const text = std::get_if<std::string>(&value);
  if (parameter.check != nullptr && text != nullptr && !text->empty())
  {
    parameter.check(*text);
  }
}

ParameterValues completeValues(
  const std::vector<Parameter>& parameters, const ParameterValues& given, const std::string& owner)
{
  ParameterValues values;
  for (const Parameter& parameter : parameters)
  {
    values[parameter.name] = parameter.defaultValue;
  }
  for (const auto& [name, value] : given)
  {
    const auto parameter = std::ranges::find(parameters, name, &Parameter::name);
    if (parameter == parameters.end())
    {
      std::string message = owner;
      message += ": there is no option --";
      message += name;
      throw Error(ErrorCode::badParameter, message);
    }
    checkValue(*parameter, value);
    values[name] = value;
  }
  return values;
}

bool appendValue(ParameterValue& list, const ParameterValue& more)
{
  const auto append = [&]<class List>(List* to)
  {
    const auto* from = std::get_if<List>(&more);
    if (to == nullptr || from == nullptr)
    {
      return false;
    }
    to->insert(to->end(), from->begin(), from->end());
    return true;
  };
  return append(std::get_if<PointList>(&list)) || append(std::get_if<IdList>(&list)) ||
    append(std::get_if<TextList>(&list));
}

std::string textOf(const ParameterValue& value)
{
  return std::visit(Text{}, value);
}

} // namespace scan
