// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/iges_polyline.h"

namespace scan
{

std::uint64_t putIgesPolyline(
  const TriMesh& mesh, std::span<const Index> corners, std::string_view status, IgesSink& sink)
{
  sink.begin({ .type = 106, .form = 12, .status = status });
  sink.integer(2).integer(corners.size()); // triples, how many
  for (const Index corner : corners)
  {
    sink.point(mesh.points[corner]);
  }
  return sink.end();
}

void putIgesCurves(const Model& model, IgesSink& sink)
{
  for (std::size_t i = 0; i < model.curves.size(); ++i)
  {
    putIgesPolyline(model, model.curves[i], IgesKind{}.status, sink);
  }
}

} // namespace scan
