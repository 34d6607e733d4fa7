// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline/document.h"
#include "pipeline/result.h"

#include <vector>

namespace scan
{

/// Two steps of a history beside each other.
struct Comparison
{
  StepId a = 0;
  StepId b = 0;
  StepId common = 0;              ///< the last step that leads to both; 0 for none
  std::vector<StepId> onlyA = {}; ///< the steps from there to a
  std::vector<StepId> onlyB = {};
  bool isSame = false; ///< the results are equal, byte for byte

  /// Counts of both, and how far points of one result are from the other: mean, rms, largest, in
  /// model units, of up to 20,000 points evenly taken in their order. To surfaces distances are
  /// exact, to points they are those to the nearest one.
  Results measures = {};
};

/// @throws Error, Cancelled as Document::result()
Comparison compare(Document& document, StepId a, StepId b, const RunOptions& options);

} // namespace scan
