// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/execution.h"
#include "filters/geometry/model.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace scan
{

struct GltfOptions
{
  /// The bytes of a buffer in a file of its own, valid until the model is read. Throws Error; by
  /// default such buffers are refused.
  std::function<std::span<const char>(const std::string& uri)> readBuffer = {};

  /// Bytes that a model may take, or 12 times those of the file and its buffers.
  double largest = 1e9;
};

/// Reads the default scene of a glTF 2.0 file, joined into one model: GLB, or JSON with buffers
/// that are embedded ("data:" URIs) or that options.readBuffer gives.
///
/// Points, triangles, strips, fans and lines of all meshes are placed by the transforms of their
/// nodes, in double precision. Without scenes, all nodes count. Primitives of a mesh that
/// share their vertices share them in the model; a mesh that several nodes show comes as often.
/// NORMAL and COLOR_0 are read; where only some primitives have them the others get normals of
/// length 0 and white. Colours are linear light in the file and become sRGB. Skins, morph targets,
/// materials and animations are not used. Coordinates are in metres: millimetresPerUnit is 1000;
/// the axes stay as they are, which is +y upwards.
///
/// Throws Error parse for malformed or truncated data, for sparse accessors and required extensions
/// that change the geometry (Draco, meshopt, ...), for corners without a vertex, nodes that contain
/// themselves, a scene without points and triangles, scenes that repeat a mesh until it takes more
/// than options.largest, and for coordinates that are not finite or exceed 1e50; Error limit for
/// 2^32 - 1 points. Phase "read".
Model parseGltfScene(std::span<const char> bytes, std::string_view name, const GltfOptions& options,
  Execution& execution);

/// The same without options.
Model parseGltf(std::span<const char> bytes, std::string_view name, Execution& execution);

/// Whether a file that starts with `head` can be of this format, binary or JSON.
bool looksLikeGltf(std::span<const char> head);

} // namespace scan
