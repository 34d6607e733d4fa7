// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanRenderFilter.h"

#include "filters/base/vtkScanMeshBridge.h"
#include "tests/geometry/mesh_corpus.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

using namespace scan;
using State = vtkScanOutcome::State;

namespace
{

/// No test has a display.
class Render : public testing::Test
{
protected:
  void SetUp() override { unsetenv("DISPLAY"); }
};

struct Pixel
{
  int red, green, blue;
};

/// A small picture on black, so that what is not black is the model.
class Shot
{
public:
  explicit Shot(const TriMesh& mesh)
  {
    vtkNew<vtkPolyData> data;
    bridge::setMesh(*data, mesh);
    this->Filter->SetInputData(data);
    this->Filter->SetWidth(240);
    this->Filter->SetHeight(160);
    this->Filter->SetBackground("black");
  }

  vtkScanRenderFilter* operator->() { return this->Filter; }

  vtkImageData& take()
  {
    this->Filter->Update();
    EXPECT_EQ(this->Filter->GetOutcome().state, State::ok) << this->Filter->GetOutcome().message;
    return *this->Filter->GetOutput();
  }

  std::vector<unsigned char> bytes()
  {
    vtkImageData& image = this->take();
    const auto* first = static_cast<const unsigned char*>(image.GetScalarPointer());
    return { first, first + 3 * image.GetNumberOfPoints() };
  }

  Pixel at(int x, int y)
  {
    const auto* pixel = static_cast<const unsigned char*>(this->take().GetScalarPointer(x, y, 0));
    return { pixel[0], pixel[1], pixel[2] };
  }

  /// Smallest box of the pixels that are not black: left, right, bottom, top.
  std::array<int, 4> box()
  {
    const std::vector<unsigned char> pixels = this->bytes();
    const int* size = this->Filter->GetOutput()->GetDimensions();
    std::array<int, 4> box = { size[0], -1, size[1], -1 };
    for (int i = 0; i < size[0] * size[1]; ++i)
    {
      if (pixels[3 * i] + pixels[3 * i + 1] + pixels[3 * i + 2] > 0)
      {
        box = { std::min(box[0], i % size[0]), std::max(box[1], i % size[0]),
          std::min(box[2], i / size[0]), std::max(box[3], i / size[0]) };
      }
    }
    return box;
  }

private:
  vtkNew<vtkScanRenderFilter> Filter;
};

TriMesh moved(TriMesh mesh, const Vec3& by)
{
  for (Vec3& p : mesh.points)
  {
    p = p + by;
  }
  return mesh;
}

} // namespace

TEST_F(Render, HasTheSizeAskedForAndFillsThePicture)
{
  Shot shot(corpus::torus(32));
  shot->SetView(vtkScanRenderFilter::TOP);
  const std::array<int, 4> box = shot.box();
  EXPECT_EQ(shot.take().GetDimensions()[0], 240);
  EXPECT_EQ(shot.take().GetDimensions()[1], 160);
  EXPECT_EQ(shot.take().GetNumberOfScalarComponents(), 3);
  EXPECT_NEAR(box[0] + box[1], 239, 3); // in the middle
  EXPECT_NEAR(box[2] + box[3], 159, 3);
  EXPECT_NEAR(box[3] - box[2], 0.94 * 160, 4); // but for the margin
  EXPECT_EQ(shot.at(120, 80).red, 0);          // the hole of the torus
}

TEST_F(Render, GivesTheSameBytesAgainWhateverTheDisplay)
{
  const std::vector<unsigned char> first = Shot(corpus::torus(32)).bytes();
  setenv("DISPLAY", ":987", 1);
  EXPECT_TRUE(Shot(corpus::torus(32)).bytes() == first);
}

TEST_F(Render, LooksTheSameFarFromTheOrigin)
{
  Shot near(corpus::torus(32));
  Shot far(moved(corpus::torus(32), { 1048576.0, -4194304.0, 1024.0 }));
  EXPECT_TRUE(near.box() == far.box());
}

TEST_F(Render, DrawsPointsWithoutTriangles)
{
  TriMesh cloud = corpus::torus(64);
  cloud.triangles.clear();
  Shot shot(cloud);
  shot->SetView(vtkScanRenderFilter::TOP);
  shot->SetPointSize(2.0);
  const std::array<int, 4> box = shot.box();
  EXPECT_NEAR(box[3] - box[2], 0.94 * 160, 6);
  cloud.points.resize(1);
  const std::array<int, 4> single = Shot(cloud).box();
  EXPECT_NEAR(single[0] + single[1], 239, 3);
  EXPECT_NEAR(single[2] + single[3], 159, 3);
}

TEST_F(Render, DrawsLines)
{
  vtkNew<vtkPolyData> data;
  const std::vector<Segment> lines = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
  bridge::setMesh(*data, { corpus::square().points, {} }, lines);
  Shot shot({});
  shot->SetInputData(data);
  shot->SetView(vtkScanRenderFilter::TOP);
  shot->SetColor("white");
  EXPECT_EQ(shot.at(120, 80).red, 0); // open inside
  EXPECT_NEAR(shot.box()[3] - shot.box()[2], 0.94 * 160, 4);
}

TEST_F(Render, ShowsBacksInAnotherColour)
{
  Shot front(corpus::square());
  front->SetView(vtkScanRenderFilter::TOP);
  front->SetColor("#ff0000");
  Shot back(corpus::square());
  back->SetView(vtkScanRenderFilter::BOTTOM);
  back->SetColor("#ff0000");
  EXPECT_GT(front.at(120, 80).red, 100);
  EXPECT_LT(front.at(120, 80).blue, 40);
  EXPECT_GT(back.at(120, 80).blue, back.at(120, 80).red);
}

TEST_F(Render, KnowsItsViews)
{
  // a square in the xz plane that faces -y
  const TriMesh wall = { { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 1 }, { 0, 0, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  Shot front(wall);
  front->SetView(vtkScanRenderFilter::FRONT);
  front->SetColor("red");
  EXPECT_GT(front.at(120, 80).red, 100);
  Shot side(wall);
  side->SetView(vtkScanRenderFilter::RIGHT);
  EXPECT_LE(side.box()[1] - side.box()[0], 2); // seen edge on
  Shot yUp(corpus::square());                  // in the xy plane, faces +z
  yUp->SetView(vtkScanRenderFilter::FRONT);
  yUp->SetUp(vtkScanRenderFilter::Y_UP);
  yUp->SetColor("red");
  EXPECT_GT(yUp.at(120, 80).red, 100);
}

TEST_F(Render, EdgesAndProjectionChangeThePicture)
{
  const std::vector<unsigned char> plain = Shot(corpus::torus(12)).bytes();
  Shot edges(corpus::torus(12));
  edges->EdgesOn();
  EXPECT_FALSE(edges.bytes() == plain);
  Shot parallel(corpus::torus(12));
  parallel->PerspectiveOff();
  EXPECT_FALSE(parallel.bytes() == plain);
}

TEST_F(Render, RefusesAnEmptyModelAndBadParameters)
{
  const auto messageOf = [](Shot& shot)
  {
    vtkNew<vtkTest::ErrorObserver> errors;
    shot->AddObserver(vtkCommand::ErrorEvent, errors);
    shot->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    shot->Update();
    EXPECT_EQ(shot->GetOutcome().state, State::failed);
    return shot->GetOutcome().message;
  };
  Shot empty({});
  EXPECT_EQ(messageOf(empty), "picture: the model has no points to show");
  Shot huge(corpus::square());
  huge->SetWidth(100000);
  EXPECT_NE(messageOf(huge).find("16 to 4096"), std::string::npos);
  Shot oddColor(corpus::square());
  oddColor->SetColor("#12345");
  EXPECT_NE(messageOf(oddColor).find("#12345"), std::string::npos);
}
