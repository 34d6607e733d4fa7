// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScanFiltersModule.h" // export macro
#include "filters/geometry/wrap.h"

#include <vtkPolyData.h>

#include <memory>
#include <string>
#include <vector>

/// The surface of a wrap together with the complex it was cut from, so that it can be edited:
/// pushed, pulled, fine-tuned. Copies share the complex. Any filter that moves or changes the
/// surface makes plain vtkPolyData of it.
///
/// Cell data, one value a triangle (and before them one a line, without a meaning):
/// - Block: the volume block behind the triangle by its number, a sheet block as -1 - facet;
/// - BlockSize: the radius of the block's critical simplex, in model units;
/// - BlockPersistence: death / birth radius of a volume block, 1 for sheets.
/// Field data, one value a block number, where cell data are there: BlockSizes,
/// BlockPersistences, BlockRemoved (1: the block is gone or never was kept).
class SCANFILTERS_EXPORT vtkScanWrapData : public vtkPolyData
{
public:
  static vtkScanWrapData* New();
  vtkTypeMacro(vtkScanWrapData, vtkPolyData);
  vtkScanWrapData(const vtkScanWrapData&) = delete;
  void operator=(const vtkScanWrapData&) = delete;

  using PointIds = std::shared_ptr<const std::vector<vtkIdType>>;

  /// Makes this the surface of the result.
  /// @param inputIds the scan-point ids of the points that were wrapped
  /// @param withBlocks adds the arrays above; takes a while the first time for a complex
  void SetWrap(
    scan::WrapResult result, PointIds inputIds, bool withBlocks, scan::Execution& execution);

  /// The model; without a complex when SetWrap() was never called.
  const scan::WrapModel& GetModel() const { return this->Model; }

  /// Makes this the surface of a model that was kept, the same bytes as when it was made.
  /// @param kept what the report of the wrap said, of which isOpen and openingTriangles are used
  /// @param isSplit, withBlocks as IsSplit() and HasBlocks() were
  void SetModel(const scan::WrapModel& model, PointIds inputIds, bool isSplit, bool withBlocks,
    const scan::WrapReport& kept, scan::Execution& execution);

  bool IsSplit() const { return this->Split; }    ///< what is no manifold was split into sheets
  bool HasBlocks() const { return this->Blocks; } ///< the arrays of blocks are there

  /// Per triangle its facet in the complex.
  const std::vector<scan::Facet>& GetFacets() const { return *this->Facets; }
  const scan::WrapReport& GetReport() const { return this->Report; }
  const PointIds& GetInputIds() const { return this->InputIds; }

  /// Whether an array of that name comes with the surface, and need not be kept beside the model.
  static bool IsOwnArray(const std::string& name);

  /// The wrap behind a data set that may be something else.
  /// @throws scan::Error when it is no wrap
  static vtkScanWrapData& Of(vtkDataObject& data);

  void Initialize() override;
  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;

protected:
  vtkScanWrapData() = default;
  ~vtkScanWrapData() override = default;

private:
  void CopyModel(vtkDataObject* source);
  void AddBlockArrays(vtkIdType lines, scan::Execution& execution);

  scan::WrapModel Model;
  std::shared_ptr<const std::vector<scan::Facet>> Facets =
    std::make_shared<const std::vector<scan::Facet>>();
  PointIds InputIds;
  scan::WrapReport Report;
  bool Split = false;
  bool Blocks = false;
};
