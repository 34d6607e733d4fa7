// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/inventor.h"

#include "writers/scene_lists.h"

namespace scan
{

void writeInventor(
  const Model& model, const InventorOptions& options, OutputFile& file, Execution& execution)
{
  const bool isVrml = options.version == InventorVersion::vrml1;
  const bool isSurface = !model.triangles.empty();
  requireSceneLimits(model, file, isVrml ? "VRML" : "Open Inventor");
  WriteProgress progress(execution, sceneRecords(model));
  file.write(isVrml ? "#VRML V1.0 ascii\n" : "#Inventor V2.1 ascii\n");
  file.write("Separator {\n");
  if (isSurface)
  {
    file.write("ShapeHints { vertexOrdering COUNTERCLOCKWISE faceType CONVEX creaseAngle 0.5 }\n");
  }
  if (!model.colors.empty())
  {
    file.write("Material { diffuseColor ");
    writeColorList(model, file, progress);
    file.write(" }\nMaterialBinding { value ");
    file.write(model.isScan() ? "PER_VERTEX }\n" : "PER_VERTEX_INDEXED }\n");
  }
  file.write("Coordinate3 { point ");
  writePointList(model, file, progress);
  file.write(" }\n");
  if (isSurface)
  {
    file.write("IndexedFaceSet { coordIndex ");
    writeTriangleList(model, file, progress);
    file.write(" }\n");
  }
  if (!model.curves.empty())
  {
    file.write("IndexedLineSet { coordIndex ");
    writeCurveList(model, file, progress);
    file.write(" }\n");
  }
  if (model.isScan())
  {
    file.write("PointSet { }\n");
  }
  file.write("}\n");
}

} // namespace scan
