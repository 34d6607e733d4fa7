// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/geometry/surface_edit.h"

#include <numeric>
#include <utility>

namespace scan
{

SurfaceEdit unchanged(TriMesh mesh)
{
  SurfaceEdit edit;
  edit.pointOrigin.resize(mesh.points.size());
  edit.triangleOrigin.resize(mesh.triangles.size());
  std::iota(edit.pointOrigin.begin(), edit.pointOrigin.end(), Index{ 0 });
  std::iota(edit.triangleOrigin.begin(), edit.triangleOrigin.end(), Index{ 0 });
  edit.mesh = std::move(mesh);
  return edit;
}

} // namespace scan
