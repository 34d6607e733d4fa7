// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/align.h"

#include <string>

/// Moves the points of one of the files that make the model rigidly onto those of the others, and
/// turns their normals. See scan::align.
class SCANFILTERS_EXPORT vtkScanAlignFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanAlignFilter* New();
  vtkTypeMacro(vtkScanAlignFilter, vtkScanPolyDataFilter);
  vtkScanAlignFilter(const vtkScanAlignFilter&) = delete;
  void operator=(const vtkScanAlignFilter&) = delete;

  /// The file that moves: its number, counted from 1, or its name. Default: empty, the last one.
  void SetScan(const std::string& scan)
  {
    this->Scan = scan;
    this->Modified();
  }

  /// A place on the scan that moves, and where it belongs.
  void AddFrom(double x, double y, double z)
  {
    this->Options.from.push_back({ x, y, z });
    this->Modified();
  }
  void AddOnto(double x, double y, double z)
  {
    this->Options.onto.push_back({ x, y, z });
    this->Modified();
  }

  /// Move it to where it fits best, after the pairs. Default: true.
  void SetFit(bool fit)
  {
    this->Options.fit = fit;
    this->Modified();
  }

  /// Of the last run.
  const scan::AlignResult& GetResult() const { return this->Result; }
  std::size_t GetNumberOfPairs() const { return this->Options.from.size(); }
  const std::string& GetFileName() const { return this->FileName; } ///< of the file that moved

protected:
  vtkScanAlignFilter() = default;
  ~vtkScanAlignFilter() override = default;

  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  scan::Index FindScan(vtkPolyData& input) const;

  std::string Scan;
  scan::AlignOptions Options;
  scan::AlignResult Result;
  std::string FileName;
};
