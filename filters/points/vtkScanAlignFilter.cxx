// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/points/vtkScanAlignFilter.h"

#include "filters/base/vtkScanMeshBridge.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>

vtkStandardNewMacro(vtkScanAlignFilter);

scan::Index vtkScanAlignFilter::FindScan(vtkPolyData& input) const
{
  const std::vector<scan::bridge::ScanFile> files = scan::bridge::scanFilesOf(input);
  if (files.size() < 2)
  {
    throw scan::Error(scan::ErrorCode::badInput,
      "the model comes from a single file; open the scans to align together");
  }
  std::string known;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    const std::string number = std::to_string(i + 1);
    if (this->Scan == number || this->Scan == files[i].name ||
      (this->Scan.empty() && i + 1 == files.size()))
    {
      return static_cast<scan::Index>(i);
    }
    known += (known.empty() ? "" : ", ") + number + " " + files[i].name;
  }
  throw scan::Error(scan::ErrorCode::badParameter,
    "there is no scan " + this->Scan + "; the model comes from " + known);
}

void vtkScanAlignFilter::Run(vtkPolyData& input, vtkPolyData& output, scan::Execution& execution)
{
  execution.plan({ { "neighbours", 1.0 }, { "fit", 2.0 } });
  execution.step("neighbours", 0, 1);
  const scan::Index moving = this->FindScan(input);
  this->FileName = scan::bridge::scanFilesOf(input)[moving].name;
  const std::vector<scan::Index> files = scan::bridge::scanFileOfPoints(input);
  std::vector<scan::Vec3> points = scan::bridge::pointsOf(input);
  std::vector<scan::Vec3> normals = scan::bridge::normalsOf(input);
  std::vector<scan::Vec3> own;
  std::vector<scan::Vec3> others;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    (files[i] == moving ? own : others).push_back(points[i]);
  }
  this->Result = scan::align(own, others, this->Options, execution);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (files[i] == moving)
    {
      points[i] = this->Result.motion.point(points[i]);
      if (!normals.empty())
      {
        normals[i] = this->Result.motion.normal(normals[i]);
      }
    }
  }
  scan::bridge::movePoints(input, points, output);
  if (!normals.empty())
  {
    scan::bridge::setNormals(output, normals);
  }
  if (!this->Options.fit && this->Options.from.empty())
  {
    this->AddNote("nothing changed");
  }
  else if (this->Options.fit && !this->Result.isSettled)
  {
    this->AddNote("the fit did not come to rest; repeat it, or pick pairs");
  }
}
