// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/operation_table.h"

#include "filters/base/error.h"

#include <vtkAlgorithm.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace scan;

TEST(OperationTable, DescribesEveryOperationCompletely)
{
  std::set<std::string> verbs;
  for (const Operation& operation : operationTable())
  {
    EXPECT_TRUE(verbs.insert(operation.verb).second) << operation.verb << " is there twice";
    EXPECT_FALSE(operation.help.empty()) << operation.verb;
    EXPECT_NE(operation.example.find(" " + operation.verb), std::string::npos) << operation.verb;
    EXPECT_EQ(findOperation(operation.verb), &operation);
    std::set<std::string> names;
    for (const Parameter& parameter : operation.parameters)
    {
      EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " is there twice";
      EXPECT_FALSE(parameter.help.empty()) << parameter.name;
      EXPECT_NO_THROW(checkValue(parameter, parameter.defaultValue)) << parameter.name;
    }
  }
  EXPECT_EQ(findOperation("nonsense"), nullptr);
}

TEST(OperationTable, WorksOnRegions)
{
  // makes one; bring their own points; moves the points of a file
  const std::set<std::string> withoutRegion{ "select", "add", "merge", "align" };
  for (const Operation& operation : operationTable())
  {
    const bool isOfModels = operation.stage == Stage::points || operation.stage == Stage::wrap ||
      operation.stage == Stage::surface || operation.stage == Stage::analysis;
    EXPECT_EQ(std::ranges::count(operation.parameters, "region", &Parameter::name),
      isOfModels && !withoutRegion.contains(operation.verb) ? 1 : 0)
      << operation.verb;
  }
}

TEST(OperationTable, MakesAFreshFilterEachTimeForEveryChoice)
{
  for (const Operation& operation : operationTable())
  {
    EXPECT_NE(
      operation.make(completeValues(operation, {})), operation.make(completeValues(operation, {})));
    for (const Parameter& parameter : operation.parameters)
    {
      for (const std::string& choice : parameter.choices)
      {
        const auto filter =
          operation.make(completeValues(operation, { { parameter.name, choice } }));
        EXPECT_EQ(filter->GetNumberOfInputPorts(), 1) << operation.verb;
        EXPECT_EQ(filter->GetNumberOfOutputPorts(), 1) << operation.verb;
      }
    }
  }
}

TEST(OperationTable, RefusesUnknownAndMalformedParameters)
{
  const Operation& wrap = *findOperation("wrap");
  EXPECT_THROW(completeValues(wrap, { { "nonsense", true } }), Error);
  EXPECT_THROW(completeValues(wrap, { { "fit", true } }), Error);
  EXPECT_THROW(completeValues(wrap, { { "fit", "some" } }), Error);
  EXPECT_EQ(completeValues(wrap, { { "fit", "robust" } }).at("fit"), ParameterValue("robust"));
  EXPECT_EQ(completeValues(wrap, {}).at("manifold"), ParameterValue(true));
}
