// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/output_files.h"

#include "filters/base/error.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace scan;

TEST(OutputFiles, RefuseWhatCannotBeWrittenBeforeTheWork)
{
  const std::string folder = testing::TempDir();
  EXPECT_THROW(checkOutput("", true), Error);
  EXPECT_THROW(checkOutput(folder, true), Error);
  EXPECT_THROW(checkOutput(folder + "nowhere/out.stl", true), Error);
  EXPECT_NO_THROW(checkOutput("-", false));
  EXPECT_NO_THROW(checkOutput("/dev/null", false));
}

TEST(OutputFiles, ReplaceOnlyWhenAsked)
{
  const std::string path = testing::TempDir() + "output_files_test.txt";
  std::filesystem::remove(path);
  EXPECT_NO_THROW(checkOutput(path, false));
  writeText(path, "text");
  EXPECT_EQ(std::filesystem::file_size(path), 4U);
  EXPECT_THROW(checkOutput(path, false), Error);
  EXPECT_NO_THROW(checkOutput(path, true));
  std::filesystem::remove(path);
}
