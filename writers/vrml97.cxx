// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vrml97.h"

#include "writers/scene_lists.h"

namespace scan
{

void writeVrml97(const Model& model, OutputFile& file, Execution& execution)
{
  const bool isSurface = !model.triangles.empty();
  requireSceneLimits(model, file, "VRML");
  WriteProgress progress(execution, sceneRecords(model));
  file.write("#VRML V2.0 utf8\nShape {\n");
  // without an appearance, points without colours are white; with one they would be black
  file.write(isSurface ? "appearance Appearance { material Material { } }\n"
                         "geometry IndexedFaceSet {\nsolid FALSE\ncreaseAngle 0.5\n"
                       : "geometry PointSet {\n");
  if (!model.colors.empty())
  {
    file.write("color Color { color ");
    writeColorList(model, file, progress);
    file.write(" }\n");
  }
  file.write("coord Coordinate { point ");
  writePointList(model, file, progress);
  file.write(" }\n");
  if (isSurface)
  {
    file.write("coordIndex ");
    writeTriangleList(model, file, progress);
    file.write("\n");
  }
  file.write("}\n}\n");
}

} // namespace scan
