// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/writers/occt_reading.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>

#include <stdexcept>

namespace scan::test
{
namespace
{

int countOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
  int count = 0;
  for (TopExp_Explorer at(shape, kind); at.More(); at.Next())
  {
    ++count;
  }
  return count;
}

} // namespace

CadContent readIgesWithOcct(const std::string& path)
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  IGESControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0)
  {
    throw std::runtime_error("no shape in " + path);
  }
  const TopoDS_Shape shape = reader.OneShape();
  CadContent content;
  content.solids = countOf(shape, TopAbs_SOLID);
  content.shells = countOf(shape, TopAbs_SHELL);
  content.faces = countOf(shape, TopAbs_FACE);
  TopTools_IndexedMapOfShape vertices;
  TopExp::MapShapes(shape, TopAbs_VERTEX, vertices);
  for (int i = 1; i <= vertices.Extent(); ++i)
  {
    const gp_Pnt point = BRep_Tool::Pnt(TopoDS::Vertex(vertices(i)));
    content.vertices.push_back({ point.X(), point.Y(), point.Z() });
  }
  GProp_GProps volume;
  GProp_GProps area;
  GProp_GProps length;
  BRepGProp::VolumeProperties(shape, volume);
  BRepGProp::SurfaceProperties(shape, area);
  BRepGProp::LinearProperties(shape, length);
  content.volume = volume.Mass();
  content.area = area.Mass();
  content.length = length.Mass();
  content.isValid = BRepCheck_Analyzer(shape).IsValid();
  return content;
}

} // namespace scan::test
