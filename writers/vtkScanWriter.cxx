// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanWriter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "writers/consistent_model.h"
#include "writers/output_file.h"

#include <vtkInformation.h>
#include <vtkPolyData.h>

#include <utility>

vtkScanWriter::~vtkScanWriter()
{
  this->SetFileName(nullptr);
}

void vtkScanWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName != nullptr ? this->FileName : "(none)") << "\n";
  os << indent << "Encoding: " << (this->Encoding == scan::Encoding::ascii ? "ascii" : "binary")
     << "\n";
  os << indent << "Consistent: " << (this->Consistent ? "On" : "Off") << "\n";
}

int vtkScanWriter::Write()
{
  return this->Superclass::Write() != 0 && this->GetOutcome().state == vtkScanOutcome::State::ok
    ? 1
    : 0;
}

int vtkScanWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkScanWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // the superclass calls WriteData() and cannot tell that it failed
  this->Superclass::RequestData(request, inputVector, outputVector);
  return this->GetOutcome().state == vtkScanOutcome::State::failed ? 0 : 1;
}

void vtkScanWriter::WriteData()
{
  this->RunGuarded(*this, nullptr,
    [this](scan::Execution& execution)
    {
      vtkPolyData* input = vtkPolyData::SafeDownCast(this->GetInput());
      if (this->FileName == nullptr || input == nullptr)
      {
        throw scan::Error(scan::ErrorCode::badParameter, "no file name or no input to write");
      }
      execution.plan({ { "write", 1.0 } });
      scan::OutputFile file(this->FileName);
      scan::Model model = scan::bridge::modelOf(*input);
      if (this->Consistent)
      {
        std::vector<scan::Vec3> stored = this->Stored(model.points);
        const double leastHeight = this->LeastHeight(model);
        model = scan::consistentModel(std::move(model), std::move(stored), leastHeight, execution);
        this->AddNote(model.note);
      }
      this->AddNote(this->NoteOn(model));
      this->Format(model, file, execution);
      file.commit();
    });
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
