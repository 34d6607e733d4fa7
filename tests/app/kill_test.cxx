// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/pipeline/document_fixtures.h"
#include "tests/pipeline/integrity.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <optional>
#include <random>
#include <set>
#include <thread>

using namespace scan;

namespace
{

using Seconds = std::chrono::duration<double>;

/// Runs the program on a long script that makes a project; kills it after a while.
/// @return how many operations it said were done
int runScript(const std::string& project, std::optional<Seconds> killAfter)
{
  std::vector<std::string> words = { SCAN_PROGRAM, sampleFile("plate_hole.xyz"), "--verbose",
    "--overwrite", "--threads=1", "-o", project, "wrap", "--mode=classic" };
  for (int i = 0; i < 8; ++i)
  {
    const std::string at = "--at=" + std::to_string(0.1 * (i % 4)) + ",0," + std::to_string(i % 2);
    words.insert(words.end(), { "push", at, "fine-tune", at, "pull", at });
  }
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  std::array<int, 2> pipe{};
  EXPECT_EQ(::pipe(pipe.data()), 0);
  const ::pid_t child = ::fork();
  if (child == 0)
  {
    ::dup2(pipe[1], STDERR_FILENO);
    ::close(pipe[0]);
    ::execv(SCAN_PROGRAM, arguments.data());
    ::_exit(127);
  }
  ::close(pipe[1]);
  std::thread killer;
  if (killAfter)
  {
    killer = std::thread(
      [&]
      {
        std::this_thread::sleep_for(*killAfter);
        ::kill(child, SIGKILL); // the child is waited for below only
      });
  }
  std::string said;
  std::array<char, 4096> buffer{};
  for (::ssize_t size = 0; (size = ::read(pipe[0], buffer.data(), buffer.size())) > 0;)
  {
    said.append(buffer.data(), static_cast<std::size_t>(size));
  }
  ::close(pipe[0]);
  if (killer.joinable())
  {
    killer.join();
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(killAfter || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) << said;
  int done = 0;
  for (const char* const verb : { "wrap: ", "push: ", "fine-tune: ", "pull: " })
  {
    const std::string start = std::string("\n") + verb;
    for (std::size_t at = 0; (at = said.find(start, at)) != std::string::npos; ++at)
    {
      ++done;
    }
  }
  return done;
}

} // namespace

TEST(Kill, TwoHundredTimesCostsTheRunningStepOnly)
{
  const std::string folder = testFolder();
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(runScript(folder + "/whole.wrp", std::nullopt), 25);
  const Seconds whole = std::chrono::steady_clock::now() - start;
  const std::vector<Step> wanted = Document::open(folder + "/whole.wrp").steps();
  ASSERT_EQ(wanted.size(), 26U);

  std::mt19937 random(1);
  std::set<std::size_t> lengths;
  int interrupted = 0;
  for (int run = 0; run < 200; ++run)
  {
    const std::string path = folder + "/killed.wrp";
    std::filesystem::remove(path);
    std::filesystem::remove(path + "-journal");
    const Seconds moment = whole * (std::uniform_real_distribution<double>(0, 1)(random));
    SCOPED_TRACE("killed after " + std::to_string(moment.count()) + " s");
    const int told = runScript(path, moment);
    if (!std::filesystem::exists(path))
    {
      EXPECT_EQ(told, 0);
      continue;
    }
    interrupted += std::filesystem::exists(path + "-journal") ? 1 : 0;
    EXPECT_EQ(integrityOf(path), "ok");
    Document document = Document::open(path);
    const std::size_t steps = document.steps().size();
    lengths.insert(steps);
    EXPECT_GE(steps, told > 0 ? static_cast<std::size_t>(told) + 1 : 0);
    EXPECT_LE(steps, static_cast<std::size_t>(told) + 2);
    for (const Step& step : document.steps())
    {
      EXPECT_EQ(step.resultHash, wanted[static_cast<std::size_t>(step.id) - 1].resultHash);
    }
    Execution execution;
    EXPECT_TRUE(document.project()->findDamage(execution).empty());
  }
  EXPECT_GT(lengths.size(), 12U) << "the moments are not spread over the script";
  std::cout << interrupted << " of 200 left a write unfinished\n";
}
