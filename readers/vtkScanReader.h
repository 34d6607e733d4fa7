// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanReadersModule.h" // export macro
#include "filters/base/vtkScanTask.h"
#include "filters/geometry/model.h"

#include <vtkAbstractPolyDataReader.h>

#include <span>
#include <string_view>

/// Base of the readers: opens the file, guards the parser, makes its model a vtkPolyData with
/// double points. A subclass names its parser in Parse(). FileName "-" is standard input.
class SCANREADERS_EXPORT vtkScanReader
  : public vtkAbstractPolyDataReader
  , public vtkScanTask
{
public:
  vtkTypeMacro(vtkScanReader, vtkAbstractPolyDataReader);
  vtkScanReader(const vtkScanReader&) = delete;
  void operator=(const vtkScanReader&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum class Content
  {
    automatic, ///< what the file holds
    points,    ///< the points only, as a scan
    mesh       ///< a file without triangles is an error
  };

  ///@{
  /// What to take from the file. Default: automatic.
  vtkSetEnumMacro(ReadAs, Content);
  vtkGetEnumMacro(ReadAs, Content);
  ///@}

protected:
  vtkScanReader() = default;
  ~vtkScanReader() override = default;

  /// The model in the bytes of the file `name`. Throws scan::Error. Phase "read".
  virtual scan::Model Parse(
    std::span<const char> bytes, std::string_view name, scan::Execution& execution) const = 0;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) final;

private:
  scan::Model Read(scan::Execution& execution) const;

  Content ReadAs = Content::automatic;
};
