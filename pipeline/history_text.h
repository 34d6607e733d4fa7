// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document.h"

#include <string>

namespace scan
{

/// "push --at=0,0,0 --deep": the verb with the parameters that differ from their defaults.
std::string commandOf(const Step& step);

/// The tree of steps, one a line, branches indented; * marks the current step.
std::string historyText(const Document& document);

/// All that is known of a step.
std::string stepText(const Step& step);

} // namespace scan
