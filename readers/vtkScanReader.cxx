// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanReader.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "readers/mapped_file.h"

#include <vtkPolyData.h>

void vtkScanReader::PrintSelf(ostream& os, vtkIndent indent)
{
  static constexpr const char* kNames[] = { "automatic", "points", "mesh" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ReadAs: " << kNames[static_cast<int>(this->ReadAs)] << "\n";
}

int vtkScanReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return this->RunGuarded(*this, output,
    [&](scan::Execution& execution)
    {
      const scan::Model model = this->Read(execution);
      scan::bridge::setModel(*output, model);
      this->AddNote(model.note);
    });
}

scan::Model vtkScanReader::Read(scan::Execution& execution) const
{
  if (this->FileName == nullptr)
  {
    throw scan::Error(scan::ErrorCode::badParameter, "no file name; set FileName");
  }
  execution.plan({ { "read", 1.0 } });
  const scan::MappedFile file(this->FileName);
  scan::Model model = this->Parse(file.bytes(), file.name(), execution);
  if (this->ReadAs == Content::points)
  {
    model.triangles.clear();
    model.curves = {};
  }
  if (this->ReadAs == Content::mesh && model.triangles.empty())
  {
    throw scan::Error(
      scan::ErrorCode::badInput, file.name() + ": no triangles; read the file as points");
  }
  return model;
}
