// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapFilter.h"
#include "readers/vtkScanPointsReader.h"
#include "writers/vtkScanStlWriter.h"

#include <vtkNew.h>

int main(int argc, char** argv)
{
  vtkNew<vtkScanPointsReader> reader;
  vtkNew<vtkScanWrapFilter> wrap;
  vtkNew<vtkScanStlWriter> writer;
  reader->SetFileName(argc > 1 ? argv[1] : "scan.xyz");
  wrap->SetInputConnection(reader->GetOutputPort());
  writer->SetInputConnection(wrap->GetOutputPort());
  writer->SetFileName(argc > 2 ? argv[2] : "scan.stl");
  return writer->Write() == 1 ? 0 : 1;
}
