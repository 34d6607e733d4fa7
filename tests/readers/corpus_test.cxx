// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzzers have found stays found: each parser over its corpus, also cut and changed.
#include "readers/mapped_file.h"
#include "tests/fuzz/parser_table.h"
#include "tests/readers/damage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace scan::test
{

// GoogleTest finds it by its name
static void PrintTo(const FuzzedParser& parser, std::ostream* stream)
{
  *stream << parser.name;
}

} // namespace scan::test

namespace
{

using scan::test::FuzzedParser;

constexpr std::size_t kCut = 64;
constexpr std::size_t kFlip = 97;

/// A file of a corpus.
struct Sample
{
  std::string name;
  std::string bytes;
};

std::vector<Sample> samplesOf(const FuzzedParser& parser)
{
  std::vector<Sample> samples;
  const std::filesystem::path folder = SCAN_CORPUS_DIR;
  for (const auto& entry : std::filesystem::directory_iterator(folder / parser.name))
  {
    const scan::MappedFile file(entry.path());
    samples.push_back({ entry.path().filename(), { file.bytes().begin(), file.bytes().end() } });
  }
  return samples;
}

std::string nameOf(const testing::TestParamInfo<FuzzedParser>& info)
{
  return std::string(info.param.name);
}

class Corpus : public testing::TestWithParam<FuzzedParser>
{
protected:
  static void expectErrorOrModel(const std::string& bytes, const std::string& what)
  {
    GetParam().looksLike(bytes);
    scan::test::expectErrorOrModel(GetParam().parse, bytes, what);
  }
};

} // namespace

TEST_P(Corpus, EndsInErrorOrModel)
{
  const std::vector<Sample> samples = samplesOf(GetParam());
  EXPECT_FALSE(samples.empty());
  for (const Sample& sample : samples)
  {
    expectErrorOrModel(sample.bytes, sample.name);
  }
}

TEST_P(Corpus, EndsInErrorOrModelWhenCut)
{
  for (const Sample& sample : samplesOf(GetParam()))
  {
    for (std::size_t size = 0; size < sample.bytes.size(); size += kCut)
    {
      expectErrorOrModel(
        sample.bytes.substr(0, size), sample.name + " cut at " + std::to_string(size));
    }
  }
}

TEST_P(Corpus, EndsInErrorOrModelWhenAByteIsFlipped)
{
  for (Sample& sample : samplesOf(GetParam()))
  {
    for (std::size_t at = 0; at < sample.bytes.size(); at += kFlip)
    {
      sample.bytes[at] = static_cast<char>(~sample.bytes[at]);
      expectErrorOrModel(sample.bytes, sample.name + " flipped at " + std::to_string(at));
      sample.bytes[at] = static_cast<char>(~sample.bytes[at]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fuzzed, Corpus, testing::ValuesIn(scan::test::kFuzzedParsers), nameOf);
