// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanVtpWriter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "writers/consistent_model.h"
#include "writers/output_file.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkScanVtpWriter);

namespace
{

/// Stops the encoder soon after a cancel; an exception may not pass it.
void watchForCancel(vtkXMLPolyDataWriter& encoder, scan::Execution& execution)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&execution);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* run, void*)
    {
      if (static_cast<scan::Execution*>(run)->cancelled())
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  encoder.AddObserver(vtkCommand::ProgressEvent, command);
}

std::string encode(vtkPolyData* data, scan::Execution& execution)
{
  vtkNew<vtkXMLPolyDataWriter> encoder;
  watchForCancel(*encoder, execution);
  encoder->SetInputData(data);
  encoder->SetDataModeToAppended();
  encoder->EncodeAppendedDataOff();
  encoder->SetHeaderTypeToUInt64();
  encoder->WriteToOutputStringOn();
  const int isWritten = encoder->Write();
  execution.step("write", 1, 2);
  if (isWritten == 0)
  {
    throw scan::Error(scan::ErrorCode::internal, "VTK cannot write the surface");
  }
  return encoder->GetOutputString();
}

/// Turns what points to the far side of triangles that were turned over: normals of points, and of
/// the triangles from cell `firstTriangle` on.
void turnNormals(const scan::ConsistentSurface& surface, vtkIdType firstTriangle, vtkPolyData& data)
{
  const scan::TriMesh& mesh = surface.mesh;
  if (vtkDataArray* const array = data.GetPointData()->GetNormals())
  {
    std::vector<scan::Vec3> normals(mesh.points.size());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      const double* const n = array->GetTuple3(static_cast<vtkIdType>(i));
      normals[i] = { n[0], n[1], n[2] };
    }
    scan::turnNormals(mesh, surface.isTurned, normals);
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      array->SetTuple3(static_cast<vtkIdType>(i), normals[i].x, normals[i].y, normals[i].z);
    }
  }
  vtkDataArray* const array = data.GetCellData()->GetNormals();
  for (std::size_t t = 0; t < mesh.triangles.size() && array != nullptr; ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const scan::Vec3 side = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
    const vtkIdType cell = firstTriangle + static_cast<vtkIdType>(t);
    const double* const n = array->GetTuple3(cell);
    if (surface.isTurned[t] && dot({ n[0], n[1], n[2] }, side) < 0.0)
    {
      array->SetTuple3(cell, -n[0], -n[1], -n[2]);
    }
  }
}

/// The data on another surface; verts and lines stay, since points do.
/// @param cellOf the cell that each triangle was a part of
vtkSmartPointer<vtkPolyData> dataOn(
  const scan::ConsistentSurface& surface, const std::vector<vtkIdType>& cellOf, vtkPolyData& data)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  scan::bridge::setMesh(*result, surface.mesh);
  result->SetVerts(data.GetVerts());
  result->SetLines(data.GetLines());
  result->SetFieldData(data.GetFieldData());
  const auto copy =
    [](vtkDataSetAttributes& from, vtkDataSetAttributes& to, const std::vector<vtkIdType>& origin)
  {
    to.CopyAllOn();
    to.CopyAllocate(&from, static_cast<vtkIdType>(origin.size()));
    for (std::size_t i = 0; i < origin.size(); ++i)
    {
      to.CopyData(&from, origin[i], static_cast<vtkIdType>(i));
    }
  };
  copy(*data.GetPointData(), *result->GetPointData(),
    { surface.pointOrigin.begin(), surface.pointOrigin.end() });
  const vtkIdType others = data.GetNumberOfVerts() + data.GetNumberOfLines();
  std::vector<vtkIdType> cells(static_cast<std::size_t>(others));
  std::iota(cells.begin(), cells.end(), 0);
  std::ranges::transform(surface.triangleOrigin, std::back_inserter(cells),
    [&](scan::Index triangle) { return cellOf[triangle]; });
  copy(*data.GetCellData(), *result->GetCellData(), cells);
  turnNormals(surface, others, *result);
  return result;
}

} // namespace

void vtkScanVtpWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Consistent: " << (this->Consistent ? "On" : "Off") << "\n";
}

int vtkScanVtpWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkScanVtpWriter::WriteFile(
  vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution)
{
  vtkSmartPointer<vtkPolyData> data = vtkPolyData::SafeDownCast(&input);
  if (data->GetNumberOfPoints() == 0)
  {
    throw scan::Error(
      scan::ErrorCode::badInput, file.name() + ": no points to write; check the input");
  }
  execution.step("write", 0, 2);
  if (this->Consistent)
  {
    std::vector<vtkIdType> cells;
    const scan::ConsistentSurface surface =
      scan::makeConsistent(scan::bridge::meshOf(*data, &cells), 0.0, execution);
    data = surface.changes.any() ? dataOn(surface, cells, *data) : data;
    this->AddNote(scan::describe(surface.changes));
  }
  file.write(encode(data, execution));
  execution.step("write", 2, 2); // a cancel comes too late once the file has its name
}
