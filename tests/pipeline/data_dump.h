// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/wrap/vtkScanWrapData.h"
#include "pipeline/hash.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cstring>
#include <string>

/// Every byte of a model, written out without the code that stores models: two models are the same
/// exactly when their dumps are.
class DataDump
{
public:
  explicit DataDump(vtkPolyData& model)
  {
    this->Text = model.GetClassName();
    if (model.GetPoints() != nullptr)
    {
      this->add("points", *model.GetPoints()->GetData());
    }
    for (vtkCellArray* cells :
      { model.GetVerts(), model.GetLines(), model.GetPolys(), model.GetStrips() })
    {
      this->add("offsets", *cells->GetOffsetsArray());
      this->add("connectivity", *cells->GetConnectivityArray());
    }
    this->addAttributes(*model.GetPointData());
    this->addAttributes(*model.GetCellData());
    this->addArrays(*model.GetFieldData());
    if (auto* const wrap = vtkScanWrapData::SafeDownCast(&model);
        wrap != nullptr && wrap->GetModel().scan)
    {
      this->addWrap(*wrap);
    }
  }

  const std::string& text() const { return this->Text; }
  scan::Hash hash() const { return scan::hashOf(this->Text); }

private:
  template <class Values>
  void addValues(const Values& values)
  {
    this->Text += "[" + std::to_string(std::size(values)) + "]";
    this->Text.append(reinterpret_cast<const char*>(std::data(values)),
      std::size(values) * sizeof(*std::data(values)));
  }

  void add(const std::string& name, vtkDataArray& array)
  {
    this->Text += "\n" + name + " " + array.GetDataTypeAsString() + " " +
      std::to_string(array.GetDataType()) + " " + std::to_string(array.GetNumberOfComponents()) +
      " " + std::to_string(array.GetNumberOfTuples()) + " ";
    this->Text.append(static_cast<const char*>(array.GetVoidPointer(0)),
      static_cast<std::size_t>(array.GetNumberOfValues() * array.GetDataTypeSize()));
  }

  void addArrays(vtkFieldData& data)
  {
    for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data.GetAbstractArray(i);
      if (auto* const numbers = vtkDataArray::SafeDownCast(array))
      {
        this->add(array->GetName(), *numbers);
      }
      else if (auto* const texts = vtkStringArray::SafeDownCast(array))
      {
        this->Text += std::string("\n") + array->GetName();
        for (vtkIdType t = 0; t < texts->GetNumberOfValues(); ++t)
        {
          this->Text += "|" + texts->GetValue(t);
        }
      }
    }
  }

  void addAttributes(vtkDataSetAttributes& data)
  {
    this->addArrays(data);
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      vtkAbstractArray* const active = data.GetAbstractAttribute(type);
      this->Text += std::string("\n") + (active != nullptr ? active->GetName() : "-");
    }
  }

  void addWrap(vtkScanWrapData& wrap)
  {
    const scan::WrapModel& model = wrap.GetModel();
    const scan::DelaunayComplex& complex = model.scan->delaunay();
    this->addValues(complex.points);
    this->addValues(complex.scanPoint);
    this->addValues(complex.tetrahedra);
    this->addValues(complex.mirror);
    this->addValues(model.scan->basins().ofTet);
    this->addValues(model.start->bytes());
    this->addValues(model.current->bytes());
    this->addValues(*model.lines);
    this->addValues(wrap.GetFacets());
    this->addValues(*wrap.GetInputIds());
    if (model.inside)
    {
      this->addValues(*model.inside);
    }
    const scan::WrapReport& report = wrap.GetReport();
    for (const scan::Index number :
      { complex.duplicates, scan::Index{ model.isSolid }, scan::Index{ wrap.IsSplit() },
        scan::Index{ wrap.HasBlocks() }, scan::Index{ model.start->followsFlow() },
        scan::Index{ model.current->followsFlow() }, report.pointsRead, report.duplicatesMerged,
        report.pointsOnSurface, report.tetrahedra, report.tetrahedraKept, report.boundaryTriangles,
        report.sheetTriangles, scan::Index{ report.isOpen }, report.openingTriangles,
        report.nonManifoldEdges, report.nonManifoldVertices })
    {
      this->Text.append(" ").append(std::to_string(number));
    }
  }

  std::string Text;
};
