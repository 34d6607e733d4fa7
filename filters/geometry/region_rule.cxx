// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_rule.h"

#include "filters/base/error.h"

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
constexpr std::string_view kDeviation = "Deviation";

/// A function: its arguments stand in the order of the fields.
struct Function
{
  std::string_view form;
  Kind kind;
  bool view = false;
  bool rule = false;
  bool array = false;
  bool radiusFirst = false;
  std::size_t numbers = 0; ///< at least
  std::size_t more = 0;    ///< how many more may follow, again and again
  bool radiusLast = false;
  enum class Values
  {
    coordinates,
    range,
    counts
  } values = Values::coordinates;

  std::string_view name() const { return this->form.substr(0, this->form.find('(')); }
};

constexpr std::array<Function, 18> kFunctions{ {
  { .form = "all", .kind = Kind::all },
  { .form = "none", .kind = Kind::none },
  { .form = "box(x,y,z, x,y,z)", .kind = Kind::box, .numbers = 6 },
  { .form = "sphere(x,y,z, r)", .kind = Kind::sphere, .numbers = 3, .radiusLast = true },
  { .form = "plane(x,y,z, nx,ny,nz)", .kind = Kind::plane, .numbers = 6 },
  { .form = "brush(r, x,y,z, ...)",
    .kind = Kind::brush,
    .radiusFirst = true,
    .numbers = 3,
    .more = 3 },
  { .form = "rectangle(VIEW, x,y, x,y)", .kind = Kind::rectangle, .view = true, .numbers = 4 },
  { .form = "polygon(VIEW, x,y, x,y, x,y, ...)",
    .kind = Kind::polygon,
    .view = true,
    .numbers = 6,
    .more = 2 },
  { .form = "depth(VIEW, x,y,z)", .kind = Kind::depth, .view = true, .numbers = 3 },
  { .form = "component(x,y,z)", .kind = Kind::componentAt, .numbers = 3 },
  { .form = "component(RULE)", .kind = Kind::componentOf, .rule = true },
  { .form = "curvature(min, max)",
    .kind = Kind::curvature,
    .numbers = 2,
    .values = Function::Values::range },
  { .form = "deviation(min, max)",
    .kind = Kind::array,
    .numbers = 2,
    .values = Function::Values::range },
  { .form = "array(NAME, min, max)",
    .kind = Kind::array,
    .array = true,
    .numbers = 2,
    .values = Function::Values::range },
  { .form = "grow(RULE, n)",
    .kind = Kind::grow,
    .rule = true,
    .numbers = 1,
    .values = Function::Values::counts },
  { .form = "shrink(RULE, n)",
    .kind = Kind::shrink,
    .rule = true,
    .numbers = 1,
    .values = Function::Values::counts },
  { .form = "points(i, ...)",
    .kind = Kind::points,
    .numbers = 1,
    .more = 1,
    .values = Function::Values::counts },
  { .form = "triangles(i, ...)",
    .kind = Kind::triangles,
    .numbers = 1,
    .more = 1,
    .values = Function::Values::counts },
} };

struct Operator
{
  char symbol;
  Kind kind;
};
constexpr std::array<Operator, 3> kOperators{ { { '&', Kind::both }, { '+', Kind::either },
  { '-', Kind::without } } };

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

  void require(char symbol, const Function& function)
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
  RegionRule call(const Function& function);
  void values(const Function& function, RegionRule& rule);
  std::string_view word();
  double number(const Function& function);
  Length radius(const Function& function);
  RegionView view(const Function& function);
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
  while (this->next() == '+' || this->next() == '-')
  {
    const Kind kind = this->take('+') ? Kind::either : Kind::without;
    this->Place += kind == Kind::without ? 1 : 0;
    rule = joined(kind, std::move(rule), this->product());
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
  const auto* function = std::ranges::find(kFunctions, name, &Function::name);
  if (function != kFunctions.end())
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

RegionRule Parser::call(const Function& function)
{
  RegionRule rule;
  rule.kind = function.kind;
  if (function.form == function.name())
  {
    return rule;
  }
  this->require('(', function);
  if (function.view)
  {
    rule.view = this->view(function);
    this->require(',', function);
  }
  if (function.rule)
  {
    rule.parts.push_back(this->sum());
  }
  if (function.array)
  {
    rule.array = this->word();
    this->require(',', function);
  }
  else if (function.kind == Kind::array)
  {
    rule.array = kDeviation;
  }
  if (function.radiusFirst)
  {
    rule.radius = this->radius(function);
    this->require(',', function);
  }
  if (function.rule && function.numbers > 0)
  {
    this->require(',', function);
  }
  this->values(function, rule);
  if (function.radiusLast)
  {
    this->require(',', function);
    rule.radius = this->radius(function);
  }
  this->require(')', function);
  return rule;
}

void Parser::values(const Function& function, RegionRule& rule)
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
  if (function.values == Function::Values::range && v[0] > v[1])
  {
    this->fail("in " + std::string(function.form) + " a min that is not above max");
  }
  if (function.kind == Kind::plane && v[3] == 0.0 && v[4] == 0.0 && v[5] == 0.0)
  {
    this->fail("in " + std::string(function.form) + " a normal that is not zero");
  }
}

double Parser::number(const Function& function)
{
  this->next();
  const std::size_t place = this->Place;
  double value = 0.0;
  const auto [end, status] =
    std::from_chars(this->Text.data() + place, this->Text.data() + this->Text.size(), value);
  this->Place = static_cast<std::size_t>(end - this->Text.data());
  const bool isCount = function.values == Function::Values::counts;
  const double most = !isCount ? kMostCoordinate
    : function.rule            ? kMostRings
                               : static_cast<double>(kNone) - 1.0;
  const bool isInRange = isCount
    ? value >= 0.0 && value <= most && value == std::floor(value)
    : std::abs(value) <= most || (function.values == Function::Values::range && std::isinf(value));
  if (status != std::errc() || !isInRange)
  {
    this->failAt(place,
      (isCount ? "a whole number from 0 for " : "a number from -1e50 to 1e50 for ") +
        std::string(function.form));
  }
  return value;
}

Length Parser::radius(const Function& function)
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

RegionView Parser::view(const Function& function)
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

std::string textOfCall(const RegionRule& rule, const Function& function)
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
    ? std::ranges::find(kFunctions, "deviation", &Function::name)
    : std::ranges::find_if(kFunctions,
        [&](const Function& f)
        { return f.kind == rule.kind && (f.kind != Kind::array || f.array); });
  return textOfCall(rule, *function);
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

std::string textOf(const RegionRule& rule)
{
  return textWithin(rule, 0);
}

bool isRegionName(std::string_view name)
{
  return !name.empty() && isLetter(name.front()) && std::ranges::all_of(name, isOfName) &&
    std::ranges::find(kFunctions, name, &Function::name) == kFunctions.end();
}

} // namespace scan
