// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/quality_methods.h"

#include "filters/geometry/wrap.h"

namespace quality
{

scan::TriMesh automaticWrap(const Cloud& cloud)
{
  scan::Execution execution(1);
  return scan::wrap(cloud.points, {}, execution).surface;
}

const std::vector<Method>& methods()
{
  static const std::vector<Method> all = {
    { "Scanwrap, automatic", automaticWrap },
    { "advancing front", advancingFront },
    { "scale space", scaleSpace },
    { "scale space, front", scaleSpaceFront },
    { "Poisson", poisson },
    { "alpha wrap, 3 spacings", fineAlphaWrap },
    { "alpha wrap, diagonal / 10", coarseAlphaWrap },
  };
  return all;
}

} // namespace quality
