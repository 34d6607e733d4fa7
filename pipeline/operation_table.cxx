// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/operation_table.h"

#include "filters/base/error.h"
#include "pipeline/operation_rows.h"

#include <algorithm>
#include <array>

namespace scan
{

std::string_view nameOf(Stage stage)
{
  static constexpr std::array<std::string_view, 6> kNames{ "input", "points", "wrap", "surface",
    "analysis", "output" };
  return kNames.at(static_cast<std::size_t>(stage));
}

const std::vector<Operation>& operationTable()
{
  static const std::vector<Operation> kTable = []
  {
    std::vector<Operation> table = wrapOperations();
    const std::vector<Operation> analysis = analysisOperations();
    table.insert(table.end(), analysis.begin(), analysis.end());
    return table;
  }();
  return kTable;
}

const Operation* findOperation(std::string_view verb)
{
  const std::vector<Operation>& table = operationTable();
  const auto row = std::ranges::find(table, verb, &Operation::verb);
  return row != table.end() ? &*row : nullptr;
}

ParameterValues completeValues(const Operation& operation, const ParameterValues& given)
{
  ParameterValues values;
  for (const Parameter& parameter : operation.parameters)
  {
    values[parameter.name] = parameter.defaultValue;
  }
  for (const auto& [name, value] : given)
  {
    const auto parameter = std::ranges::find(operation.parameters, name, &Parameter::name);
    if (parameter == operation.parameters.end())
    {
      throw Error(ErrorCode::badParameter, operation.verb + ": there is no option --" + name);
    }
    checkValue(*parameter, value);
    values[name] = value;
  }
  return values;
}

} // namespace scan
