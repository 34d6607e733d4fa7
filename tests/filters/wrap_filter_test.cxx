// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/wrap/vtkScanPushFilter.h"
#include "filters/wrap/vtkScanWrapFilter.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace scan;
using State = vtkScanOutcome::State;

namespace
{

/// A tube, closed by nothing: its hollow is one room after another.
vtkSmartPointer<vtkPolyData> tube()
{
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  TriMesh mesh;
  for (int i = 0; i < 2000; ++i)
  {
    const double angle = 2.0 * std::numbers::pi * at(random);
    mesh.points.push_back({ std::cos(angle), std::sin(angle), 6.0 * at(random) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  bridge::setMesh(*data, mesh);
  return data;
}

TEST(WrapFilter, WhatIsPreparedForEditsIsEditedTheSame)
{
  std::vector<TriMesh> wraps;
  std::vector<TriMesh> pushed;
  for (const bool isPrepared : { false, true })
  {
    vtkNew<vtkScanWrapFilter> wrap;
    wrap->SetInputData(tube());
    wrap->SetMode(vtkScanWrapFilter::CLASSIC);
    wrap->SetPrepareEdits(isPrepared);
    vtkNew<vtkScanPushFilter> push;
    push->SetInputConnection(wrap->GetOutputPort());
    push->AddPoint(0.0, 0.0, -1.0);
    push->DeepOn();
    push->Update();
    ASSERT_EQ(wrap->GetOutcome().state, State::ok) << wrap->GetOutcome().message;
    ASSERT_EQ(push->GetOutcome().state, State::ok) << push->GetOutcome().message;
    EXPECT_GT(push->GetPushReport().blocks.size(), 1U);
    wraps.push_back(bridge::meshOf(*wrap->GetOutput()));
    pushed.push_back(bridge::meshOf(*push->GetOutput()));
  }
  EXPECT_EQ(wraps[0].triangles, wraps[1].triangles);
  EXPECT_EQ(pushed[0].triangles, pushed[1].triangles);
  EXPECT_NE(wraps[0].triangles, pushed[0].triangles);
}

} // namespace
