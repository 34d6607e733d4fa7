// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanGlbWriter.h"

#include "filters/base/note.h"
#include "writers/glb.h"
#include "writers/single_precision.h"
#include "writers/unit_note.h"
#include "writers/used_points.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanGlbWriter);

scan::FormatTraits vtkScanGlbWriter::Traits(const scan::Model& model) const
{
  return { .precision = scan::Precision::float32,
    .origin = scan::originForFloats(scan::shapePoints(model)) };
}

void vtkScanGlbWriter::Format(const scan::Model& model, const scan::FormatTraits& traits,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeGlb(model, traits.origin, file, execution);
}

std::string vtkScanGlbWriter::NoteOn(const scan::Model& model) const
{
  std::string note = scan::noteOnUnit(model);
  if (model.curves.size() > scan::kMostGlbCurves)
  {
    scan::addToNote(note,
      std::to_string(model.curves.size()) +
        " curves are written as loose segments, which glTF programs draw faster");
  }
  return note;
}
