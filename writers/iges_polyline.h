// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/model.h"
#include "writers/iges_file.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace scan
{

/// Puts a line through points, copious data of form 12 (106).
/// @return the number under which others name it
std::uint64_t putIgesPolyline(
  const TriMesh& mesh, std::span<const Index> corners, std::string_view status, IgesSink& sink);

/// Puts each curve of a model.
void putIgesCurves(const Model& model, IgesSink& sink);

} // namespace scan
