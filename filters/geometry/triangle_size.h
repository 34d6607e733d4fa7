// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/delaunay_complex.h"

#include <vector>

namespace scan
{

/// A triangle measured by h, the largest local spacing of its vertices (see localSpacing()).
struct TriangleSize
{
  double area;   ///< / h^2
  double length; ///< of the longest edge, / h
  double radius; ///< of the circumcircle, / h; infinite for flat ones

  /// By how much it is larger than triangles of a scanned surface are: webs have area, needles and
  /// spikes to stray points have length.
  double excess() const;
};

TriangleSize triangleSize(
  const DelaunayComplex& complex, const std::vector<float>& spacing, const Triangle& triangle);

} // namespace scan
