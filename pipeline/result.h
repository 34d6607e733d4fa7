// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace scan
{

/// What an operation found out: counts, measures, yes or no. std::monostate means "has none".
using ResultValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

/// In the order in which people want to read them.
using Results = std::vector<std::pair<std::string, ResultValue>>;

} // namespace scan
