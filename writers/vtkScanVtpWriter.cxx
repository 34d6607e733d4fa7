// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanVtpWriter.h"

#include "writers/output_file.h"

#include <vtkCallbackCommand.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

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

} // namespace

vtkScanVtpWriter::~vtkScanVtpWriter()
{
  this->SetFileName(nullptr);
}

void vtkScanVtpWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName != nullptr ? this->FileName : "(none)") << "\n";
}

int vtkScanVtpWriter::Write()
{
  return this->Superclass::Write() != 0 && this->GetOutcome().state == vtkScanOutcome::State::ok
    ? 1
    : 0;
}

int vtkScanVtpWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkScanVtpWriter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // the superclass calls WriteData() and cannot tell that it failed
  this->Superclass::RequestData(request, inputVector, outputVector);
  return this->GetOutcome().state == vtkScanOutcome::State::failed ? 0 : 1;
}

void vtkScanVtpWriter::WriteData()
{
  this->RunGuarded(*this, nullptr,
    [this](scan::Execution& execution)
    {
      vtkPolyData* input = vtkPolyData::SafeDownCast(this->GetInput());
      if (this->FileName == nullptr || input == nullptr)
      {
        throw scan::Error(scan::ErrorCode::badParameter, "no file name or no input to write");
      }
      if (input->GetNumberOfPoints() == 0)
      {
        throw scan::Error(
          scan::ErrorCode::badInput, std::string(this->FileName) + ": no points to write");
      }
      execution.plan({ { "write", 1.0 } });
      execution.step("write", 0, 2);
      scan::OutputFile file(this->FileName);
      file.write(encode(input, execution));
      execution.step("write", 2, 2); // a cancel comes too late once the file has its name
      file.commit();
    });
}
