// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/output_file.h"

#include "filters/base/error.h"
#include "tests/readers/temporary_folder.h"
#include "writers/size_limit.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

namespace
{

using scan::OutputFile;
using scan::test::contentOf;
using scan::test::TemporaryFolder;

/// Files of this process cannot grow beyond the limit, as on a full disk.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t bytes)
  {
    this->Handler = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &this->Before);
    const rlimit limit = { bytes, this->Before.rlim_max };
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit()
  {
    ::setrlimit(RLIMIT_FSIZE, &this->Before);
    std::signal(SIGXFSZ, this->Handler);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  rlimit Before = {};
  void (*Handler)(int) = nullptr;
};

std::string errorOf(const std::string& path, const std::string& content)
{
  try
  {
    OutputFile file(path);
    file.write(content);
    file.commit();
  }
  catch (const scan::Error& error)
  {
    return error.code() == scan::ErrorCode::io ? error.what() : "not an io error";
  }
  return {};
}

} // namespace

TEST(OutputFile, AppearsOnlyWhenCommitted)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("part.stl");
  OutputFile file(path);
  file.write("abc");
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(contentOf(path), "abc");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(OutputFile, LeavesNothingWithoutCommit)
{
  const TemporaryFolder folder;
  scan::test::setContent(folder.file("old"), "old");
  {
    OutputFile replaced(folder.file("old"));
    OutputFile fresh(folder.file("new"));
    fresh.write(std::string(3000000, 'x'));
    replaced.write("half");
  }
  EXPECT_EQ(contentOf(folder.file("old")), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(OutputFile, KeepsPermissionsAndLinksOfTheTarget)
{
  const TemporaryFolder folder;
  const std::string target = folder.file("target");
  scan::test::setContent(target, "old");
  ::chmod(target.c_str(), 0640);
  std::filesystem::create_symlink("target", folder.file("link"));
  EXPECT_EQ(errorOf(folder.file("link"), "new"), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(contentOf(target), "new");
  struct stat status = {};
  ASSERT_EQ(::stat(target.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(OutputFile, LeavesNothingWhenTheDiskIsFull)
{
  const TemporaryFolder folder;
  const FileSizeLimit limit(100000);
  const std::string error = errorOf(folder.file("part.stl"), std::string(3000000, 'x'));
  EXPECT_NE(error.find("part.stl: "), std::string::npos) << error;
  EXPECT_NE(error.find("nothing was written"), std::string::npos) << error;
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(OutputFile, SaysThatADeviceIsFull)
{
  if (!std::filesystem::exists("/dev/full"))
  {
    GTEST_SKIP() << "/dev/full is missing";
  }
  EXPECT_NE(errorOf("/dev/full", "abc").find("disk full"), std::string::npos);
  EXPECT_EQ(errorOf("/dev/null", "abc"), "");
}

TEST(OutputFile, ExplainsWhatItCannotOpen)
{
  const TemporaryFolder folder;
  EXPECT_NE(errorOf(folder.file("no/folder.stl"), "abc").find("No such file"), std::string::npos);
  EXPECT_NE(errorOf(folder.file(""), "abc").find("Is a directory"), std::string::npos);
}

TEST(OutputFile, LeavesNothingWhenTheProgramIsKilled)
{
  const TemporaryFolder folder;
  const int unnamed = ::open(folder.file("").c_str(), O_WRONLY | O_TMPFILE, 0600);
  if (unnamed < 0)
  {
    GTEST_SKIP() << "the file system has no files without a name";
  }
  ::close(unnamed);
  OutputFile file(folder.file("part.stl"));
  file.write(std::string(3000000, 'x'));
  EXPECT_EQ(folder.fileCount(), 0U); // nothing that a destructor would have to remove
}

TEST(OutputFile, TakesTheLongestNames)
{
  const TemporaryFolder folder;
  EXPECT_EQ(errorOf(folder.file(std::string(255, 'a')), "abc"), "");
  EXPECT_EQ(folder.fileCount(), 1U);
  EXPECT_NE(errorOf(folder.file(std::string(256, 'a')), "abc").find("too long"), std::string::npos);
}

TEST(OutputFile, WritesBehindALinkThatLeadsNowhereYet)
{
  const TemporaryFolder folder;
  std::filesystem::create_symlink("target", folder.file("link"));
  EXPECT_EQ(errorOf(folder.file("link"), "abc"), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(contentOf(folder.file("target")), "abc");
}

TEST(OutputFile, RefusesLinksInACircle)
{
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder.file("a"));
  std::filesystem::create_symlink("a", folder.file("b"));
  EXPECT_NE(errorOf(folder.file("a"), "abc").find("symbolic links"), std::string::npos);
}

TEST(OutputFile, WorksWhereEveryFileHasAName)
{
  const TemporaryFolder folder;
  {
    OutputFile lost(folder.file("lost"), OutputFile::Part::named);
    EXPECT_EQ(folder.fileCount(), 1U);
    EXPECT_FALSE(std::filesystem::exists(folder.file("lost")));
    OutputFile kept(folder.file("kept"), OutputFile::Part::named);
    kept.write("abc");
    kept.commit();
    EXPECT_EQ(folder.fileCount(), 2U);
  }
  EXPECT_EQ(folder.fileCount(), 1U);
  EXPECT_EQ(contentOf(folder.file("kept")), "abc");
}

TEST(OutputFile, CanRemoveAllPartsInAHurry)
{
  const TemporaryFolder folder;
  {
    OutputFile first(folder.file("first"), OutputFile::Part::named);
    OutputFile second(folder.file("second"), OutputFile::Part::named);
    OutputFile kept(folder.file("kept"), OutputFile::Part::named);
    kept.commit();
    EXPECT_EQ(folder.fileCount(), 3U);
    OutputFile::removeParts();
    EXPECT_EQ(folder.fileCount(), 1U);
    EXPECT_TRUE(std::filesystem::exists(folder.file("kept")));
  }
  for (int i = 0; i < 100; ++i) // places for parts are used again
  {
    OutputFile part(folder.file("part"), OutputFile::Part::named);
    OutputFile::removeParts();
    EXPECT_EQ(folder.fileCount(), 1U) << i;
  }
}

TEST(OutputFile, WritesLargePiecesInTheirPlace)
{
  const TemporaryFolder folder;
  OutputFile file(folder.file("out"));
  std::string expected;
  for (const std::size_t size : { 3U, 5000000U, 7U, 1048576U, 1048575U, 2U })
  {
    const std::string piece(size, static_cast<char>('a' + size % 26));
    file.write(piece);
    expected += piece;
  }
  file.commit();
  EXPECT_TRUE(contentOf(folder.file("out")) == expected);
}

TEST(FourBytes, RefuseWhatDoesNotFit)
{
  EXPECT_EQ(scan::fourBytes(0xfffffffeU, "too large"), 0xfffffffeU);
  for (const std::uint64_t number : { std::uint64_t{ 0xffffffffU }, std::uint64_t{ 1 } << 40U })
  {
    try
    {
      scan::fourBytes(number, "x.glb: more than 4 GiB");
      FAIL() << number;
    }
    catch (const scan::Error& error)
    {
      EXPECT_EQ(error.code(), scan::ErrorCode::limit);
      EXPECT_STREQ(error.what(), "x.glb: more than 4 GiB; decimate, or write PLY");
    }
  }
}
