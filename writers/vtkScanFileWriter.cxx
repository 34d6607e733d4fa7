// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanFileWriter.h"

#include "writers/output_file.h"

#include <vtkDataObject.h>

vtkScanFileWriter::~vtkScanFileWriter()
{
  this->SetFileName(nullptr);
}

void vtkScanFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName != nullptr ? this->FileName : "(none)") << "\n";
}

int vtkScanFileWriter::Write()
{
  return this->Superclass::Write() != 0 && this->GetOutcome().state == vtkScanOutcome::State::ok
    ? 1
    : 0;
}

int vtkScanFileWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // the superclass calls WriteData() and cannot tell that it failed
  this->Superclass::RequestData(request, inputVector, outputVector);
  return this->GetOutcome().state == vtkScanOutcome::State::failed ? 0 : 1;
}

void vtkScanFileWriter::WriteData()
{
  this->RunGuarded(*this, nullptr,
    [this](scan::Execution& execution)
    {
      vtkDataObject* const input = this->GetInput();
      if (this->FileName == nullptr || input == nullptr)
      {
        throw scan::Error(scan::ErrorCode::badParameter, "no file name or no input to write");
      }
      execution.plan({ { "write", 1.0 } });
      scan::OutputFile file(this->FileName);
      this->WriteFile(*input, file, execution);
      file.commit();
    });
}
