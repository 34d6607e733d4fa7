// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/geometry/mesh.h"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace scan
{

/// Places in space, in model units; written "x,y,z" each, with a semicolon between two.
using PointList = std::vector<Vec3>;

/// Numbers of triangles or the like; written with a comma between two.
using IdList = std::vector<std::int64_t>;

/// Texts that are given one by one; written with a line end between two.
using TextList = std::vector<std::string>;

/// The type of a parameter is the alternative that its default holds; a choice is a text with a
/// list of choices.
using ParameterValue =
  std::variant<bool, std::int64_t, double, Length, std::string, PointList, IdList, TextList>;

/// One setting of an operation, as the command line, a dialog and a template see it.
struct Parameter
{
  std::string name;            ///< lower case with hyphens: "max-deviation"
  ParameterValue defaultValue; ///< says the type, too
  std::string help;            ///< one line
  double minimum = std::numeric_limits<double>::lowest(); ///< of integers, reals and lengths
  double maximum = std::numeric_limits<double>::max();
  std::vector<std::string> choices = {};     ///< of texts; empty: any text
  void (*check)(std::string_view) = nullptr; ///< of texts that are not empty; throws Error
};

/// The parameters of one run by name; those not named have their defaults.
using ParameterValues = std::map<std::string, ParameterValue, std::less<>>;

/// What the parameter takes, for help and messages: "true|false", "auto|classic",
/// "a whole number from 1 to 8192".
std::string rangeText(const Parameter& parameter);

/// @throws Error{badParameter} naming the parameter and its range
ParameterValue parseValue(const Parameter& parameter, std::string_view text);

/// @throws Error{badParameter} for a value of another type or out of range
void checkValue(const Parameter& parameter, const ParameterValue& value);

/// Every parameter with its given or default value.
/// @param owner ahead of messages: "wrap"
/// @throws Error{badParameter} for an unknown name, a wrong type or a value out of range
ParameterValues completeValues(
  const std::vector<Parameter>& parameters, const ParameterValues& given, const std::string& owner);

/// Appends a list to another of its kind; returns false for values that are no lists.
bool appendValue(ParameterValue& list, const ParameterValue& more);

/// The text that parseValue() turns into the same value.
std::string textOf(const ParameterValue& value);

} // namespace scan
