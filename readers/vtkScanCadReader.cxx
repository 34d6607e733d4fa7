// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtkScanCadReader.h"

#include "readers/cad.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkScanCadReader);

void vtkScanCadReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "RelativeTolerance: " << this->RelativeTolerance << "\n";
}

scan::Model vtkScanCadReader::Parse(
  std::span<const char> bytes, std::string_view name, scan::Execution& execution) const
{
  const scan::CadOptions options{ .deflection = this->Tolerance,
    .relativeDeflection = this->RelativeTolerance };
  if (scan::looksLikeStep(bytes))
  {
    return scan::parseStep(bytes, name, options, execution);
  }
  if (scan::looksLikeIges(bytes))
  {
    return scan::parseIges(bytes, name, options, execution);
  }
  throw scan::Error(scan::ErrorCode::parse,
    std::string(name) + ": neither a STEP nor an IGES file; export it again from the CAD program");
}
