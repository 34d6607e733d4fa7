// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanPngWriter.h"

#include "writers/output_file.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

vtkStandardNewMacro(vtkScanPngWriter);

vtkScanPngWriter::~vtkScanPngWriter()
{
  this->SetFileName(nullptr);
}

void vtkScanPngWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName != nullptr ? this->FileName : "(none)") << "\n";
}

int vtkScanPngWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkScanPngWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // the superclass calls WriteData() and cannot tell that it failed
  this->Superclass::RequestData(request, inputVector, outputVector);
  return this->GetOutcome().state == vtkScanOutcome::State::failed ? 0 : 1;
}

void vtkScanPngWriter::WriteData()
{
  this->RunGuarded(*this, nullptr,
    [this](scan::Execution& execution)
    {
      vtkImageData* input = vtkImageData::SafeDownCast(this->GetInput());
      if (this->FileName == nullptr || input == nullptr)
      {
        throw scan::Error(scan::ErrorCode::badParameter, "no file name or no picture to write");
      }
      execution.plan({ { "write", 1.0 } });
      execution.step("write", 0, 1);
      vtkNew<vtkPNGWriter> encoder;
      encoder->SetInputData(input);
      encoder->WriteToMemoryOn();
      encoder->Write();
      vtkUnsignedCharArray* bytes = encoder->GetResult();
      scan::OutputFile file(this->FileName);
      file.write({ reinterpret_cast<const char*>(bytes->GetPointer(0)),
        static_cast<std::size_t>(bytes->GetNumberOfValues()) });
      execution.step("write", 1, 1); // a cancel comes too late once the file has its name
      file.commit();
    });
}
