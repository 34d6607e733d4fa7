// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/operation_table.h"

#include "filters/base/error.h"
#include "pipeline/operation_rows.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace scan
{

std::string_view nameOf(Stage stage)
{
  static constexpr std::array<std::string_view, 7> kNames{ "history", "input", "points", "wrap",
    "surface", "analysis", "output" };
  return kNames.at(static_cast<std::size_t>(stage));
}

const std::vector<Operation>& operationTable()
{
  static const std::vector<Operation> kTable = []
  {
    std::vector<Operation> table = pointOperations();
    for (const auto& rows :
      { regionOperations(), wrapOperations(), surfaceOperations(), analysisOperations() })
    {
      table.insert(table.end(), rows.begin(), rows.end());
    }
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
  return completeValues(operation.parameters, given, operation.verb);
}

} // namespace scan
