// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/command_line.h"

#include "app/cli/suggestion.h"
#include "filters/base/error.h"

#include <gtest/gtest.h>

using namespace scan;

namespace
{

CommandLine parse(const std::vector<std::string>& words)
{
  return parseCommandLine(words);
}

} // namespace

TEST(CommandLine, KeepsTheOrderOfVerbsAndOutputs)
{
  const CommandLine line =
    parse({ "a.xyz", "b.xyz", "-o", "1.ply", "wrap", "--fit=robust", "-o", "2.stl", "wrap" });
  EXPECT_EQ(line.inputs, (std::vector<std::string>{ "a.xyz", "b.xyz" }));
  ASSERT_EQ(line.steps.size(), 4U);
  EXPECT_EQ(std::get<OutputWish>(line.steps[0]).path, "1.ply");
  EXPECT_EQ(std::get<OperationWish>(line.steps[1]).given.at("fit"), ParameterValue("robust"));
  EXPECT_EQ(std::get<OutputWish>(line.steps[2]).path, "2.stl");
  EXPECT_TRUE(std::get<OperationWish>(line.steps[3]).given.empty());
}

TEST(CommandLine, TakesGlobalOptionsAnywhere)
{
  const CommandLine line =
    parse({ "--threads=3", "a.xyz", "wrap", "--quiet", "--max-memory=1.5G" });
  EXPECT_EQ(line.threads, 3U);
  EXPECT_TRUE(line.quiet);
  EXPECT_EQ(line.maxMemory, std::int64_t{ 3 } << 29U);
}

TEST(CommandLine, RefusesMalformedOptions)
{
  for (const char* option : { "--threads=x", "--threads=-1", "--threads", "--quiet=maybe",
         "--max-memory=lots", "--max-memory=1GB", "--max-memory=-1", "--nonsense", "-x", "-o" })
  {
    EXPECT_THROW(parse({ "a.xyz", option }), Error) << option;
  }
}

TEST(CommandLine, VerbsHideNoGlobalOption)
{
  for (const Operation& operation : operationTable())
  {
    for (const Parameter& parameter : operation.parameters)
    {
      for (const Parameter& global : globalOptions())
      {
        EXPECT_NE(parameter.name, global.name) << operation.verb;
      }
    }
  }
}

TEST(Suggestion, FindsTypingErrorsOnly)
{
  const std::vector<std::string> verbs{ "wrap", "info", "render" };
  EXPECT_EQ(suggestion("rendre", verbs), "; did you mean 'render'?");
  EXPECT_EQ(suggestion("wap", verbs), "; did you mean 'wrap'?");
  EXPECT_EQ(suggestion("scan.xyz", verbs), "");
  EXPECT_EQ(suggestion("x", verbs), "");
}
