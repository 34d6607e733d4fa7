// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/mend.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Finds what is wrong with a surface and repairs it. See scan::mend. A region means the defects
/// with a triangle in it.
class SCANFILTERS_EXPORT vtkScanMendFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanMendFilter* New();
  vtkTypeMacro(vtkScanMendFilter, vtkScanSurfaceFilter);
  vtkScanMendFilter(const vtkScanMendFilter&) = delete;
  void operator=(const vtkScanMendFilter&) = delete;

  /// What to look for and repair. Default: all kinds.
  void SetKinds(const scan::DefectKinds& kinds)
  {
    this->Options.defects.kinds = kinds;
    this->Modified();
  }

  /// Repairs nothing: the output is the input, with a region for each kind of defect that there is
  /// and, for points and triangles, the arrays Defect (the number of the first kind, from 1; 0:
  /// none) and Defect-KIND (1 in such a defect). Results say what would be done. Default: false.
  void SetMark(bool mark)
  {
    this->Mark = mark;
    this->Modified();
  }

  /// Repairs only the defect nearest to there. Default: all.
  void SetPlace(double x, double y, double z)
  {
    this->Options.at = scan::Vec3{ x, y, z };
    this->Modified();
  }

  /// Lower triangles are degenerate. Default: a millionth of the box diagonal.
  void SetLeastHeight(const scan::Length& height)
  {
    this->LeastHeight = height;
    this->Modified();
  }

  /// Height of a spike over the mean radius of its neighbours, above 0. Default: 2.
  void SetSpikeRatio(double ratio)
  {
    this->Options.defects.spikeRatio = ratio;
    this->Modified();
  }

  /// Per cent of the triangles and of the area of the largest piece that a small one has less than,
  /// 0 to 100. Default: 1.
  void SetSmallComponent(double percent)
  {
    this->Options.defects.smallComponent = percent / 100.0;
    this->Modified();
  }

  /// Longest rim of a small hole. Default: ten times the mean spacing.
  void SetSmallHole(const scan::Length& rim)
  {
    this->SmallHole = rim;
    this->Modified();
  }

  /// Of the last run, without the surface.
  const scan::MendResult& GetResult() const { return this->Result; }

protected:
  vtkScanMendFilter() = default;
  ~vtkScanMendFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;
  void Finish(vtkPolyData& output) override;

private:
  scan::MendOptions Options;
  scan::Length LeastHeight = scan::Length(1e-4, scan::Length::Unit::diagonalPercent);
  scan::Length SmallHole = scan::Length(10.0, scan::Length::Unit::spacing);
  bool Mark = false;
  scan::MendResult Result;
};
