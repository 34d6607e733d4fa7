// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <functional>
#include <string>

namespace scan
{

/// Tells how much of the work of runIsolated() is done, 0 to 1.
using ReportFraction = std::function<void(double fraction)>;

/// Runs `work` in a copy of this process and hands back its model: for libraries that cannot be
/// stopped, print, and do not survive every file. What they print goes nowhere; a cancel ends them
/// within 0.1 s.
///
/// The copy has one thread: `work` must neither start threads nor use what other threads of this
/// process may have locked, allocated memory excepted.
///
/// Throws what `work` throws as Error, with its code and message; Error parse with the message
/// `whenItDies` when the copy crashes; Error memory when there is none left. Phase "read".
Model runIsolated(const std::function<Model(const ReportFraction& report)>& work,
  const std::string& whenItDies, Execution& execution);

} // namespace scan
