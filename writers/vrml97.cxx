// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vrml97.h"

#include "writers/scene_lists.h"

namespace scan
{
namespace
{

void writePoints(const Model& model, bool isShared, OutputFile& file, WriteProgress& progress)
{
  if (!model.colors.empty())
  {
    file.write(isShared ? "color DEF Colors Color { color " : "color Color { color ");
    writeColorList(model, file, progress);
    file.write(" }\n");
  }
  file.write(isShared ? "coord DEF Points Coordinate { point " : "coord Coordinate { point ");
  writePointList(model, file, progress);
  file.write(" }\n");
}

} // namespace

void writeVrml97(const Model& model, OutputFile& file, Execution& execution)
{
  const bool hasTriangles = !model.triangles.empty();
  const bool hasBoth = hasTriangles && !model.curves.empty();
  requireSceneLimits(model, file, "VRML");
  WriteProgress progress(execution, sceneRecords(model));
  file.write("#VRML V2.0 utf8\nShape {\n");
  // without an appearance, points and lines without colours are white; with one they would be black
  file.write(hasTriangles     ? "appearance Appearance { material Material { } }\n"
                                "geometry IndexedFaceSet {\nsolid FALSE\ncreaseAngle 0.5\n"
      : !model.curves.empty() ? "geometry IndexedLineSet {\n"
                              : "geometry PointSet {\n");
  writePoints(model, hasBoth, file, progress);
  if (hasTriangles)
  {
    file.write("coordIndex ");
    writeTriangleList(model, file, progress);
    file.write("\n");
  }
  if (hasBoth)
  {
    file.write("}\n}\nShape {\ngeometry IndexedLineSet {\n");
    file.write(model.colors.empty() ? "" : "color USE Colors\n");
    file.write("coord USE Points\n");
  }
  if (!model.curves.empty())
  {
    file.write("coordIndex ");
    writeCurveList(model, file, progress);
    file.write("\n");
  }
  file.write("}\n}\n");
}

} // namespace scan
