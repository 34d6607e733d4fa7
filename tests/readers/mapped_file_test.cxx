// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/mapped_file.h"

#include "filters/base/error.h"
#include "tests/readers/temporary_folder.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <thread>

namespace
{

using scan::ErrorCode;
using scan::MappedFile;
using scan::test::TemporaryFolder;

ErrorCode codeOf(const std::string& path, std::string& message)
{
  try
  {
    const MappedFile file(path);
  }
  catch (const scan::Error& error)
  {
    message = error.what();
    return error.code();
  }
  message.clear();
  return ErrorCode::internal;
}

} // namespace

TEST(MappedFile, HoldsTheBytesOfTheFile)
{
  const TemporaryFolder folder;
  const std::string content("a\0b\n", 4);
  scan::test::setContent(folder.file("x"), content);
  const MappedFile file(folder.file("x"));
  EXPECT_EQ(std::string(file.bytes().begin(), file.bytes().end()), content);
}

TEST(MappedFile, ReadsAPipeToItsEnd)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const std::string content(3000000, 'x');
  std::thread writer([&] { scan::test::setContent(path, content); });
  const MappedFile file(path);
  writer.join();
  EXPECT_EQ(std::string(file.bytes().begin(), file.bytes().end()), content);
}

TEST(MappedFile, ExplainsWhatItCannotRead)
{
  const TemporaryFolder folder;
  std::string message;
  EXPECT_EQ(codeOf(folder.file("missing"), message), ErrorCode::io);
  EXPECT_NE(message.find("missing cannot be opened: No such file"), std::string::npos) << message;
  EXPECT_EQ(codeOf(folder.file(""), message), ErrorCode::io);
  EXPECT_NE(message.find("Is a directory"), std::string::npos) << message;
  scan::test::setContent(folder.file("empty"), "");
  EXPECT_EQ(codeOf(folder.file("empty"), message), ErrorCode::parse);
  EXPECT_EQ(message, folder.file("empty") + " is empty");
}
