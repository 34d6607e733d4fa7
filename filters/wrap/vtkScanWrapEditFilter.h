// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/length.h"
#include "filters/base/vtkScanPolyDataFilter.h"
#include "filters/geometry/model_edit.h"
#include "filters/wrap/vtkScanWrapData.h"

#include <vector>

/// What an edit of a wrap did.
struct vtkScanWrapEditReport
{
  scan::Index Marks = 0; ///< triangles that were marked
  scan::EditReport Edit;
  scan::WrapReport Before; ///< of the wrap as it came
  scan::WrapReport After;
};

/// Base of the operations that edit a wrap. Input and output are vtkScanWrapData; the input stays
/// as it is and shares everything but its state with the output. A subclass writes Edit().
///
/// Marks are triangles of the surface: the one nearest to each point given, those given by
/// their number among the triangles, all that come nearer than Within to one of the points, and
/// those in the region.
class SCANFILTERS_EXPORT vtkScanWrapEditFilter : public vtkScanPolyDataFilter
{
public:
  vtkTypeMacro(vtkScanWrapEditFilter, vtkScanPolyDataFilter);
  vtkScanWrapEditFilter(const vtkScanWrapEditFilter&) = delete;
  void operator=(const vtkScanWrapEditFilter&) = delete;

  void AddPoint(double x, double y, double z)
  {
    this->Points.push_back({ x, y, z });
    this->Modified();
  }
  void AddTriangle(vtkIdType triangle)
  {
    this->Triangles.push_back(triangle);
    this->Modified();
  }

  /// Default 0: only the nearest triangle.
  void SetWithin(const scan::Length& within)
  {
    this->Within = within;
    this->Modified();
  }

  /// Split non-manifold edges and vertices of the surface. Default: true.
  vtkSetMacro(Manifold, bool);
  vtkGetMacro(Manifold, bool);
  vtkBooleanMacro(Manifold, bool);

  /// Only find out: the report is complete, the output equals the input. Default: false.
  vtkSetMacro(Preview, bool);
  vtkGetMacro(Preview, bool);
  vtkBooleanMacro(Preview, bool);

  const vtkScanWrapEditReport& GetReport() const { return this->Report; }

protected:
  vtkScanWrapEditFilter() = default;
  ~vtkScanWrapEditFilter() override = default;

  /// Gives the model, that of the input, a new state and fills Marks and Edit.
  virtual void Edit(vtkScanWrapData& wrap, scan::WrapModel& model, vtkScanWrapEditReport& report,
    scan::Execution& execution) = 0;

  /// All marks of the wrap's surface, those of FindTriangles() first. One given by a point is named
  /// from the tetrahedron on the side of the point.
  std::vector<scan::Facet> FindMarks(vtkScanWrapData& wrap, scan::Execution& execution) const;

  /// Those given as triangles and those in the region, if there is one.
  std::vector<scan::Facet> FindTriangles(vtkScanWrapData& wrap, scan::Execution& execution) const;

  /// For edits that take no marks for everywhere: whether there is a region and nothing in it.
  bool IsNowhere(const std::vector<scan::Facet>& marks) const
  {
    return marks.empty() && !this->GetRegion().empty();
  }

  const std::vector<scan::Vec3>& GetPoints() const { return this->Points; }

  vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input) override;
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  std::vector<scan::Vec3> Points;
  std::vector<vtkIdType> Triangles;
  scan::Length Within;
  bool Manifold = true;
  bool Preview = false;
  vtkScanWrapEditReport Report;
};
