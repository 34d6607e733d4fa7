// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanAutodesk3dsWriter.h"

#include "writers/autodesk_3ds.h"
#include "writers/single_precision.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanAutodesk3dsWriter);

void vtkScanAutodesk3dsWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeAutodesk3ds(model, file, execution);
}

std::vector<scan::Vec3> vtkScanAutodesk3dsWriter::Stored(
  const std::vector<scan::Vec3>& points) const
{
  return scan::roundedToFloat(points);
}

std::string vtkScanAutodesk3dsWriter::NoteOn(const scan::Model& model) const
{
  return scan::noteOnRounding(model.points);
}
