// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/output_files.h"

#include "filters/base/error.h"
#include "tests/readers/temporary_folder.h"

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

TEST(OutputFiles, AreLookedForBehindLinks)
{
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("open"));
  std::filesystem::create_symlink("open/b.stl", folder.file("a.stl"));
  std::filesystem::create_symlink("nowhere/b.stl", folder.file("lost.stl"));
  EXPECT_NO_THROW(checkOutput(folder.file("a.stl"), false));
  EXPECT_THROW(checkOutput(folder.file("lost.stl"), false), Error);
}

TEST(OutputFiles, AreTheSameBehindLinks)
{
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("d"));
  std::filesystem::create_symlink("b.ply", folder.file("a.ply")); // b.ply does not exist
  std::filesystem::create_symlink("d", folder.file("link"));
  EXPECT_TRUE(isSameFile(folder.file("a.ply"), folder.file("b.ply")));
  EXPECT_TRUE(isSameFile(folder.file("link/x"), folder.file("d/x")));
  EXPECT_FALSE(isSameFile(folder.file("a.ply"), folder.file("c.ply")));
  EXPECT_TRUE(isSameFile("-", "-"));
  EXPECT_FALSE(isSameFile("-", folder.file("-")));
}
