// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/result.h"
#include "pipeline/step.h"

#include <map>
#include <string>

namespace scan
{

/// Results as a JSON object, in their order.
std::string jsonOf(const Results& results);

/// @throws Error parse
Results parseResults(const std::string& json);

/// Names and texts as a JSON object.
std::string jsonOf(const std::map<std::string, std::string>& texts);

/// @throws Error parse
std::map<std::string, std::string> parseTexts(const std::string& json);

} // namespace scan
