// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what Coin draws for a scene file: per corner of each triangle, per point and per end of
// each line a line "x y z r g b"; a line "triangles N", "points N" or "lines N" ahead of each kind.
#include <Inventor/SoDB.h>
#include <Inventor/SoInput.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLColor.h>
#include <Inventor/VRMLnodes/SoVRMLPointSet.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoShape.h>

#include <cstdio>
#include <string>

namespace
{

struct Drawn
{
  std::string corners;
  std::string points;
  std::string ends;
  unsigned triangleCount = 0;
  unsigned pointCount = 0;
  unsigned lineCount = 0;
};

SbColor colorOf(SoCallbackAction& action, int material)
{
  const SoNode* const shape = action.getCurPathTail();
  if (shape->isOfType(SoVRMLPointSet::getClassTypeId()))
  {
    // Coin draws the colours of this node but does not hand them to callbacks
    const SoNode* const color = static_cast<const SoVRMLPointSet*>(shape)->color.getValue();
    return color == nullptr ? SbColor(1, 1, 1)
                            : static_cast<const SoVRMLColor*>(color)->color[material];
  }
  SbColor diffuse;
  SbColor unused;
  float shininess = 0;
  float transparency = 0;
  action.getMaterial(unused, diffuse, unused, unused, shininess, transparency, material);
  return diffuse;
}

void put(std::string& text, SoCallbackAction& action, const SoPrimitiveVertex& vertex)
{
  const SbVec3f& p = vertex.getPoint();
  const SbColor c = colorOf(action, vertex.getMaterialIndex());
  char line[200];
  std::snprintf(line, sizeof(line), "%.9g %.9g %.9g %.4f %.4f %.4f\n", double(p[0]), double(p[1]),
    double(p[2]), double(c[0]), double(c[1]), double(c[2]));
  text += line;
}

void addTriangle(void* drawn, SoCallbackAction* action, const SoPrimitiveVertex* a,
  const SoPrimitiveVertex* b, const SoPrimitiveVertex* c)
{
  auto& result = *static_cast<Drawn*>(drawn);
  ++result.triangleCount;
  for (const SoPrimitiveVertex* const corner : { a, b, c })
  {
    put(result.corners, *action, *corner);
  }
}

void addPoint(void* drawn, SoCallbackAction* action, const SoPrimitiveVertex* point)
{
  auto& result = *static_cast<Drawn*>(drawn);
  ++result.pointCount;
  put(result.points, *action, *point);
}

void addLine(
  void* drawn, SoCallbackAction* action, const SoPrimitiveVertex* a, const SoPrimitiveVertex* b)
{
  auto& result = *static_cast<Drawn*>(drawn);
  ++result.lineCount;
  put(result.ends, *action, *a);
  put(result.ends, *action, *b);
}

} // namespace

int main(int argc, char** argv)
{
  SoDB::init();
  SoInteraction::init();
  SoInput input;
  if (argc != 2 || !input.openFile(argv[1]))
  {
    std::fputs("give a file\n", stderr);
    return 2;
  }
  SoSeparator* const root = SoDB::readAll(&input);
  if (root == nullptr)
  {
    return 1;
  }
  root->ref();
  Drawn drawn;
  SoCallbackAction action;
  action.addTriangleCallback(SoShape::getClassTypeId(), addTriangle, &drawn);
  action.addPointCallback(SoShape::getClassTypeId(), addPoint, &drawn);
  action.addLineSegmentCallback(SoShape::getClassTypeId(), addLine, &drawn);
  action.apply(root);
  std::printf("triangles %u\n%spoints %u\n%slines %u\n%s", drawn.triangleCount,
    drawn.corners.c_str(), drawn.pointCount, drawn.points.c_str(), drawn.lineCount,
    drawn.ends.c_str());
  root->unref();
  return 0;
}
