// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanWriter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "writers/consistent_model.h"

#include <vtkInformation.h>
#include <vtkPolyData.h>

#include <utility>

void vtkScanWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << (this->Encoding == scan::Encoding::ascii ? "ascii" : "binary")
     << "\n";
  os << indent << "Consistent: " << (this->Consistent ? "On" : "Off") << "\n";
}

int vtkScanWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkScanWriter::WriteFile(
  vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution)
{
  scan::Model model = scan::bridge::modelOf(*vtkPolyData::SafeDownCast(&input));
  if (this->Consistent)
  {
    std::vector<scan::Vec3> stored = this->Stored(model.points);
    const double leastHeight = this->LeastHeight(model);
    model = scan::consistentModel(std::move(model), std::move(stored), leastHeight, execution);
    this->AddNote(model.note);
  }
  this->AddNote(this->NoteOn(model));
  this->Format(model, file, execution);
}

std::vector<scan::Vec3> vtkScanWriter::Stored(const std::vector<scan::Vec3>&) const
{
  return {};
}

double vtkScanWriter::LeastHeight(const scan::Model&) const
{
  return 0.0;
}

std::string vtkScanWriter::NoteOn(const scan::Model&) const
{
  return {};
}
