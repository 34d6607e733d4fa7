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

/// The cell that each triangle of bridge::meshOf() comes from.
std::vector<vtkIdType> cellsOfTriangles(vtkPolyData& data)
{
  std::vector<vtkIdType> cells;
  vtkIdType cell = data.GetNumberOfVerts() + data.GetNumberOfLines();
  for (vtkCellArray* const kind : { data.GetPolys(), data.GetStrips() })
  {
    for (vtkIdType i = 0; i < kind->GetNumberOfCells(); ++i, ++cell)
    {
      cells.insert(cells.end(),
        static_cast<std::size_t>(std::max<vtkIdType>(kind->GetCellSize(i) - 2, 0)), cell);
    }
  }
  return cells;
}

/// The data on another surface; verts and lines stay, since points do.
vtkSmartPointer<vtkPolyData> dataOn(const scan::ConsistentSurface& surface, vtkPolyData& data)
{
  const auto result = vtkSmartPointer<vtkPolyData>::New();
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
  std::vector<vtkIdType> cells(
    static_cast<std::size_t>(data.GetNumberOfVerts() + data.GetNumberOfLines()));
  std::iota(cells.begin(), cells.end(), 0);
  const std::vector<vtkIdType> cellOf = cellsOfTriangles(data);
  std::ranges::transform(surface.triangleOrigin, std::back_inserter(cells),
    [&](scan::Index triangle) { return cellOf[triangle]; });
  copy(*data.GetCellData(), *result->GetCellData(), cells);
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
    const scan::ConsistentSurface surface =
      scan::makeConsistent(scan::bridge::meshOf(*data), 0.0, execution);
    data = surface.isChanged() ? dataOn(surface, *data) : data;
    this->AddNote(scan::changesOf(surface));
  }
  file.write(encode(data, execution));
  execution.step("write", 2, 2); // a cancel comes too late once the file has its name
}
