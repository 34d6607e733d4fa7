// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/vtkScanRenderFilter.h"

#include "filters/analysis/offscreen_window.h"
#include "filters/analysis/picture_scene.h"
#include "filters/base/vtkScanMeshBridge.h"
#include "filters/base/vtkScanRegions.h"
#include "filters/geometry/spacing.h"
#include "filters/geometry/view_sides.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkScanRenderFilter);

namespace
{

using scan::Index;
using scan::Rgb;
using scan::Vec3;

constexpr double kLensAngle = 25.0; // degrees
constexpr int kOversampling = 2;
constexpr double kLineWidth = 1.0; // pixels

/// What a picture shows, moved to the origin.
struct Model
{
  scan::TriMesh mesh;
  std::vector<scan::Segment> lines;
  std::vector<Vec3> shown; // the points that triangles or lines use; all where there are none
};

Model modelOf(vtkPolyData& data)
{
  Model model = { scan::bridge::meshOf(data), scan::bridge::segmentsOf(data), {} };
  std::vector<Vec3>& points = model.mesh.points;
  std::vector<bool> isShown(points.size(), model.mesh.triangles.empty() && model.lines.empty());
  const auto mark = [&](const auto& cells)
  {
    for (const auto& cell : cells)
    {
      for (const Index point : cell)
      {
        isShown[point] = true;
      }
    }
  };
  mark(model.mesh.triangles);
  mark(model.lines);
  const std::size_t first =
    static_cast<std::size_t>(std::find(isShown.begin(), isShown.end(), true) - isShown.begin());
  if (first == points.size())
  {
    throw scan::Error(scan::ErrorCode::badInput, "picture: the model has no points to show");
  }
  // single precision, all that the graphics have, would show steps far from the origin
  Vec3 low = points[first];
  Vec3 high = low;
  for (std::size_t i = first; i < points.size(); ++i)
  {
    const Vec3& p = isShown[i] ? points[i] : points[first];
    low = { std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z) };
    high = { std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z) };
  }
  const Vec3 middle = low * 0.5 + high * 0.5;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i] = points[i] - middle;
    if (isShown[i])
    {
      model.shown.push_back(points[i]);
    }
  }
  return model;
}

/// Direction to the camera and up, for models that stand on the xy plane.
scan::ViewOptions directionsOf(vtkScanRenderFilter::ViewType view)
{
  if (view == vtkScanRenderFilter::ISO)
  {
    return { .towards = { 0.75, -1.0, 0.65 }, .up = { 0, 0, 1 } };
  }
  const scan::ViewSide& side = scan::kViewSides.at(view - vtkScanRenderFilter::FRONT);
  return { .towards = side.towards, .up = side.up };
}

/// The same direction for models that stand on the zx plane.
Vec3 standOnZx(const Vec3& v)
{
  return { v.x, v.z, -v.y };
}

void setBackground(vtkRenderer& renderer, const std::string& background)
{
  const bool plain = !background.empty();
  const Rgb lower = plain ? scan::parseColor(background) : Rgb{ 0.97, 0.97, 0.98 };
  renderer.SetBackground(lower[0], lower[1], lower[2]);
  renderer.SetBackground2(0.80, 0.84, 0.88);
  renderer.SetGradientBackground(!plain);
}

/// The window is kOversampling times as large as the image: every pixel of the image is the mean
/// of a square.
void readPixels(vtkRenderWindow& window, vtkImageData& image, int width, int height)
{
  vtkNew<vtkUnsignedCharArray> fine;
  window.GetPixelData(0, 0, kOversampling * width - 1, kOversampling * height - 1, 0, fine);
  image.SetDimensions(width, height, 1);
  image.AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* pixel = static_cast<unsigned char*>(image.GetScalarPointer());
  const std::ptrdiff_t fineRow = std::ptrdiff_t{ 3 } * kOversampling * width;
  for (int y = 0; y < height; ++y)
  {
    const unsigned char* square = fine->GetPointer(0) + fineRow * kOversampling * y;
    for (int x = 0; x < width; ++x, square += std::ptrdiff_t{ 3 } * kOversampling)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        int sum = kOversampling * kOversampling / 2;
        for (int i = 0; i < kOversampling * kOversampling; ++i)
        {
          sum += square[fineRow * (i / kOversampling) + std::ptrdiff_t{ 3 } * (i % kOversampling) +
            channel];
        }
        *pixel++ = static_cast<unsigned char>(sum / (kOversampling * kOversampling));
      }
    }
  }
}

} // namespace

void vtkScanRenderFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  constexpr const char* kViews[] = { "iso", "front", "back", "left", "right", "top", "bottom" };
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "View: " << kViews[this->View] << "\n";
  os << indent << "Up: " << (this->Up == Y_UP ? "y" : "z") << "\n";
  os << indent << "Region: " << this->Region << "\n";
  os << indent << "Perspective: " << (this->Perspective ? "true" : "false") << "\n";
  os << indent << "Edges: " << (this->Edges ? "true" : "false") << "\n";
  os << indent << "Color: " << this->Color << "\n";
  os << indent << "Background: " << this->Background << "\n";
  os << indent << "PointSize: " << this->PointSize << "\n";
}

int vtkScanRenderFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkScanRenderFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int extent[6] = { 0, this->Width - 1, 0, this->Height - 1, 0, 0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkScanRenderFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* model = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(outputVector);
  return this->RunGuarded(
    *this, image, [&](scan::Execution& execution) { this->Render(*model, *image, execution); });
}

void vtkScanRenderFilter::Render(
  vtkPolyData& input, vtkImageData& image, scan::Execution& execution) const
{
  if (std::min(this->Width, this->Height) < 16 || std::max(this->Width, this->Height) > 4096)
  {
    throw scan::Error(scan::ErrorCode::badParameter,
      "picture: width and height must be from 16 to 4096 pixels, not " +
        std::to_string(this->Width) + " by " + std::to_string(this->Height));
  }
  execution.plan({ { "prepare", 1.0 }, { "shade", 3.0 }, { "draw", 2.0 } });
  execution.step("prepare", 0, 1);
  const Model model = modelOf(*scan::bridge::partOf(input, this->Region, execution));

  scan::ViewOptions view = directionsOf(this->View);
  view.aspect = static_cast<double>(this->Width) / this->Height;
  view.viewAngle = this->Perspective ? kLensAngle : 0.0;
  if (this->Up == Y_UP)
  {
    view.towards = standOnZx(view.towards);
    view.up = standOnZx(view.up);
  }
  const scan::ViewFrame frame = scan::frameView(model.shown, view);

  scan::PictureStyle style;
  style.front = this->Color.empty() ? style.front : scan::parseColor(this->Color);
  style.edges = this->Edges;
  style.lineWidth = kOversampling * kLineWidth;
  if (model.mesh.triangles.empty() && model.lines.empty())
  {
    const double pixels = scan::meanSpacing(model.shown) * this->Height / (2.0 * frame.halfHeight);
    style.pointSize = kOversampling *
      (this->PointSize > 0.0 ? this->PointSize : std::clamp(3.0 * pixels, 2.0, 8.0));
  }
  execution.step("prepare", 1, 1);

  vtkNew<vtkRenderer> renderer;
  setBackground(*renderer, this->Background);
  scan::addModel(*renderer, model.mesh, model.lines, style, frame.position, execution);
  scan::aimCamera(*renderer, frame, view.viewAngle);
  execution.step("draw", 0, 1);

  const auto window =
    scan::makeOffscreenWindow(kOversampling * this->Width, kOversampling * this->Height);
  window->AddRenderer(renderer);
  window->Render();
  readPixels(*window, image, this->Width, this->Height);
  execution.step("draw", 1, 1);
}
