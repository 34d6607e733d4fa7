// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/geometry/relax.h"
#include "filters/surface/vtkScanSurfaceFilter.h"

/// Takes noise out of a surface by moving its points, in the region alone. See scan::relax.
class SCANFILTERS_EXPORT vtkScanRelaxFilter : public vtkScanSurfaceFilter
{
public:
  static vtkScanRelaxFilter* New();
  vtkTypeMacro(vtkScanRelaxFilter, vtkScanSurfaceFilter);
  vtkScanRelaxFilter(const vtkScanRelaxFilter&) = delete;
  void operator=(const vtkScanRelaxFilter&) = delete;

  /// Pairs of steps, 1 or more. Default: 50.
  void SetIterations(int iterations)
  {
    this->Options.iterations = iterations;
    this->Modified();
  }

  /// Of the first step of a pair, above 0 and at most 1. Default: 0.7.
  void SetLambda(double lambda)
  {
    this->Options.lambda = lambda;
    this->Modified();
  }

  /// Of the second step, a little below -lambda. Default: -0.705.
  void SetMu(double mu)
  {
    this->Options.mu = mu;
    this->Modified();
  }

  /// Default: keep.
  void SetBoundary(scan::RelaxOptions::Boundary boundary)
  {
    this->Options.boundary = boundary;
    this->Modified();
  }

  /// Degrees, 0 to 180. Edges that bend by more stay sharp. Default: 0, none.
  void SetKeepFeatures(double angle)
  {
    this->Options.featureAngle = angle;
    this->Modified();
  }

  /// Of the last run, without the points.
  const scan::RelaxResult& GetResult() const { return this->Result; }

protected:
  vtkScanRelaxFilter() = default;
  ~vtkScanRelaxFilter() override = default;

  std::vector<scan::Phase> Phases() const override;
  scan::SurfaceEdit Edit(const Surface& surface, scan::Execution& execution) override;

private:
  scan::RelaxOptions Options;
  scan::RelaxResult Result;
};
