// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"

#include "filters/base/error.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <initializer_list>

using namespace scan;

namespace
{

void addCell(vtkCellArray& cells, std::initializer_list<vtkIdType> ids)
{
  cells.InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.begin());
}

vtkSmartPointer<vtkPolyData> fivePoints()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(i, i % 2, 0.0);
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(vtkSmartPointer<vtkCellArray>::New());
  data->SetStrips(vtkSmartPointer<vtkCellArray>::New());
  data->SetLines(vtkSmartPointer<vtkCellArray>::New());
  return data;
}

} // namespace

TEST(MeshBridge, KeepsEveryDigitOfLargeCoordinates)
{
  const TriMesh mesh{ { { 512345.678901234, 5412345.678901234, 0.1 } }, {} };
  vtkNew<vtkPolyData> data;
  bridge::setMesh(*data, mesh);
  EXPECT_EQ(bridge::pointsOf(*data), mesh.points);
}

TEST(MeshBridge, RoundTripsTrianglesLinesAndIds)
{
  const TriMesh mesh{ { {}, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, { { 0, 1, 2 }, { 2, 1, 3 } } };
  const std::vector<Segment> lines{ { 0, 3 } };
  const std::vector<vtkIdType> ids{ 7, 3, 5, 11 };
  vtkNew<vtkPolyData> data;
  bridge::setMesh(*data, mesh, lines);
  bridge::setScanPointIds(*data, ids);
  const TriMesh back = bridge::meshOf(*data);
  EXPECT_EQ(back.points, mesh.points);
  EXPECT_EQ(back.triangles, mesh.triangles);
  EXPECT_EQ(bridge::segmentsOf(*data), lines);
  EXPECT_EQ(bridge::scanPointIdsOf(*data), ids);
  EXPECT_EQ(data->GetNumberOfVerts(), 0);
}

TEST(MeshBridge, PurePointsGetVerticesAndTheirOwnIds)
{
  vtkNew<vtkPolyData> data;
  bridge::setMesh(*data, { { {}, { 1, 0, 0 }, { 0, 1, 0 } }, {} });
  EXPECT_EQ(data->GetNumberOfVerts(), 3);
  EXPECT_EQ(bridge::scanPointIdsOf(*data), (std::vector<vtkIdType>{ 0, 1, 2 }));
}

TEST(MeshBridge, PolygonsBecomeFansAndStripsKeepTheirSide)
{
  const auto data = fivePoints();
  addCell(*data->GetPolys(), { 0, 1, 3, 2 });
  addCell(*data->GetPolys(), { 0, 1 });
  addCell(*data->GetStrips(), { 0, 1, 2, 3 });
  addCell(*data->GetLines(), { 0, 1, 2 });
  const std::vector<Triangle> expected{ { 0, 1, 3 }, { 0, 3, 2 }, { 0, 1, 2 }, { 2, 1, 3 } };
  EXPECT_EQ(bridge::meshOf(*data).triangles, expected);
  EXPECT_EQ(bridge::segmentsOf(*data), (std::vector<Segment>{ { 0, 1 }, { 1, 2 } }));
}

TEST(MeshBridge, RefusesCellsOfMissingPoints)
{
  for (const vtkIdType id : { vtkIdType{ 5 }, vtkIdType{ -1 } })
  {
    const auto data = fivePoints();
    addCell(*data->GetPolys(), { 0, 1, id });
    EXPECT_THROW(bridge::meshOf(*data), Error);
  }
}

TEST(MeshBridge, EmptyDataIsAnEmptyMesh)
{
  vtkNew<vtkPolyData> data;
  const TriMesh mesh = bridge::meshOf(*data);
  EXPECT_TRUE(mesh.points.empty());
  EXPECT_TRUE(mesh.triangles.empty());
}
