// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/document.h"

#include "filters/base/error.h"
#include "pipeline/comparison.h"
#include "pipeline/history_text.h"
#include "tests/pipeline/document_fixtures.h"

#include <fstream>

using namespace scan;

namespace
{

using State = vtkScanOutcome::State;

std::int64_t numberIn(const Results& results, const std::string& name)
{
  for (const auto& [key, value] : results)
  {
    if (key == name)
    {
      return std::get<std::int64_t>(value);
    }
  }
  ADD_FAILURE() << "there is no " << name;
  return 0;
}

} // namespace

TEST(Document, RecordsWhatWasDone)
{
  Document document;
  openPlate(document);
  ASSERT_EQ(document.steps().size(), 3U);
  EXPECT_EQ(document.current(), 3);
  const Step& open = document.step(1);
  EXPECT_EQ(open.verb, "open");
  ASSERT_EQ(open.files.size(), 1U);
  EXPECT_EQ(open.files[0].path, sampleFile("plate_hole.xyz"));
  EXPECT_EQ(open.files[0].format, "points as text");
  EXPECT_EQ(open.files[0].bytes,
    static_cast<std::int64_t>(std::filesystem::file_size(sampleFile("plate_hole.xyz"))));
  EXPECT_EQ(open.files[0].hash, textOf(hashOfFile(sampleFile("plate_hole.xyz"))));
  const Step& push = document.step(3);
  EXPECT_EQ(push.parent, 2);
  EXPECT_EQ(push.parameters.at("deep"), "true");
  EXPECT_EQ(push.parameters.at("reach"), "1.5");
  EXPECT_EQ(push.inputHash, document.step(2).resultHash);
  EXPECT_NE(push.inputHash, push.resultHash);
  EXPECT_EQ(numberIn(push.results, "output-triangles"), 9908);
  EXPECT_GT(push.seconds, 0.0);
  EXPECT_GT(push.peakBytes, 0);
  EXPECT_EQ(commandOf(push), "push --at=0,0,0 --deep");
}

TEST(Document, AFailedOrCancelledStepLeavesEverythingAsItWas)
{
  const std::string path = testFolder() + "/a.wrp";
  Document document = Document::create(path);
  openPlate(document);
  const auto before = dumpOf(document, 3);
  EXPECT_EQ(apply(document, "push", { { "block", "-77777777" } }).outcome.state, State::failed);
  RunOptions cancelled;
  cancelled.token.cancel();
  EXPECT_EQ(document.apply(*findOperation("wrap"), {}, cancelled).outcome.state, State::cancelled);
  EXPECT_EQ(document.steps().size(), 3U);
  EXPECT_EQ(document.current(), 3);
  EXPECT_EQ(dumpOf(document, 3), before);
}

TEST(Document, AnalysisAndPreviewAreNoSteps)
{
  Document document;
  openPlate(document);
  expectOk(apply(document, "info"));
  expectOk(apply(document, "pull", { { "at", "0,0,0" }, { "preview", "true" } }));
  EXPECT_EQ(document.steps().size(), 3U);
}

TEST(Document, BranchesWhereOneGoesBack)
{
  Document document;
  openPlate(document);
  document.goTo(2);
  expectOk(apply(document, "flatten"));
  EXPECT_EQ(document.current(), 4);
  EXPECT_EQ(document.step(4).parent, 2);
  EXPECT_EQ(document.pathTo(4), (std::vector<StepId>{ 1, 2, 4 }));
  EXPECT_EQ(document.branchFrom(2), (std::vector<StepId>{ 2, 3, 4 }));
  EXPECT_EQ(document.branchFrom(3), (std::vector<StepId>{ 3 }));
  EXPECT_EQ(historyText(document).substr(0, 4), "  1 ");
}

TEST(Document, EditDoesAgainWhatFollows)
{
  Document document;
  openPlate(document);
  expectOk(apply(document, "repair-angles"));
  const Replay replay = document.edit(3, { { "deep", "false" } }, {});
  ASSERT_EQ(replay.entries.size(), 2U);
  EXPECT_EQ(replay.entries[0].to, 5);
  EXPECT_EQ(replay.entries[1].to, 6);
  EXPECT_EQ(document.current(), 6); // the counterpart of repair-angles
  EXPECT_EQ(document.step(5).parent, 2);
  EXPECT_EQ(document.step(5).parameters.at("deep"), "false");
  EXPECT_EQ(document.step(5).parameters.at("at"), "0,0,0");

  // the same as when it is done by hand
  document.goTo(2);
  expectOk(apply(document, "push", { { "at", "0,0,0" } }));
  expectOk(apply(document, "repair-angles"));
  EXPECT_EQ(document.step(8).resultHash, document.step(6).resultHash);
}

TEST(Document, EditOfTheFilesReplaysOnAnotherScan)
{
  Document document;
  openPlate(document);
  const Replay replay = document.edit(1, { { "files", sampleFile("torus.xyz") } }, {});
  EXPECT_EQ(replay.outcome.state, State::ok) << replay.outcome.message;
  EXPECT_EQ(numberIn(document.step(5).results, "output-triangles"), 10002 - 2 * 3 + 6)
    << "the torus, classic";
  EXPECT_EQ(document.step(4).files[0].path, sampleFile("torus.xyz"));
}

TEST(Document, EditTellsWhatFailed)
{
  Document document;
  expectOk(import(document, { sampleFile("plate_hole.xyz") }));
  expectOk(apply(document, "wrap", { { "mode", "classic" } }));
  expectOk(apply(document, "push", { { "triangle", "9200" } }));
  expectOk(apply(document, "flatten"));
  const Replay replay = document.edit(1, { { "files", sampleFile("helix.xyz") } }, {});
  ASSERT_EQ(replay.entries.size(), 4U);
  EXPECT_NE(replay.entries[1].to, 0);
  EXPECT_EQ(replay.entries[2].to, 0);
  EXPECT_NE(replay.entries[2].message.find("there is no triangle 9200"), std::string::npos);
  EXPECT_EQ(replay.entries[3].to, 0);
  EXPECT_EQ(replay.outcome.state, State::failed);
  EXPECT_THROW(document.edit(2, { { "nonsense", "1" } }, {}), Error);
  EXPECT_THROW(document.edit(2, { { "mode", "nonsense" } }, {}), Error);
  EXPECT_EQ(document.steps().size(), 6U);
}

TEST(Document, NamesAreUniqueAndNoNumbers)
{
  Document document;
  openPlate(document);
  document.setName(2, "start");
  EXPECT_EQ(document.find("start").id, 2);
  EXPECT_EQ(document.find("3").id, 3);
  EXPECT_THROW(document.setName(3, "start"), Error);
  EXPECT_THROW(document.setName(3, "7"), Error);
  EXPECT_THROW(document.find("end"), Error);
  EXPECT_THROW(document.find("9"), Error);
  EXPECT_THROW(document.find(""), Error);
  document.setName(2, "");
  EXPECT_THROW(document.find("start"), Error);
}

TEST(Document, DeletesABranch)
{
  const std::string path = testFolder() + "/a.wrp";
  {
    Document document = Document::create(path);
    openPlate(document);
    document.goTo(2);
    expectOk(apply(document, "flatten"));
    document.goTo(3);
    document.removeBranch(3);
    EXPECT_EQ(document.current(), 2);
    EXPECT_EQ(document.steps().size(), 3U);
    EXPECT_THROW(document.step(3), Error);
    expectOk(apply(document, "flatten")); // its number is not given again
    EXPECT_EQ(document.current(), 5);
  }
  Document again = Document::open(path);
  EXPECT_EQ(again.steps().size(), 4U);
  EXPECT_TRUE(again.verify({}).empty());
  const auto before = std::filesystem::file_size(path);
  again.removeBranch(1);
  EXPECT_EQ(again.current(), 0);
  EXPECT_TRUE(again.steps().empty());
  EXPECT_LT(std::filesystem::file_size(path), before / 2) << "room is given back";
}

TEST(Document, GoesOnWhereItWasLeft)
{
  const std::string path = testFolder() + "/a.wrp";
  std::vector<Hash> dumps;
  std::string list;
  {
    Document document = Document::create(path);
    openPlate(document);
    document.setName(2, "start");
    document.goTo(2);
    for (const StepId step : { 1, 2, 3 })
    {
      dumps.push_back(dumpOf(document, step));
    }
    list = historyText(document);
  }
  Document document = Document::open(path);
  EXPECT_EQ(document.current(), 2);
  EXPECT_EQ(historyText(document), list);
  EXPECT_EQ(document.find("start").id, 2);
  for (const StepId step : { 3, 1, 2 })
  {
    EXPECT_EQ(dumpOf(document, step), dumps[static_cast<std::size_t>(step - 1)]) << step;
  }
  EXPECT_EQ(stepText(document.step(3)).substr(0, 4), "step");
}

TEST(Document, ResultsOutOfMemoryAreDoneAgain)
{
  Document document; // without a file, and only the current result is held
  openPlate(document);
  const auto last = dumpOf(document, 3);
  document.goTo(1);
  EXPECT_EQ(dumpOf(document, 3), last);
}

TEST(Document, SaysWhenAFileHasChangedSince)
{
  const std::string folder = testFolder();
  const std::string file = folder + "/a.xyz";
  std::filesystem::copy_file(sampleFile("torus.xyz"), file);
  Document document;
  expectOk(import(document, { file }));
  expectOk(apply(document, "wrap"));
  std::ofstream(file, std::ios::app) << "1 2 3\n";
  try
  {
    document.result(1, {});
    FAIL() << "the other points were taken";
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find("has changed"), std::string::npos) << error.what();
  }
  EXPECT_EQ(document.verify({}).size(), 2U);
}

TEST(Document, RemembersFilesThatAreMerged)
{
  const std::string folder = testFolder();
  const std::string file = folder + "/a.xyz";
  std::filesystem::copy_file(sampleFile("helix.xyz"), file);
  Document document;
  expectOk(import(document, { sampleFile("torus.xyz") }));
  expectOk(apply(document, "merge", { { "file", file } }));
  ASSERT_EQ(document.step(2).files.size(), 1U);
  EXPECT_EQ(document.step(2).files[0].hash, textOf(hashOfFile(file)));
  EXPECT_TRUE(document.verify({}).empty());
  std::ofstream(file, std::ios::app) << "1 2 3\n";
  EXPECT_EQ(document.verify({}).size(), 1U);
}

TEST(Document, ResultsShareMemoryUnderTheBudget)
{
  Document document(std::int64_t{ 1 } << 30U);
  openPlate(document);
  const auto a = document.result(2, {});
  EXPECT_EQ(a, document.result(2, {})) << "is held";
  const auto* const first = vtkScanWrapData::SafeDownCast(a);
  const auto* const second = vtkScanWrapData::SafeDownCast(document.result(3, {}));
  EXPECT_EQ(first->GetModel().scan, second->GetModel().scan);
}

TEST(Document, ResultsFromAFileShareTheirComplex)
{
  const std::string path = testFolder() + "/a.wrp";
  {
    Document document = Document::create(path);
    openPlate(document);
  }
  Document document = Document::open(path, std::int64_t{ 1 } << 30U);
  const auto a = document.result(2, {});
  const auto b = document.result(3, {});
  EXPECT_EQ(vtkScanWrapData::SafeDownCast(a)->GetModel().scan,
    vtkScanWrapData::SafeDownCast(b)->GetModel().scan);
}

TEST(Comparison, TellsWhatIsDifferent)
{
  Document document = Document::create(testFolder() + "/a.wrp");
  openPlate(document);
  document.goTo(2);
  expectOk(apply(document, "push", { { "at", "0,0,0" }, { "deep", "true" } }));
  Comparison same = compare(document, 3, 4, {});
  EXPECT_TRUE(same.isSame);
  EXPECT_EQ(same.common, 2);
  EXPECT_EQ(same.onlyA, (std::vector<StepId>{ 3 }));
  EXPECT_EQ(same.onlyB, (std::vector<StepId>{ 4 }));
  const Comparison other = compare(document, 2, 4, {});
  EXPECT_FALSE(other.isSame);
  EXPECT_EQ(numberIn(other.measures, "triangles-a"), 9238);
  EXPECT_EQ(numberIn(other.measures, "triangles-b"), 9908);
  EXPECT_EQ(numberIn(other.measures, "triangles-new") - numberIn(other.measures, "triangles-gone"),
    9908 - 9238);
}

TEST(Comparison, MeasuresTheDistance)
{
  const std::string folder = testFolder();
  std::ofstream(folder + "/a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(folder + "/b.obj") << "v 0 0 0.5\nv 1 0 0.5\nv 0 1 0.5\nf 1 2 3\n";
  Document document;
  expectOk(import(document, { folder + "/a.obj" }));
  expectOk(import(document, { folder + "/b.obj" }));
  const Comparison found = compare(document, 1, 2, {});
  EXPECT_EQ(found.common, 0);
  for (const auto& [name, value] : found.measures)
  {
    if (name.find("deviation") != std::string::npos)
    {
      EXPECT_DOUBLE_EQ(std::get<double>(value), 0.5) << name;
    }
  }
}
