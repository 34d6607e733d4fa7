// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanTask.h"

#include <vtkPolyDataAlgorithm.h>

#include <string>

namespace scan
{

/// Appends what another file holds to its input. See appendModel(). It is here and not among the
/// filters as it reads any format.
class MergeFile
  : public vtkPolyDataAlgorithm
  , public vtkScanTask
{
public:
  static MergeFile* New();
  vtkTypeMacro(MergeFile, vtkPolyDataAlgorithm);
  MergeFile(const MergeFile&) = delete;
  void operator=(const MergeFile&) = delete;

  vtkSetMacro(Path, std::string);
  vtkGetMacro(Path, std::string);

  ///@{
  /// Of the last run: points of the model.
  vtkIdType GetPointsBefore() const { return this->PointsBefore; }
  vtkIdType GetPointsAfter() const { return this->PointsAfter; }
  ///@}

protected:
  MergeFile() = default;
  ~MergeFile() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Merge(vtkPolyData& input, vtkPolyData& output, Execution& execution);

  std::string Path;
  vtkIdType PointsBefore = 0;
  vtkIdType PointsAfter = 0;
};

} // namespace scan
