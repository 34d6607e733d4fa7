// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/recipe.h"

#include "filters/base/error.h"
#include "tests/pipeline/document_fixtures.h"

#include <random>

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

TEST(Recipe, OfAnyTextIsOneOrAnError)
{
  const std::string whole =
    "scanwrap template 1\nthin\n  by = random\n  keep = 50\nselect\n  name = a\n  rule = "
    "sphere(0,0,0, "
    "2mm) & !box(0,0,0, 1,1,1)\nwrap\n  mode = classic\npush\n  at = 0,0,0;1,2,3\n  deep = true\n";
  ASSERT_EQ(errorOf(whole), "");
  int parsed = 0;
  for (unsigned seed = 1; seed <= 5000; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::string text = whole;
    for (unsigned change = 0; change <= random() % 4; ++change)
    {
      const std::size_t place = random() % text.size();
      switch (random() % 3)
      {
        case 0:
          text[place] = static_cast<char>(random());
          break;
        case 1:
          text.erase(place, random() % 20);
          break;
        default:
          text.insert(place, text.substr(random() % text.size(), random() % 30));
      }
      text += text.empty() ? "x" : "";
    }
    try
    {
      const std::string again = textOf(parseRecipe(text, "a.txt"));
      EXPECT_EQ(textOf(parseRecipe(again, "again.txt")), again);
      ++parsed;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(parsed, 50);
}
