// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_rule.h"

#include "filters/base/error.h"
#include "filters/geometry/region_functions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace scan
{
namespace
{

using Kind = RegionRule::Kind;

constexpr std::size_t kMostParts = 10000;
constexpr int kMostNesting = 100;
constexpr double kMostCoordinate = 1e50; // as in files
constexpr double kMostRings = 1e6;

bool isLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool isOfName(char c)
{
  return isLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

std::size_t partsOf(const RegionRule& rule)
{
  std::size_t count = 1;
  for (const RegionRule& part : rule.parts)
  {
    count += partsOf(part);
  }
  return count;
}

int nestingOf(const RegionRule& rule)
{
  int most = 0;
  for (const RegionRule& part : rule.parts)
  {
    most = std::max(most, nestingOf(part));
  }
  return most + 1;
}

/// Of operands in a row one node with many parts: a thousand strokes of a brush are not deep.
RegionRule joined(Kind kind, RegionRule left, RegionRule right)
{
  if (left.kind != kind)
  {
    RegionRule rule;
    rule.kind = kind;
    rule.parts.push_back(std::move(left));
    left = std::move(rule);
  }
  left.parts.push_back(std::move(right));
  return left;
}

class Parser
{
public:
  /// Without names any name may stand for a region.
  Parser(std::string_view text, const RegionNames* names)
    : Text(text)
    , Names(names)
  {
  }

  RegionRule parse()
  {
    RegionRule rule = this->sum();
    this->next();
    if (this->Place < this->Text.size())
    {
      this->fail("an operator (& + -) or the end");
    }
    if (nestingOf(rule) > kMostNesting)
    {
      this->fail("fewer functions within each other");
    }
    return rule;
  }

private:
  /// The next character that is no blank; 0 at the end.
  char next()
  {
    constexpr std::string_view kBlanks = " \t\r\n";
    this->Place = std::min(this->Text.find_first_not_of(kBlanks, this->Place), this->Text.size());
    return this->Place < this->Text.size() ? this->Text[this->Place] : '\0';
  }

  bool take(char symbol)
  {
    const bool isThere = this->next() == symbol;
    this->Place += isThere ? 1 : 0;
    return isThere;
  }

  [[noreturn]] void fail(const std::string& expected)
  {
    constexpr std::size_t kMostShown = 20;
    this->next();
    std::string found = "the end";
    if (this->Place < this->Text.size())
    {
      found.assign(1, '\'').append(this->Text.substr(this->Place, kMostShown)).append("'");
      std::ranges::replace_if(
        found, [](char c) { return c < ' ' || c > '~'; }, '?');
    }
    throw Error(ErrorCode::badParameter,
      "region: character " + std::to_string(this->Place + 1) + ": expected " + expected +
        ", found " + found);
  }

  [[noreturn]] void failAt(std::size_t place, const std::string& expected)
  {
    this->Place = place;
    this->fail(expected);
  }

  void require(char symbol, const RegionFunction& function)
  {
    if (!this->take(symbol))
    {
      this->fail(std::string{ '\'', symbol, '\'' }.append(" of ").append(function.form));
    }
  }

  RegionRule sum();
  RegionRule product();
  RegionRule operand();
  RegionRule named(std::string_view name, std::size_t place);
  RegionRule call(const RegionFunction& function);
  void values(const RegionFunction& function, RegionRule& rule);
  std::string_view word();
  double number(const RegionFunction& function);
  Length radius(const RegionFunction& function);
  RegionView view(const RegionFunction& function);
  void countPart(std::size_t more);

  std::string_view Text;
  const RegionNames* Names;
  std::size_t Place = 0;
  std::size_t Parts = 0;
  int Nesting = 0;
};

void Parser::countPart(std::size_t more)
{
  this->Parts += more;
  if (this->Parts > kMostParts)
  {
    this->fail("no more than " + std::to_string(kMostParts) + " functions");
  }
}

RegionRule Parser::sum()
{
  RegionRule rule = this->product();
  for (char symbol = this->next(); symbol == '+' || symbol == '-'; symbol = this->next())
  {
    ++this->Place;
    rule = joined(symbol == '+' ? Kind::either : Kind::without, std::move(rule), this->product());
  }
  return rule;
}

RegionRule Parser::product()
{
  RegionRule rule = this->operand();
  while (this->take('&'))
  {
    rule = joined(Kind::both, std::move(rule), this->operand());
  }
  return rule;
}

RegionRule Parser::operand()
{
  if (++this->Nesting > kMostNesting)
  {
    this->fail("fewer functions within each other");
  }
  this->countPart(1);
  RegionRule rule;
  if (this->take('!'))
  {
    rule.kind = Kind::opposite;
    rule.parts.push_back(this->operand());
  }
  else if (this->take('('))
  {
    rule = this->sum();
    if (!this->take(')'))
    {
      this->fail("an operator (& + -) or ')'");
    }
  }
  else
  {
    this->next();
    const std::size_t place = this->Place;
    rule = this->named(this->word(), place);
  }
  --this->Nesting;
  return rule;
}

/// Letters and what follows them in a name.
std::string_view Parser::word()
{
  if (!isLetter(this->next()))
  {
    this->fail("a name or a function such as box(x,y,z, x,y,z)");
  }
  const std::size_t begin = this->Place;
  const auto isBehind = [&]
  { return this->Place < this->Text.size() && isOfName(this->Text[this->Place]); };
  while (isBehind())
  {
    ++this->Place;
  }
  return this->Text.substr(begin, this->Place - begin);
}

RegionRule Parser::named(std::string_view name, std::size_t place)
{
  const auto* function = std::ranges::find(kRegionFunctions, name, &RegionFunction::name);
  if (function != kRegionFunctions.end())
  {
    if (function->kind == Kind::componentAt && this->next() == '(')
    {
      const std::size_t open = this->Place++;
      const bool isRule = isLetter(this->next()) || this->next() == '(' || this->next() == '!';
      this->Place = open;
      function += isRule ? 1 : 0;
    }
    return this->call(*function);
  }
  if (this->Names == nullptr)
  {
    return {};
  }
  const auto known = this->Names->find(name);
  if (known != this->Names->end())
  {
    this->countPart(partsOf(known->second));
    return known->second;
  }
  std::string expected;
  for (const auto& [other, rule] : *this->Names)
  {
    expected += (expected.empty() ? "a function or one of the regions " : ", ") + other;
  }
  this->failAt(place,
    (expected.empty() ? "a function, the model has no regions yet" : expected) +
      (name.find('-') != name.npos ? "; a minus sign has blanks around it" : ""));
}

RegionRule Parser::call(const RegionFunction& function)
{
  RegionRule rule;
  rule.kind = function.kind;
  if (function.form == function.name())
  {
    return rule;
  }
  this->require('(', function);
  bool isFirst = true;
  const auto begin = [&](bool isArgument)
  {
    if (isArgument && !isFirst)
    {
      this->require(',', function);
    }
    isFirst = isFirst && !isArgument;
    return isArgument;
  };
  if (begin(function.view))
  {
    rule.view = this->view(function);
  }
  if (begin(function.rule))
  {
    rule.parts.push_back(this->sum());
  }
  if (function.kind == Kind::array)
  {
    rule.array = begin(function.array) ? this->word() : kDeviation;
  }
  if (begin(function.radiusFirst))
  {
    rule.radius = this->radius(function);
  }
  if (begin(function.numbers > 0))
  {
    this->values(function, rule);
  }
  if (begin(function.radiusLast))
  {
    rule.radius = this->radius(function);
  }
  this->require(')', function);
  return rule;
}

void Parser::values(const RegionFunction& function, RegionRule& rule)
{
  for (std::size_t i = 0; i < function.numbers; ++i)
  {
    if (i > 0)
    {
      this->require(',', function);
    }
    rule.numbers.push_back(this->number(function));
  }
  while (function.more > 0 && this->next() == ',')
  {
    for (std::size_t i = 0; i < function.more; ++i)
    {
      this->require(',', function);
      rule.numbers.push_back(this->number(function));
    }
  }
  const std::vector<double>& v = rule.numbers;
  if (function.values == RegionFunction::Values::range && v[0] > v[1])
  {
    this->fail("in " + std::string(function.form) + " a min that is not above max");
  }
  if (function.kind == Kind::plane && v[3] == 0.0 && v[4] == 0.0 && v[5] == 0.0)
  {
    this->fail("in " + std::string(function.form) + " a normal that is not zero");
  }
}

double Parser::number(const RegionFunction& function)
{
  this->next();
  const std::size_t place = this->Place;
  double value = 0.0;
  const auto [end, status] =
    std::from_chars(this->Text.data() + place, this->Text.data() + this->Text.size(), value);
  this->Place = static_cast<std::size_t>(end - this->Text.data());
  const bool isCount = function.values == RegionFunction::Values::counts;
  const double most = !isCount ? kMostCoordinate
    : function.rule            ? kMostRings
                               : static_cast<double>(kNone) - 1.0;
  const bool isInRange = isCount ? value >= 0.0 && value <= most && value == std::floor(value)
                                 : std::abs(value) <= most ||
      (function.values == RegionFunction::Values::range && std::isinf(value));
  if (status != std::errc() || !isInRange)
  {
    this->failAt(place,
      (isCount ? "a whole number from 0 for " : "a number from -1e50 to 1e50 for ") +
        std::string(function.form));
  }
  return value;
}

Length Parser::radius(const RegionFunction& function)
{
  this->next();
  const std::size_t place = this->Place;
  this->Place = std::min(this->Text.find_first_of(",) \t\r\n", place), this->Text.size());
  Length length(-1.0);
  try
  {
    length = Length::parse(this->Text.substr(place, this->Place - place));
  }
  catch (const Error&) // told below, with the place
  {
  }
  if (!(length.value() >= 0.0 && length.value() <= kMostCoordinate))
  {
    this->failAt(
      place, "a length such as 0.5, 2mm, 1% or 3x for r of " + std::string(function.form));
  }
  return length;
}

RegionView Parser::view(const RegionFunction& function)
{
  constexpr const char* kViews = "a view (front, back, left, right, top, bottom, "
                                 "from(ex,ey,ez, ax,ay,az, ux,uy,uz), along(dx,dy,dz, ux,uy,uz))";
  this->next();
  const std::size_t place = this->Place;
  const bool isWord = isLetter(this->next());
  RegionView view{ .name = std::string(isWord ? this->word() : std::string_view()), .numbers = {} };
  const auto count = viewNumbers(view.name);
  if (!count)
  {
    this->failAt(place, kViews);
  }
  for (std::size_t i = 0; i < *count; ++i)
  {
    this->require(i == 0 ? '(' : ',', function);
    view.numbers.push_back(this->number(function));
  }
  if (*count > 0)
  {
    this->require(')', function);
  }
  try
  {
    static_cast<void>(Screen(view));
  }
  catch (const Error&)
  {
    this->failAt(place, "a view whose direction and up are not zero and differ");
  }
  return view;
}

} // namespace

RegionRule parseRegionRule(std::string_view text, const RegionNames& names)
{
  return Parser(text, &names).parse();
}

void checkRegionRule(std::string_view text)
{
  static_cast<void>(Parser(text, nullptr).parse());
}

bool isRegionName(std::string_view name)
{
  return !name.empty() && isLetter(name.front()) && std::ranges::all_of(name, isOfName) &&
    std::ranges::find(kRegionFunctions, name, &RegionFunction::name) == kRegionFunctions.end();
}

} // namespace scan
