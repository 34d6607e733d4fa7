// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanThreemfWriter.h"

#include "filters/base/note.h"
#include "filters/geometry/half_edges.h"
#include "writers/single_precision.h"
#include "writers/threemf.h"
#include "writers/unit_note.h"
#include "writers/used_points.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanThreemfWriter);

scan::FormatTraits vtkScanThreemfWriter::Traits(const scan::Model& model) const
{
  return { .hasLoosePoints = false,
    .precision = scan::Precision::float64ReadAsFloat32,
    .origin = scan::originForFloats(scan::shapePoints(model)) };
}

void vtkScanThreemfWriter::Format(const scan::Model& model, const scan::FormatTraits& traits,
  scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeThreemf(model, traits.origin, file, execution);
}

std::string vtkScanThreemfWriter::NoteOn(const scan::Model& model) const
{
  std::string note = scan::noteOnUnit(model);
  if (const scan::Index open = scan::pairEdges(model).boundaryEdges; open > 0)
  {
    scan::addToNote(note,
      "the surface is open at " + std::to_string(open) +
        " edges, and 3MF is for solids: programs may close or refuse it");
  }
  return note;
}
