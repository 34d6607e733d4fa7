// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_functions.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace scan
{
namespace
{

using Kind = RegionRule::Kind;

struct Operator
{
  char symbol;
  Kind kind;
};
constexpr std::array<Operator, 3> kOperators{ { { '&', Kind::both }, { '+', Kind::either },
  { '-', Kind::without } } };

void appendNumbers(std::string& text, const std::vector<double>& numbers)
{
  for (const double number : numbers)
  {
    std::array<char, 32> digits{};
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text += text.back() == '(' ? "" : ",";
    text.append(digits.data(), result.ptr);
  }
}

/// What stands around an operand: 0 for a sum, 1 for a factor, 2 behind !.
std::string textWithin(const RegionRule& rule, int binding);

std::string textOfOperator(const RegionRule& rule, char symbol, int binding)
{
  const int own = symbol == '&' ? 1 : 0;
  std::string text;
  for (const RegionRule& part : rule.parts)
  {
    const bool isFirst = text.empty();
    text += isFirst ? "" : std::string{ ' ', symbol, ' ' };
    text += textWithin(part, isFirst ? own : own + 1);
  }
  return binding > own ? std::string("(").append(text).append(")") : text;
}

std::string textOfCall(const RegionRule& rule, const RegionFunction& function)
{
  std::string text(function.name());
  if (function.form == function.name())
  {
    return text;
  }
  text += "(";
  const auto append = [&](const std::string& argument)
  { text.append(text.back() == '(' ? "" : ",").append(argument); };
  if (function.view)
  {
    text += rule.view.name;
    if (!rule.view.numbers.empty())
    {
      text += "(";
      appendNumbers(text, rule.view.numbers);
      text += ")";
    }
  }
  if (function.rule)
  {
    append(textWithin(rule.parts.front(), 0));
  }
  if (function.array)
  {
    append(rule.array);
  }
  if (function.radiusFirst)
  {
    append(rule.radius.text());
  }
  appendNumbers(text, rule.numbers);
  if (function.radiusLast)
  {
    append(rule.radius.text());
  }
  return text.append(")");
}

std::string textWithin(const RegionRule& rule, int binding)
{
  if (rule.kind == Kind::opposite)
  {
    return std::string("!").append(textWithin(rule.parts.front(), 2));
  }
  const auto* const symbol = std::ranges::find(kOperators, rule.kind, &Operator::kind);
  if (symbol != kOperators.end())
  {
    return textOfOperator(rule, symbol->symbol, binding);
  }
  const bool isDeviation = rule.kind == Kind::array && rule.array == kDeviation;
  const auto* const function = isDeviation
    ? std::ranges::find(kRegionFunctions, "deviation", &RegionFunction::name)
    : std::ranges::find_if(kRegionFunctions,
        [&](const RegionFunction& f)
        { return f.kind == rule.kind && (f.kind != Kind::array || f.array); });
  return textOfCall(rule, *function);
}

} // namespace

std::string textOf(const RegionRule& rule)
{
  return textWithin(rule, 0);
}

} // namespace scan
