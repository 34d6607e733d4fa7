// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/region_rule.h"

#include "filters/base/error.h"
#include "tests/geometry/complex_corpus.h"
#include "tests/geometry/random_rules.h"

#include <gtest/gtest.h>

#include <string>

using namespace scan;
using Kind = RegionRule::Kind;

namespace
{

std::string canonical(std::string_view text, const RegionNames& names = {})
{
  return textOf(parseRegionRule(text, names));
}

std::string errorOf(std::string_view text, const RegionNames& names = {})
{
  try
  {
    parseRegionRule(text, names);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::badParameter);
    return error.what();
  }
  return "no error";
}

TEST(RegionRule, ReadsEveryFunction)
{
  for (const std::string text :
    { "all", "none", "box(0,0,0,1,2,3)", "sphere(1,2,3,0.5mm)", "plane(0,0,0,0,1,0)",
      "brush(3x,1,2,3)", "brush(1%,1,2,3,4,5,6)", "rectangle(front,0,0,1,1)",
      "polygon(top,0,0,1,0,0,1)", "polygon(from(0,-9,0,0,0,0,0,0,1),0,0,1,0,0,1,-0.5,0.5)",
      "depth(along(0,1,0,0,0,1),1,2,3)", "component(1,2,-3)", "component(box(0,0,0,1,1,1))",
      "component(!all)", "component((all + none) & all)", "curvature(0.5,inf)",
      "deviation(-1e-06,0.1)", "array(Size_2,-inf,4)", "grow(all,2)", "shrink(none,0)",
      "points(4,2,4294967294)", "triangles(0)" })
  {
    EXPECT_EQ(canonical(text), text);
  }
}

TEST(RegionRule, BlanksAreFree)
{
  EXPECT_EQ(canonical(" box ( 0 ,0,0,\t1,1 , 1 )\n& ! sphere(0,0,0, 2mm )"),
    "box(0,0,0,1,1,1) & !sphere(0,0,0,2mm)");
}

TEST(RegionRule, OperatorsBindAsUsual)
{
  EXPECT_EQ(canonical("all+none&all - none"), "all + none & all - none");
  const RegionRule rule = parseRegionRule("all + none & all - none");
  EXPECT_EQ(rule.kind, Kind::without);
  EXPECT_EQ(rule.parts.at(0).kind, Kind::either);
  EXPECT_EQ(rule.parts.at(0).parts.at(1).kind, Kind::both);
  EXPECT_EQ(canonical("(all + none) & !(all & none)"), "(all + none) & !(all & none)");
  EXPECT_EQ(canonical("all - (none - all)"), "all - (none - all)");
  EXPECT_EQ(canonical("((all - none)) - all"), "all - none - all");
  EXPECT_EQ(parseRegionRule("!all & none").kind, Kind::both);
  EXPECT_EQ(canonical("!!all"), "!!all");
}

TEST(RegionRule, DeviationIsTheArrayOfThatName)
{
  EXPECT_EQ(parseRegionRule("deviation(0,1)"), parseRegionRule("array(Deviation,0,1)"));
}

TEST(RegionRule, NamesStandForTheirWholeRule)
{
  const RegionNames names{ { "near-wall", parseRegionRule("all - none") },
    { "b2", parseRegionRule("none") } };
  EXPECT_EQ(canonical("near-wall & b2", names), "(all - none) & none");
  EXPECT_EQ(canonical("near-wall - b2", names), "all - none - none");
  EXPECT_EQ(errorOf("top & b2", names),
    "region: character 1: expected a function or one of the regions b2, near-wall, found "
    "'top & b2'");
  EXPECT_EQ(errorOf("top"),
    "region: character 1: expected a function, the model has no regions yet, found 'top'");
  EXPECT_NE(errorOf("b2-b2", names).find("a minus sign has blanks around it"), std::string::npos);
}

TEST(RegionRule, IsCheckedBeforeItsNamesAreKnown)
{
  EXPECT_NO_THROW(checkRegionRule("near & !grow(far, 2)"));
  EXPECT_THROW(checkRegionRule("near & !grow(far)"), Error);
}

TEST(RegionRule, ErrorsTellThePlaceAndWhatIsExpected)
{
  EXPECT_EQ(errorOf(""),
    "region: character 1: expected a name or a function such as "
    "box(x,y,z, x,y,z), found the end");
  EXPECT_EQ(errorOf("box(0,0,0,1,1)"),
    "region: character 14: expected ',' of box(x,y,z, x,y,z), found ')'");
  EXPECT_EQ(errorOf("all & sphere(0,0,nan,1)"),
    "region: character 18: expected a number from -1e50 to 1e50 for sphere(x,y,z, r), found "
    "'nan,1)'");
  EXPECT_EQ(errorOf("sphere(0,0,0,-1)"),
    "region: character 14: expected a length such as 0.5, 2mm, 1% or 3x for r of "
    "sphere(x,y,z, r), found '-1)'");
  EXPECT_EQ(errorOf("(all"),
    "region: character 5: expected an operator (& + -) or ')', found "
    "the end");
  EXPECT_EQ(errorOf("all all"),
    "region: character 5: expected an operator (& + -) or the end, found 'all'");
  EXPECT_EQ(errorOf(std::string("all\0\n", 5)),
    "region: character 4: expected an operator (& + -) or the end, found '\?\?'");
  for (const char* const text : { "grow(all,-1)", "grow(all,1.5)", "grow(all,1e7)", "points(-1)",
         "points(4294967295)", "curvature(2,1)", "curvature(nan,1)", "box(inf,0,0,1,1,1)",
         "plane(0,0,0,0,0,0)", "rectangle(iso,0,0,1,1)", "rectangle(along(0,0,1,0,0,2),0,0,1,1)",
         "depth(from(0,0,0,0,0,0,0,0,1),1,2,3)", "polygon(front,0,0,1,1)",
         "polygon(front,0,0,1,1,2,2,3)", "brush(1,0,0,0,1)", "box", "all()", "a", "&", "!", "()",
         "component()", "component", "array(,0,1)", "1", "all &", "rectangle(1,0,0,1,1)" })
  {
    EXPECT_NE(errorOf(text).find("region: character "), std::string::npos) << text;
  }
}

TEST(RegionRule, DeepAndHugeTextsAreRefused)
{
  const auto repeated = [](const std::string& text, int count)
  {
    std::string result;
    for (int i = 0; i < count; ++i)
    {
      result += text;
    }
    return result;
  };
  EXPECT_NE(errorOf(repeated("(", 1000000)).find("fewer functions"), std::string::npos);
  EXPECT_NE(errorOf(repeated("!", 1000000)).find("fewer functions"), std::string::npos);
  EXPECT_NE(errorOf(repeated("grow(", 1000000)).find("fewer functions"), std::string::npos);
  EXPECT_NE(errorOf(repeated("all+", 20000) + "all").find("no more than"), std::string::npos);
  EXPECT_EQ(parseRegionRule(repeated("all+", 5000) + "all").parts.size(), 5001U);

  RegionNames names{ { "a", parseRegionRule("all & none") } };
  std::string error = "no error";
  for (int i = 0; i < 20 && error == "no error"; ++i) // doubles every time
  {
    error = errorOf("a + (a)", names);
    names["a"] = error == "no error" ? parseRegionRule("!(a - (a))", names) : RegionRule();
  }
  EXPECT_NE(error.find("no more than 10000 functions"), std::string::npos) << error;
  RegionNames deep{ { "a", parseRegionRule("all") } };
  error = "no error";
  for (int i = 0; i < 200 && error == "no error"; ++i)
  {
    deep["a"] = parseRegionRule("!a", deep);
    error = errorOf("!!a", deep);
  }
  EXPECT_NE(error.find("fewer functions"), std::string::npos) << error;
}

TEST(RegionRule, RandomRulesSurviveTheirText)
{
  const std::uint64_t seed = test::testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < 2000; ++i)
  {
    const std::string text = test::randomRule(random, 4);
    const RegionRule rule = parseRegionRule(text);
    ASSERT_EQ(parseRegionRule(textOf(rule)), rule) << text << "\n" << textOf(rule);
    ASSERT_EQ(canonical(textOf(rule)), textOf(rule)) << text;
  }
}

TEST(RegionRule, DamagedTextsAreRulesOrErrors)
{
  const std::uint64_t seed = test::testSeed();
  SCOPED_TRACE("SCAN_TEST_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < 5000; ++i)
  {
    std::string text = test::randomRule(random, 3);
    for (unsigned change = 0; change <= random() % 3; ++change)
    {
      text[random() % text.size()] = "()!&+-,.0a \n"[random() % 12];
    }
    const std::string error = errorOf(text);
    ASSERT_TRUE(error == "no error" || error.starts_with("region: character ")) << text;
    ASSERT_EQ(error.find('\n'), std::string::npos);
  }
}

TEST(RegionRule, NamesAreNoFunctions)
{
  for (const char* const name : { "a", "near-wall", "B_2", "front" })
  {
    EXPECT_TRUE(isRegionName(name)) << name;
  }
  for (const char* const name : { "", "1a", "-a", "all", "box", "component", "a b", "a(" })
  {
    EXPECT_FALSE(isRegionName(name)) << name;
  }
}

} // namespace
