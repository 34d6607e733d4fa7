// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtkScanWriter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "writers/consistent_model.h"
#include "writers/output_file.h"
#include "writers/single_precision.h"
#include "writers/used_points.h"

#include <vtkInformation.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{

scan::Model consistentModelFor(const scan::OutputFile& file, scan::Model model,
  const scan::FormatTraits& traits, scan::Execution& execution)
{
  const std::size_t before = model.triangles.size();
  scan::Model result = scan::consistentModel(std::move(model), traits, execution);
  const bool isCoarse = traits.precision != scan::Precision::float64 || traits.leastHeight > 0.0;
  if (before > 0 && result.triangles.empty() && isCoarse)
  {
    throw scan::Error(scan::ErrorCode::badInput,
      file.name() + ": none of the " + std::to_string(before) +
        " triangles has an area in the digits of the format; write PLY, OBJ or ascii STL");
  }
  return result;
}

std::string noteOnLoosePoints(const scan::Model& model, const scan::FormatTraits& traits)
{
  if (traits.hasLoosePoints || model.isScan())
  {
    return {};
  }
  const std::vector<bool> isUsed =
    scan::usedPoints(model.triangles, model.curves, model.points.size());
  const auto loose = std::ranges::count(isUsed, false);
  return loose == 0
    ? ""
    : std::to_string(loose) + (loose == 1 ? " point" : " points") + " that nothing uses left out";
}

} // namespace

void vtkScanWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << (this->Encoding == scan::Encoding::ascii ? "ascii" : "binary")
     << "\n";
  os << indent << "Consistent: " << (this->Consistent ? "On" : "Off") << "\n";
}

int vtkScanWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkScanWriter::WriteFile(
  vtkDataObject& input, scan::OutputFile& file, scan::Execution& execution)
{
  scan::Model model = scan::bridge::modelOf(*vtkPolyData::SafeDownCast(&input));
  const scan::FormatTraits traits = this->Traits(model);
  if (this->Consistent && traits.hasTriangles)
  {
    model = consistentModelFor(file, std::move(model), traits, execution);
  }
  model.addNote(noteOnLoosePoints(model, traits));
  if (traits.precision != scan::Precision::float64 && traits.origin == scan::Vec3{})
  {
    model.addNote(scan::noteOnRounding(scan::shapePoints(model)));
  }
  model.addNote(this->NoteOn(model));
  this->AddNote(model.note);
  try
  {
    this->Format(model, traits, file, execution);
  }
  catch (const scan::Error& error)
  {
    throw model.note.empty() ? error
                             : scan::Error(error.code(), error.what() + (" (" + model.note + ")"));
  }
}

scan::FormatTraits vtkScanWriter::Traits(const scan::Model&) const
{
  return {};
}

std::string vtkScanWriter::NoteOn(const scan::Model&) const
{
  return {};
}
