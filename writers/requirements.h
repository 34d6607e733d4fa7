// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/error.h"
#include "filters/geometry/mesh.h"
#include "writers/output_file.h"

#include <string>

namespace scan
{

/// Throws Error badInput without points.
inline void requirePoints(const TriMesh& mesh, const OutputFile& file)
{
  if (mesh.points.empty())
  {
    throw Error(ErrorCode::badInput, file.name() + ": no points to write; check the input");
  }
}

/// Throws Error badInput without triangles.
inline void requireTriangles(const TriMesh& mesh, const OutputFile& file, const std::string& format)
{
  if (mesh.triangles.empty())
  {
    throw Error(ErrorCode::badInput,
      file.name() + ": no triangles to write; " + format +
        " holds surfaces, write points as PLY or OBJ");
  }
}

} // namespace scan
