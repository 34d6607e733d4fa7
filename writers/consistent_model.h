// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/consistent_surface.h"
#include "filters/geometry/model.h"
#include "writers/format_traits.h"

#include <vector>

namespace scan
{

/// The model with a surface that every program can work with, see makeConsistent(), also when it
/// reads the coordinates as the traits say: what has area, and what lies in one place, is decided
/// by them. Points that are repeated keep their colours and normals; normals are turned as
/// turnNormals() does; points that only a lost triangle had go, curves keep theirs, and where
/// neither triangles nor curves are left, all points stay. Model::note says what was changed.
///
/// Throws as makeConsistent().
Model consistentModel(Model model, const FormatTraits& traits, Execution& execution);

/// Turns the normals of points of turned triangles that point to the far side of the triangles
/// around them.
/// @param isTurned per triangle
/// @param normals per point of the mesh, or empty
void turnNormals(
  const TriMesh& mesh, const std::vector<bool>& isTurned, std::vector<Vec3>& normals);

} // namespace scan
