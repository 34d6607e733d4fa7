// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/result_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

namespace scan
{

namespace
{

struct ToText
{
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(const std::string& value) const { return value; }
  template <class Number>
  std::string operator()(Number value) const
  {
    return fmt::format("{}", value);
  }
};

} // namespace

std::string tableOf(const Results& results)
{
  std::size_t width = 0;
  for (const auto& [name, value] : results)
  {
    width = std::max(width, name.size());
  }
  std::string text;
  for (const auto& [name, value] : results)
  {
    text += fmt::format("{:<{}}  {}\n", name, width, std::visit(ToText{}, value));
  }
  return text;
}

} // namespace scan
