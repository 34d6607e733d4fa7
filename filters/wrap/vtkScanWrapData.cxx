// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/wrap/vtkScanWrapData.h"

#include "filters/base/error.h"
#include "filters/base/vtkScanArrayNames.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/geometry/block_marks.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <limits>

vtkStandardNewMacro(vtkScanWrapData);

namespace
{

template <class Array>
vtkNew<Array> arrayOf(const char* name, vtkIdType size)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(size);
  return array;
}

} // namespace

void vtkScanWrapData::SetWrap(
  scan::WrapResult result, PointIds inputIds, bool withBlocks, scan::Execution& execution)
{
  scan::bridge::setMesh(*this, result.surface, result.lines);
  std::vector<vtkIdType> ids;
  ids.reserve(result.scanPointIds.size());
  for (const scan::Index id : result.scanPointIds)
  {
    ids.push_back((*inputIds)[id]);
  }
  scan::bridge::setScanPointIds(*this, ids);
  this->Report = result.report;
  this->Model = std::move(result.model);
  this->Facets = std::make_shared<const std::vector<scan::Facet>>(std::move(result.facets));
  this->InputIds = std::move(inputIds);
  this->Split = result.isSplit;
  this->Blocks = withBlocks && this->Model.scan;
  if (this->Blocks)
  {
    this->AddBlockArrays(static_cast<vtkIdType>(result.lines.size()), execution);
  }
}

void vtkScanWrapData::SetModel(const scan::WrapModel& model, PointIds inputIds, bool isSplit,
  bool withBlocks, const scan::WrapReport& kept, scan::Execution& execution)
{
  scan::WrapResult result = scan::surfaceOf(model, isSplit, execution);
  result.report.isOpen = kept.isOpen;
  result.report.openingTriangles = kept.openingTriangles;
  this->SetWrap(std::move(result), std::move(inputIds), withBlocks, execution);
}

void vtkScanWrapData::AddBlockArrays(vtkIdType lines, scan::Execution& execution)
{
  using namespace scan::arrays;
  const scan::Blocks& blocks = this->Model.scan->blocks(execution);
  const auto triangles = static_cast<vtkIdType>(this->Facets->size());
  const auto names = arrayOf<vtkIdTypeArray>(kBlock, lines + triangles);
  const auto sizes = arrayOf<vtkFloatArray>(kBlockSize, lines + triangles);
  const auto persistences = arrayOf<vtkFloatArray>(kBlockPersistence, lines + triangles);
  for (vtkIdType line = 0; line < lines; ++line)
  {
    names->SetValue(line, std::numeric_limits<vtkIdType>::min());
    sizes->SetValue(line, 0.0F);
    persistences->SetValue(line, 1.0F);
  }
  execution.parallelFor(this->Facets->size(), 1 << 14,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        const scan::BlockName block = blockBehind(this->Model, blocks, (*this->Facets)[t]);
        const vtkIdType cell = lines + static_cast<vtkIdType>(t);
        names->SetValue(cell, scan::numberOf(block));
        sizes->SetValue(cell, static_cast<float>(sizeOf(blocks, block)));
        persistences->SetValue(
          cell, block.isSheet ? 1.0F : static_cast<float>(blocks.persistence(block.name)));
      }
    });
  this->GetCellData()->AddArray(names);
  this->GetCellData()->AddArray(sizes);
  this->GetCellData()->AddArray(persistences);

  const scan::Index count = blocks.outside();
  const auto allSizes = arrayOf<vtkDoubleArray>(kBlockSizes, count);
  const auto allPersistences = arrayOf<vtkDoubleArray>(kBlockPersistences, count);
  const auto removed = arrayOf<vtkUnsignedCharArray>(kBlockRemoved, count);
  for (scan::Index block = 0; block < count; ++block)
  {
    const bool isKept = blocks.isVolume(block) && this->Model.current->keepsTet(blocks.sink(block));
    allSizes->SetValue(block, blocks.size(block));
    allPersistences->SetValue(block, blocks.persistence(block));
    removed->SetValue(block, isKept ? 0 : 1);
  }
  this->GetFieldData()->AddArray(allSizes);
  this->GetFieldData()->AddArray(allPersistences);
  this->GetFieldData()->AddArray(removed);
}

bool vtkScanWrapData::IsOwnArray(const std::string& name)
{
  using namespace scan::arrays;
  constexpr std::array kOwn{ kScanPointId, kBlock, kBlockSize, kBlockPersistence, kBlockSizes,
    kBlockPersistences, kBlockRemoved };
  return std::ranges::find(kOwn, name) != kOwn.end();
}

vtkScanWrapData& vtkScanWrapData::Of(vtkDataObject& data)
{
  auto* const wrap = vtkScanWrapData::SafeDownCast(&data);
  if (wrap == nullptr || !wrap->Model.scan)
  {
    throw scan::Error(scan::ErrorCode::badInput,
      "the model is no wrap that can be edited; put wrap before it, as in: wrap --mode=classic");
  }
  return *wrap;
}

void vtkScanWrapData::Initialize()
{
  this->Superclass::Initialize();
  this->Model = {};
  this->Facets = std::make_shared<const std::vector<scan::Facet>>();
  this->InputIds = nullptr;
  this->Report = {};
  this->Split = false;
  this->Blocks = false;
}

void vtkScanWrapData::ShallowCopy(vtkDataObject* source)
{
  this->Superclass::ShallowCopy(source);
  this->CopyModel(source);
}

void vtkScanWrapData::DeepCopy(vtkDataObject* source)
{
  this->Superclass::DeepCopy(source);
  this->CopyModel(source); // never changed, so it may be shared
}

void vtkScanWrapData::CopyModel(vtkDataObject* source)
{
  if (const auto* const wrap = vtkScanWrapData::SafeDownCast(source))
  {
    this->Model = wrap->Model;
    this->Facets = wrap->Facets;
    this->InputIds = wrap->InputIds;
    this->Report = wrap->Report;
    this->Split = wrap->Split;
    this->Blocks = wrap->Blocks;
  }
}
