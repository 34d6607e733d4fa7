// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/affine.h"
#include "readers/gltf_document.h"

#include <cstddef>
#include <vector>

namespace scan
{

/// A mesh where a node shows it.
struct GltfPlacement
{
  std::size_t mesh = 0; ///< as the file says it, not checked
  Affine place;         ///< from the mesh to the scene
};

/// The meshes of the default scene, or of all nodes without scenes, or all meshes without nodes.
/// Throws Error parse for nodes that do not exist, contain themselves or have a malformed
/// transform.
std::vector<GltfPlacement> gltfScene(const GltfDocument& document, Execution& execution);

} // namespace scan
