// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/flow_complex.h"

#include <vector>

namespace scan
{

/// The local spacing of the scan at every vertex: the median length of the critical edges there,
/// at most twice the median of that at the other ends of these edges (a stray point is no
/// sparse scan). Positive; needs no density, no neighbourhood size. Reports phase "edges".
std::vector<float> localSpacing(const FlowComplex& flow, Execution& execution);

} // namespace scan
