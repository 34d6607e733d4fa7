// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/wrap.h"

/// Surface of a scan from its points alone: no normals, no density, no parameter to set.
///
/// The points of the input are used, its cells are not. The output is a vtkScanWrapData with the
/// triangles, in classic mode the left-over lines and the arrays of blocks, and the ScanPointId
/// array; other arrays of the input are dropped. Where the input is a wrap, all points of its scan
/// are wrapped, and their complex is used again. Of a region only its points are wrapped. See
/// scan::wrap for the guarantees.
class SCANFILTERS_EXPORT vtkScanWrapFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanWrapFilter* New();
  vtkTypeMacro(vtkScanWrapFilter, vtkScanPolyDataFilter);
  vtkScanWrapFilter(const vtkScanWrapFilter&) = delete;
  void operator=(const vtkScanWrapFilter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    AUTOMATIC, ///< the finished surface (default)
    CLASSIC,   ///< the initial Wrap complex, the start for pushing by hand
    FRONT      ///< CGAL's advancing front over the same points, for comparison
  };
  vtkSetEnumMacro(Mode, ModeType);
  vtkGetEnumMacro(Mode, ModeType);

  enum FitType
  {
    ALL,   ///< through as many points as possible (default)
    ROBUST ///< smoother on noisy scans
  };
  vtkSetEnumMacro(Fit, FitType);
  vtkGetEnumMacro(Fit, FitType);

  enum OpenType
  {
    DECIDE, ///< open where that makes the better surface (default)
    KEEP,   ///< true openings stay open
    CAP     ///< always closed
  };
  vtkSetEnumMacro(Open, OpenType);
  vtkGetEnumMacro(Open, OpenType);

  /// Classic mode: what opens to the outside through doors wider than this radius is removed, and
  /// webs that are wider. Default 0: nothing.
  void SetSize(const scan::Length& size)
  {
    this->Size = size;
    this->Modified();
  }

  /// Classic mode, for programs that wait for a person: also make what edits of many blocks need,
  /// so that the first push is as fast as all others. Changes no result; takes three quarters of
  /// the wrap's time more. Default: false, which makes it once edits have taken as long.
  vtkSetMacro(PrepareEdits, bool);
  vtkGetMacro(PrepareEdits, bool);
  vtkBooleanMacro(PrepareEdits, bool);

  /// Split non-manifold edges and vertices into separate sheets. Default: true.
  vtkSetMacro(Manifold, bool);
  vtkGetMacro(Manifold, bool);
  vtkBooleanMacro(Manifold, bool);

  /// What the last run did with the points.
  const scan::WrapReport& GetReport() const { return this->Report; }

protected:
  vtkScanWrapFilter() = default;
  ~vtkScanWrapFilter() override = default;

  vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input) override;
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  /// The points to wrap of a scan.
  vtkSmartPointer<vtkPolyData> ChoosePoints(vtkPolyData& scan, scan::Execution& execution) const;

  ModeType Mode = AUTOMATIC;
  FitType Fit = ALL;
  OpenType Open = DECIDE;
  scan::Length Size;
  bool PrepareEdits = false;
  bool Manifold = true;
  scan::WrapReport Report;
};
