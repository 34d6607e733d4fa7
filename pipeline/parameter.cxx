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
};

struct Text
{
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return numberText(value); }
  std::string operator()(double value) const { return numberText(value); }
  std::string operator()(const Length& value) const { return value.text(); }
  std::string operator()(const std::string& value) const { return value; }
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
}

std::string textOf(const ParameterValue& value)
{
  return std::visit(Text{}, value);
}

} // namespace scan
