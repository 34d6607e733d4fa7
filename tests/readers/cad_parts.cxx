// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/readers/cad_parts.h"

#include "tests/readers/temporary_folder.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Ax2.hxx>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace scan::test
{
namespace
{

void silence()
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

TopoDS_Shape compoundOf(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind)
{
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (TopExp_Explorer at(shape, kind); at.More(); at.Next())
  {
    builder.Add(all, at.Current());
  }
  return all;
}

} // namespace

TopoDS_Shape boxPart()
{
  return BRepPrimAPI_MakeBox(30.0, 20.0, 10.0).Shape();
}

TopoDS_Shape drilledCylinderPart()
{
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(10.0, 30.0).Shape();
  const gp_Ax2 across(gp_Pnt(-20.0, 0.0, 15.0), gp_Dir(1.0, 0.0, 0.0));
  return BRepAlgoAPI_Cut(cylinder, BRepPrimAPI_MakeCylinder(across, 4.0, 40.0).Shape()).Shape();
}

TopoDS_Shape spherePart()
{
  return BRepPrimAPI_MakeSphere(gp_Pnt(1.0, 2.0, 3.0), 7.0).Shape();
}

TopoDS_Shape torusPart()
{
  return BRepPrimAPI_MakeTorus(20.0, 5.0).Shape();
}

TopoDS_Shape hollowBallPart()
{
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(7.0).Shape(), BRepPrimAPI_MakeSphere(5.0).Shape())
    .Shape();
}

TopoDS_Shape mirroredPairPart()
{
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(-10.0, 0.0, 0.0), gp_Dir(1.0, 0.0, 0.0)));
  BRep_Builder builder;
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, boxPart());
  builder.Add(both, BRepBuilderAPI_Transform(boxPart(), mirror).Shape());
  return both;
}

std::string stepBytes(const TopoDS_Shape& shape)
{
  silence();
  STEPControl_Writer writer;
  writer.Transfer(shape, STEPControl_AsIs);
  const TemporaryFolder folder;
  const IFSelect_ReturnStatus status = writer.Write(folder.file("part.step").c_str());
  if (status != IFSelect_RetDone)
  {
    throw std::runtime_error("the STEP file cannot be written");
  }
  return contentOf(folder.file("part.step"));
}

std::string igesBytes(const TopoDS_Shape& shape, bool isSolid, const char* unit)
{
  silence();
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit, isSolid ? 1 : 0);
  writer.AddShape(isSolid ? shape : compoundOf(shape, TopAbs_FACE));
  writer.ComputeModel();
  std::ostringstream stream;
  if (!writer.Write(stream))
  {
    throw std::runtime_error("the IGES file cannot be written");
  }
  return stream.str();
}

TopoDS_Shape shapeOf(const std::string& path)
{
  silence();
  IGESControl_Reader iges;
  STEPControl_Reader step;
  XSControl_Reader& reader =
    path.ends_with("igs") || path.ends_with("iges") ? static_cast<XSControl_Reader&>(iges) : step;
  reader.ReadFile(path.c_str());
  reader.TransferRoots();
  return reader.OneShape();
}

double volumeOf(const TopoDS_Shape& shape)
{
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

double distanceFrom(const TopoDS_Shape& shape, const std::vector<Vec3>& points)
{
  const TopoDS_Shape faces = compoundOf(shape, TopAbs_FACE); // the inside of a solid is at 0
  double largest = 0.0;
  for (const Vec3& p : points)
  {
    const TopoDS_Shape vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x, p.y, p.z)).Shape();
    largest = std::max(largest, BRepExtrema_DistShapeShape(vertex, faces).Value());
  }
  return largest;
}

} // namespace scan::test
