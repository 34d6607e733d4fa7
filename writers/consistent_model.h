// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/model.h"

#include <string>
#include <vector>

namespace scan
{

/// The model with a surface that every program can work with, see makeConsistent(). Points that are
/// repeated keep their colours and normals; normals on the far side of triangles that were turned
/// are turned, too; curves keep their points. Model::note says what was changed, as changesOf().
///
/// Throws as makeConsistent().
/// @param stored the points as the file will hold them, where it rounds; empty where it does not.
///   What has area, and what lies in one place, is decided by them.
/// @param leastHeight of a triangle that has area, see removeFlatTriangles()
Model consistentModel(
  Model model, std::vector<Vec3> stored, double leastHeight, Execution& execution);

/// What was changed, in one line; empty when nothing was.
std::string changesOf(const ConsistentSurface& surface);

} // namespace scan
