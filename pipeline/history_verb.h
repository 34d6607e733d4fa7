// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document.h"
#include "pipeline/operation_table.h"

#include <string>

namespace scan
{

/// The row of the verb that works on the history itself; it has no filter.
const Operation& historyOperation();

/// What came out of it.
struct HistoryAnswer
{
  std::string text = {}; ///< for the user
  Results results = {};  ///< for the record
  bool hasFailedCheck = false;
};

/// Does what the options say, one thing at a time; lists the history without any.
/// @param mayReplace outputs that exist
/// @throws Error, Cancelled
HistoryAnswer runHistory(
  Document& document, const ParameterValues& given, const RunOptions& options, bool mayReplace);

} // namespace scan
