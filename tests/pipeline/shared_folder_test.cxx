// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every real file opens, or is refused with one line that names it and the reason; bad ones without
// taking much memory or time.
#include "filters/base/error.h"
#include "tests/pipeline/format_files.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <map>
#include <vector>

using namespace scan;
using namespace scan::test;

namespace
{

const std::filesystem::path kFolder = SCAN_SHARED_DIR "/data";
constexpr long kFreeKilobytes = 64L << 10U;
constexpr long kMemoryPerByte = 20;
constexpr unsigned kMostSeconds = 60;

/// What is refused, and why; by the end of the name, which may be the extension alone.
const std::map<std::string, std::string>& refusals()
{
  static const std::map<std::string, std::string> kRefusals = {
    // what is no model
    { "README", "the content is of no known format" },
    { ".md", "the content is of no known format" },
    { ".plist", "the content is of no known format" },
    { "readme.txt", "expected x y z" },
    { "bun.conf", "is a list that places scans; give it with --transforms" },
    // other formats
    { ".laz", "compressed (LAZ)" },
    { ".e57", "is an E57 scan" },
    { ".wrl", "is a VRML scene" },
    { ".dxf", "is a DXF drawing" },
    { ".mesh", "is a Medit mesh" },
    { ".vtu", "is a VTK file of 'UnstructuredGrid'" },
    { ".m", "is a mesh of Hoppe's programs" },
    { ".facet", "is a VTK facet file" },
    { ".g", "is a Movie.BYU mesh" },
    { ".raw", "is a list of triangles" },
    { ".gz", "gunzip" },
    { ".xz", "unxz" },
    { ".brep", "is an OpenCASCADE shape" },
    { "skull.pts", "line 917: expected x y z" }, // damaged contours
    // bad files
    { "OutOfMemory.off", "more than the file can hold" },
    { "box_UTF16BE.obj", "UTF-16" },
    { "crash-30d6d0f7c529b3b66b4131700b7a4580cd7082df.ply", "does not end with 'end_header'" },
    { "assimp/empty.obj", "is empty" },
    { "assimp/empty.off", "is empty" },
    { "assimp/empty.ply", "is empty" },
    { "invalid.off", "line 7: expected a corner of a face" },
    { "issue623.ply", "line 15: expected an integer" },
    { "malformed.obj", "refers to vertex 0" },
    { "malformed2.obj", "line 23: a face without corners" },
    { "number_formats.obj", "line 11: expected three coordinates, found '3.1+e2'" },
    { "float_inf_point_cloud.ply", "3 of 16 points" },
    { "inf_nan.obj", "3 of 3 points" },
    { "garbage_nVariableLength.las", "it is truncated" },
    { "no-points.las", "has no points" },
    { "empty.stl", "no facet found" },
  };
  return kRefusals;
}

std::vector<std::string> filesIn(const std::filesystem::path& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
  {
    const bool isModel = entry.is_regular_file() && entry.path().parent_path() != kFolder &&
      entry.path().parent_path() != kFolder / "LICENCES";
    if (isModel)
    {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

/// The message that the file ends in, or nothing when it opens.
std::string messageOf(const std::string& path)
{
  try
  {
    EXPECT_FALSE(readFile(path).points.empty()) << path;
    return {};
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
}

std::string expectedMessage(const std::string& path)
{
  const auto found = std::ranges::find_if(
    refusals(), [&](const auto& refusal) { return path.ends_with(refusal.first); });
  return found != refusals().end() ? found->second : "";
}

/// How a copy of this process ends that does the work, and its largest resident memory, its own and
/// that of processes it starts, in kilobytes.
std::pair<int, long> runInCopy(const std::function<void()>& work)
{
  const pid_t copy = ::fork();
  if (copy == 0)
  {
    ::alarm(kMostSeconds);
    work();
    ::_exit(0);
  }
  int status = 0;
  rusage usage = {};
  EXPECT_EQ(::wait4(copy, &status, 0, &usage), copy);
  return { status, usage.ru_maxrss };
}

} // namespace

TEST(SharedFolder, OpensOrIsRefusedWithTheReason)
{
  if (!std::filesystem::exists(kFolder))
  {
    GTEST_SKIP() << kFolder << " is missing";
  }
  std::size_t opened = 0;
  for (const std::string& path : filesIn(kFolder))
  {
    const std::string message = messageOf(path);
    const std::string expected = expectedMessage(path);
    EXPECT_EQ(message.empty(), expected.empty()) << path << ": " << message;
    EXPECT_NE(message.find(expected), std::string::npos) << message;
    EXPECT_TRUE(message.empty() || message.starts_with(path + ": ")) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    opened += message.empty() ? 1 : 0;
  }
  EXPECT_GT(opened, 100U);
}

TEST(SharedFolder, BadFilesTakeLittleMemoryAndTime)
{
  if (!std::filesystem::exists(kFolder / "09_bad"))
  {
    GTEST_SKIP() << kFolder / "09_bad"
                 << " is missing";
  }
  const long before = runInCopy([] {}).second;
  for (const std::string& path : filesIn(kFolder / "09_bad"))
  {
    const auto [status, kilobytes] = runInCopy([&] { messageOf(path); });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << path << " ends in " << status;
    const auto size = static_cast<long>(std::filesystem::file_size(path));
    EXPECT_LE(kilobytes - before, kMemoryPerByte * size / 1024 + kFreeKilobytes) << path;
    RecordProperty(std::filesystem::path(path).filename(), std::to_string(kilobytes - before));
  }
}
