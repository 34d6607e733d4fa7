// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometry/complex_corpus.h"
#include "tests/pipeline/document_fixtures.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "pipeline/history_text.h"

#include <algorithm>
#include <map>
#include <optional>
#include <random>

using namespace scan;
using scan::test::testSeed;

namespace
{

using State = vtkScanOutcome::State;

/// A user without a plan: any operation of the table with any parameters, any jump, any edit.
class RandomUser
{
public:
  RandomUser(std::string path, std::uint64_t seed)
    : Path(std::move(path))
    , Random(seed)
    , Doc(Document::create(this->Path, std::int64_t{ 20 } << 20U))
  {
    for (const char* const sample : { "plate_hole.xyz", "helix.xyz", "torus.xyz" })
    {
      expectOk(import(this->Doc, { sampleFile(sample) }));
      this->remember();
    }
  }

  void act()
  {
    const unsigned dice = this->below(20);
    if (dice < 12)
    {
      this->operate();
    }
    else if (dice < 16)
    {
      this->jump();
    }
    else if (dice < 18)
    {
      this->edit();
    }
    else if (dice < 19)
    {
      this->remove();
    }
    else
    {
      this->reopen();
    }
    this->expectAsFirstReached(this->Doc.current());
  }

  void reopen()
  {
    const StepId current = this->Doc.current();
    const std::size_t steps = this->Doc.steps().size();
    this->Doc = Document();
    this->Doc = Document::open(this->Path, std::int64_t{ 20 } << 20U);
    EXPECT_EQ(this->Doc.current(), current);
    EXPECT_EQ(this->Doc.steps().size(), steps);
  }

  void expectAllAsFirstReached()
  {
    for (const Step& step : this->Doc.steps())
    {
      this->expectAsFirstReached(step.id);
    }
  }

  Document& document() { return this->Doc; }
  int operations() const { return this->Operations; }
  int branches() const
  {
    std::map<StepId, int> children;
    for (const Step& step : this->Doc.steps())
    {
      ++children[step.parent];
    }
    return static_cast<int>(
      std::ranges::count_if(children, [](const auto& entry) { return entry.second > 1; }));
  }

private:
  unsigned below(std::size_t end)
  {
    return std::uniform_int_distribution<unsigned>(0, static_cast<unsigned>(end) - 1)(this->Random);
  }

  StepId anyStep() { return this->Doc.steps()[this->below(this->Doc.steps().size())].id; }

  void remember()
  {
    const StepId step = this->Doc.current();
    this->Reached[step] = { DataDump(*this->Doc.result(step, {})).hash(),
      this->Doc.step(step).resultHash };
  }

  void expectAsFirstReached(StepId step)
  {
    EXPECT_EQ(dumpOf(this->Doc, step), this->Reached.at(step).first) << "step " << step;
    EXPECT_EQ(this->Doc.step(step).resultHash, this->Reached.at(step).second) << "step " << step;
  }

  ParameterValue anyValue(const Parameter& parameter, vtkPolyData& model)
  {
    const ParameterValue& value = parameter.defaultValue;
    const double least = std::max(parameter.minimum, 0.0);
    const double some = std::min(parameter.maximum, least + 5.0 * (this->below(1000) / 1000.0));
    const auto anyPoint = [&]
    {
      const std::vector<Vec3> points = bridge::pointsOf(model);
      return points.empty() ? Vec3() : points[this->below(points.size())];
    };
    return std::holds_alternative<bool>(value) ? ParameterValue(this->below(2) == 0)
      : std::holds_alternative<std::int64_t>(value)
      ? ParameterValue(static_cast<std::int64_t>(some + 1))
      : std::holds_alternative<double>(value) ? ParameterValue(some)
      : std::holds_alternative<Length>(value) ? ParameterValue(Length(some, Length::Unit::spacing))
      : std::holds_alternative<PointList>(value) ? ParameterValue(PointList{ anyPoint() })
      : std::holds_alternative<IdList>(value)    ? ParameterValue(IdList{ this->below(9000) })
      : !parameter.choices.empty()
      ? ParameterValue(parameter.choices[this->below(parameter.choices.size())])
      : parameter.name == "region" || parameter.name == "rule"
      ? ParameterValue(
          std::string(this->below(2) == 0 ? "plane(0,0,0, 0,1,0)" : "sphere(0.6,0,0, 0.5)"))
      : parameter.name == "name" ? ParameterValue(std::string("spot"))
                                 : value;
  }

  void operate()
  {
    const auto& table = operationTable();
    const Operation* operation = nullptr;
    while (operation == nullptr || operation->stage == Stage::analysis)
    {
      operation = &table[this->below(table.size())];
    }
    const auto model = this->Doc.result(this->Doc.current(), {});
    if (vtkScanWrapData::SafeDownCast(model) == nullptr && this->below(2) == 0)
    {
      operation = findOperation("wrap"); // else nearly all edits are refused
    }
    ParameterValues given;
    for (const Parameter& parameter : operation->parameters)
    {
      if (parameter.name != "preview" && this->below(3) == 0)
      {
        given[parameter.name] = this->anyValue(parameter, *model);
      }
      if (given.contains(parameter.name) && given[parameter.name] == ParameterValue("front"))
      {
        given.erase(parameter.name); // the library's, see front_wrap.h
      }
    }
    const StepId before = this->Doc.current();
    const StepResult step = this->Doc.apply(*operation, given, {});
    ++this->Operations;
    if (step.outcome.state == State::ok)
    {
      this->remember();
      ++this->Done[operation->verb];
    }
    else
    {
      EXPECT_NE(step.outcome.code, ErrorCode::internal)
        << operation->verb << ": " << step.outcome.message;
      EXPECT_EQ(this->Doc.current(), before);
    }
  }

  void jump() { this->Doc.goTo(this->anyStep()); }

  void edit()
  {
    const StepId id = this->anyStep();
    const Step step = this->Doc.step(id);
    if (step.parent == 0 || this->Doc.branchFrom(id).size() > 8)
    {
      return this->jump();
    }
    const auto& parameters = *parametersOf(step.verb);
    const Parameter& parameter = parameters[this->below(parameters.size())];
    const auto model = this->Doc.result(step.parent, {});
    const Replay replay =
      this->Doc.edit(id, { { parameter.name, textOf(this->anyValue(parameter, *model)) } }, {});
    ++this->Operations;
    const StepId current = this->Doc.current();
    for (const Replay::Entry& entry : replay.entries)
    {
      if (entry.to != 0)
      {
        this->Doc.goTo(entry.to);
        this->remember();
      }
    }
    this->Doc.goTo(current);
  }

  void remove()
  {
    const StepId id = this->anyStep();
    if (this->Doc.step(id).parent != 0 && this->Doc.branchFrom(id).size() < 5)
    {
      this->Doc.removeBranch(id);
    }
  }

  std::string Path;
  std::mt19937_64 Random;
  Document Doc;
  std::map<StepId, std::pair<Hash, std::string>> Reached;
  int Operations = 0;

public:
  std::map<std::string, int> Done;
};

} // namespace

TEST(Session, TwoHundredRandomOperationsAreReachedAgainByteForByte)
{
  const std::uint64_t seed = testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  const std::string path = testFolder() + "/session.wrp";
  RandomUser user(path, seed);
  while (user.operations() < 200)
  {
    user.act();
  }
  EXPECT_GE(user.branches(), 5);
  user.reopen();
  user.expectAllAsFirstReached();
  for (const auto& [step, reason] : user.document().verify({}))
  {
    ADD_FAILURE() << "step " << step << ", " << commandOf(user.document().step(step)) << ": "
                  << reason;
  }
  Execution execution;
  EXPECT_TRUE(user.document().project()->findDamage(execution).empty());
  for (const auto& [verb, count] : user.Done)
  {
    std::cout << verb << " " << count << "\n";
  }
}
