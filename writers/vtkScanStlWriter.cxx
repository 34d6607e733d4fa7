// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanStlWriter.h"

#include "writers/single_precision.h"
#include "writers/stl.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanStlWriter);

void vtkScanStlWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeStl(model, { .encoding = this->Encoding }, file, execution);
}

std::vector<scan::Vec3> vtkScanStlWriter::Stored(const std::vector<scan::Vec3>& points) const
{
  return this->Encoding == scan::Encoding::binary ? scan::roundedToFloat(points)
                                                  : std::vector<scan::Vec3>();
}

std::string vtkScanStlWriter::NoteOn(const scan::Model& model) const
{
  return this->Encoding == scan::Encoding::binary ? scan::noteOnRounding(model.points) : "";
}
