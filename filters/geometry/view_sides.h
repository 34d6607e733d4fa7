// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mesh.h"

#include <array>
#include <string_view>

namespace scan
{

/// A side to look at a model from, which stands on the xy plane.
struct ViewSide
{
  std::string_view name;
  Vec3 towards; ///< from the model to the eye
  Vec3 up;
};

inline constexpr std::array<ViewSide, 6> kViewSides{ { { "front", { 0, -1, 0 }, { 0, 0, 1 } },
  { "back", { 0, 1, 0 }, { 0, 0, 1 } }, { "left", { -1, 0, 0 }, { 0, 0, 1 } },
  { "right", { 1, 0, 0 }, { 0, 0, 1 } }, { "top", { 0, 0, 1 }, { 0, 1, 0 } },
  { "bottom", { 0, 0, -1 }, { 0, -1, 0 } } } };

} // namespace scan
