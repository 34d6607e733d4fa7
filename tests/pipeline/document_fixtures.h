// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document.h"
#include "tests/pipeline/data_dump.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

/// A folder that the test has for itself, empty at first.
inline std::string testFolder()
{
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) /
    (std::string("scan_") + test->test_suite_name() + "_" + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder.string();
}

inline std::string sampleFile(const std::string& name)
{
  return std::string(SCAN_DATA_DIR) + "/" + name;
}

inline void expectOk(const scan::StepResult& step)
{
  EXPECT_EQ(step.outcome.state, vtkScanOutcome::State::ok) << step.outcome.message;
}

inline scan::StepResult import(scan::Document& document, const std::vector<std::string>& files)
{
  return document.import(
    scan::completeValues(scan::openParameters(), { { "files", files } }, "open"), {}, nullptr);
}

inline scan::StepResult apply(
  scan::Document& document, const std::string& verb, const scan::ParameterTexts& parameters = {})
{
  return document.apply(
    *scan::findOperation(verb), scan::parseValues(verb, parameters), scan::RunOptions());
}

/// The plate, wrapped, and its hole opened: steps 1 to 3.
inline void openPlate(scan::Document& document)
{
  expectOk(import(document, { sampleFile("plate_hole.xyz") }));
  expectOk(apply(document, "wrap", { { "mode", "classic" } }));
  expectOk(apply(document, "push", { { "at", "0,0,0" }, { "deep", "true" } }));
}

inline scan::Hash dumpOf(scan::Document& document, scan::StepId step)
{
  return DataDump(*document.result(step, {})).hash();
}
