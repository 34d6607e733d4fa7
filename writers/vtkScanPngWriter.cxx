// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanPngWriter.h"

#include "writers/output_file.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

vtkStandardNewMacro(vtkScanPngWriter);

int vtkScanPngWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkScanPngWriter::WriteFile(
  vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution)
{
  auto* const picture = vtkImageData::SafeDownCast(&input);
  const int type = picture->GetPointData()->GetScalars() != nullptr ? picture->GetScalarType() : -1;
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT)
  {
    throw scan::Error(scan::ErrorCode::badInput,
      file.name() + ": a picture needs channels of 8 or 16 bits; convert it first");
  }
  execution.step("write", 0, 1);
  vtkNew<vtkPNGWriter> encoder;
  encoder->SetInputData(picture);
  encoder->WriteToMemoryOn();
  encoder->Write();
  vtkUnsignedCharArray* const bytes = encoder->GetResult();
  if (bytes == nullptr)
  {
    throw scan::Error(
      scan::ErrorCode::badInput, file.name() + ": VTK cannot make a PNG file of the picture");
  }
  file.write({ reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) });
  execution.step("write", 1, 1); // a cancel comes too late once the file has its name
}
