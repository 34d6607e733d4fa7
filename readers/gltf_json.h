// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "readers/source.h"

#include <nlohmann/json.hpp>

#include <span>

namespace scan
{

/// The JSON in a part of a file. Throws Error parse for malformed JSON, for more than 100 levels
/// and for JSON that would take many times the memory of the file. Phase "read".
nlohmann::json parseGltfJson(
  const Source& source, std::span<const char> text, Execution& execution);

} // namespace scan
