// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanThreemfWriter.h"

#include "filters/geometry/half_edges.h"
#include "writers/single_precision.h"
#include "writers/threemf.h"
#include "writers/unit_note.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanThreemfWriter);

void vtkScanThreemfWriter::Format(
  const scan::Model& model, scan::OutputFile& file, scan::Execution& execution) const
{
  scan::writeThreemf(model, file, execution);
}

std::vector<scan::Vec3> vtkScanThreemfWriter::Stored(const std::vector<scan::Vec3>& points) const
{
  return scan::roundedToFloat(points, scan::originForFloats(points));
}

std::string vtkScanThreemfWriter::NoteOn(const scan::Model& model) const
{
  const std::string unit = scan::noteOnUnit(model);
  const scan::Index open = scan::pairEdges(model).boundaryEdges;
  return open == 0 ? unit
                   : unit + (unit.empty() ? "" : "; ") + "the surface is open at " +
      std::to_string(open) + " edges, and 3MF is for solids: programs may close or refuse it";
}
