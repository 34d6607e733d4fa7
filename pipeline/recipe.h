// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document.h"
#include "pipeline/step.h"

#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// An operation to be done, with the parameters that differ from their defaults.
struct RecipeStep
{
  const Operation* operation = nullptr;
  ParameterValues given;
};

/// Operations one after the other, without the files they start from: a template.
///
/// As text: a line "scanwrap template 1", then a line per operation with its verb, and below it,
/// indented, a line "name = value" per parameter. Lists of texts take a line per text. Empty lines
/// and lines that start with # say nothing.
using Recipe = std::vector<RecipeStep>;

/// What leads from the files to a step.
/// @throws Error badParameter when a step is of an operation that this program does not know
Recipe recipeOf(const Document& document, StepId step);

std::string textOf(const Recipe& recipe);

/// @param name of the file, for messages
/// @throws Error parse with the line
Recipe parseRecipe(std::string_view text, const std::string& name);

/// The recipe in a file, or as PROJECT.wrp:NAME in a project. Throws Error io, parse, badParameter.
Recipe readRecipe(const std::string& place);

} // namespace scan
