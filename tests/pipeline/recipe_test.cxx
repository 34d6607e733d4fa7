// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/recipe.h"

#include "filters/base/error.h"
#include "tests/pipeline/document_fixtures.h"

using namespace scan;

namespace
{

std::string errorOf(const std::string& text)
{
  try
  {
    parseRecipe(text, "a.txt");
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Recipe, NamesWhatDiffersFromTheDefaults)
{
  Document document;
  openPlate(document);
  const std::string text = textOf(recipeOf(document, 3));
  EXPECT_NE(
    text.find("\nwrap\n  mode = classic\n\npush\n  at = 0,0,0\n  deep = true\n"), std::string::npos)
    << text;
  EXPECT_EQ(text.find("reach"), std::string::npos);
}

TEST(Recipe, LeadsToTheSameResult)
{
  Document document;
  openPlate(document);
  const Recipe recipe = parseRecipe(textOf(recipeOf(document, 3)), "a.txt");
  ASSERT_EQ(recipe.size(), 2U);
  Document other;
  expectOk(import(other, { sampleFile("plate_hole.xyz") }));
  for (const RecipeStep& step : recipe)
  {
    expectOk(other.apply(*step.operation, step.given, {}));
  }
  EXPECT_EQ(other.step(3).resultHash, document.step(3).resultHash);
}

TEST(Recipe, FollowsOneBranch)
{
  Document document;
  openPlate(document);
  document.goTo(2);
  expectOk(apply(document, "flatten"));
  const std::string text = textOf(recipeOf(document, 4));
  EXPECT_EQ(text.find("push"), std::string::npos);
  EXPECT_NE(text.find("flatten"), std::string::npos);
}

TEST(Recipe, MayBeWrittenByHand)
{
  const Recipe recipe =
    parseRecipe("# ours\n\nscanwrap template 1\r\nwrap\r\n\tmode=classic\n  # open it\npush\n"
                "  at = 0,0,0\n  at = 1,0,0.5\n  deep = true",
      "a.txt");
  ASSERT_EQ(recipe.size(), 2U);
  EXPECT_EQ(recipe[0].given.at("mode"), ParameterValue("classic"));
  EXPECT_EQ(recipe[1].given.at("at"), ParameterValue(PointList{ { 0, 0, 0 }, { 1, 0, 0.5 } }));
}

TEST(Recipe, SaysInWhichLineSomethingIsWrong)
{
  const std::string title = "scanwrap template 1\n";
  EXPECT_NE(errorOf("").find("empty"), std::string::npos);
  EXPECT_NE(errorOf("wrap\n").find("line 1: is no template"), std::string::npos);
  EXPECT_NE(errorOf("scanwrap template 9\n").find("newer"), std::string::npos);
  EXPECT_NE(
    errorOf(title + "warp\n").find("line 2: there is no operation 'warp'"), std::string::npos);
  EXPECT_NE(
    errorOf(title + "  mode = auto\n").find("line 2: expected the verb"), std::string::npos);
  EXPECT_NE(errorOf(title + "wrap\n  mood = auto\n").find("line 3: wrap has no option mood"),
    std::string::npos);
  EXPECT_NE(errorOf(title + "wrap\n  mode = odd\n").find("line 3: --mode=odd: expected auto"),
    std::string::npos);
  EXPECT_NE(
    errorOf(title + "wrap\n  mode\n").find("line 3: expected 'name = value'"), std::string::npos);
  EXPECT_NE(errorOf(title + "wrap\n  mode = auto\n  mode = auto\n").find("line 4: mode is given"),
    std::string::npos);
}
