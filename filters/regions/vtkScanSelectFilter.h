// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/base/vtkScanPolyDataFilter.h"

/// Gives a model a named region, in place of an earlier one of that name. What is kept is the rule:
/// it means the same on what becomes of the model, and a name in it stands for the rule that the
/// name has now. The output is of the input's type and shares all its arrays.
class SCANFILTERS_EXPORT vtkScanSelectFilter : public vtkScanPolyDataFilter
{
public:
  static vtkScanSelectFilter* New();
  vtkTypeMacro(vtkScanSelectFilter, vtkScanPolyDataFilter);
  vtkScanSelectFilter(const vtkScanSelectFilter&) = delete;
  void operator=(const vtkScanSelectFilter&) = delete;

  ///@{
  /// The name, see scan::isRegionName(), and the rule, see scan::parseRegionRule(). Both are
  /// needed.
  vtkSetMacro(Name, std::string);
  vtkGetMacro(Name, std::string);
  vtkSetMacro(Rule, std::string);
  vtkGetMacro(Rule, std::string);
  ///@}

  ///@{
  /// Of the last run: the rule as it was stored, what is in the region now, and its share of the
  /// triangles, of a model without triangles of the points.
  const std::string& GetStoredRule() const { return this->StoredRule; }
  vtkIdType GetPoints() const { return this->Points; }
  vtkIdType GetTriangles() const { return this->Triangles; }
  double GetShare() const { return this->Share; }
  ///@}

protected:
  vtkScanSelectFilter() = default;
  ~vtkScanSelectFilter() override = default;

  vtkSmartPointer<vtkPolyData> NewOutput(vtkPolyData* input) override; ///< of the input's type
  void Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution) override;

private:
  std::string Name;
  std::string Rule;
  std::string StoredRule;
  vtkIdType Points = 0;
  vtkIdType Triangles = 0;
  double Share = 0.0;
};
