// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanWriter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "writers/output_file.h"

#include <vtkInformation.h>
#include <vtkPolyData.h>

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
      this->Format(scan::bridge::modelOf(*input), file, execution);
      file.commit();
    });
}
