// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace scan
{

/// "; did you mean 'wrap'?" when one of the candidates is a typing error or two away from the word,
/// else an empty text.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates);

} // namespace scan
