// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/picture_scene.h"

#include "filters/analysis/cloud_normals.h"
#include "filters/base/error.h"
#include "filters/base/vtkScanMeshBridge.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkColor.h>
#include <vtkLight.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace scan
{
namespace
{

/// Edges of a model sharper than this are drawn sharp.
constexpr double kFeatureAngle = 40.0;

/// Fewer points suggest no surface.
constexpr std::size_t kFewestShaded = 13;

void addLight(vtkRenderer& renderer, const Vec3& from, double intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.x, from.y, from.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetIntensity(intensity);
  renderer.AddLight(light);
}

void dye(vtkProperty& property, const Rgb& color)
{
  property.SetColor(color[0], color[1], color[2]);
  property.SetAmbient(0.17);
  property.SetDiffuse(0.90);
  property.SetSpecular(0.10);
  property.SetSpecularPower(25.0);
}

void abortIfCancelled(vtkObject* caller, unsigned long, void* execution, void*)
{
  if (static_cast<const Execution*>(execution)->cancelled())
  {
    static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
  }
}

/// Smooth shading across gentle edges; orientation stays as it is, so that mistakes in it show.
vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData& data, Execution& execution)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(&data);
  normals->SetFeatureAngle(kFeatureAngle);
  normals->SplittingOn();
  normals->ConsistencyOff();
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(abortIfCancelled);
  observer->SetClientData(&execution);
  normals->AddObserver(vtkCommand::ProgressEvent, observer);
  normals->Update();
  execution.step("shade", 1, 1);
  return normals->GetOutput();
}

} // namespace

Rgb parseColor(const std::string& text)
{
  vtkNew<vtkNamedColors> colors;
  const bool isNumber = text.size() == 7 && text[0] == '#' &&
    text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!isNumber && (text.empty() || !colors->ColorExists(text)))
  {
    throw Error(ErrorCode::badParameter,
      "colour \"" + text + "\" is neither an HTML colour name nor of the form #rrggbb");
  }
  const vtkColor3ub color = isNumber ? colors->HTMLColorToRGB(text) : colors->GetColor3ub(text);
  return { color.GetRed() / 255.0, color.GetGreen() / 255.0, color.GetBlue() / 255.0 };
}

void addModel(vtkRenderer& renderer, const TriMesh& mesh, std::span<const Segment> lines,
  const PictureStyle& style, const Vec3& eye, Execution& execution)
{
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  bridge::setMesh(*data, mesh, lines);
  const bool isCloud =
    mesh.triangles.empty() && lines.empty() && mesh.points.size() >= kFewestShaded;
  if (!mesh.triangles.empty())
  {
    data = withNormals(*data, execution);
  }
  else if (isCloud)
  {
    data->GetPointData()->SetNormals(cloudNormals(*data, eye, execution));
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();

  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty& front = *actor->GetProperty();
  dye(front, style.front);
  front.SetPointSize(static_cast<float>(style.pointSize));
  front.SetLineWidth(static_cast<float>(style.lineWidth));
  front.SetEdgeVisibility(style.edges);
  front.SetEdgeColor(0.28, 0.22, 0.18);
  front.SetLighting(isCloud || !mesh.triangles.empty());
  vtkNew<vtkProperty> back;
  dye(*back, style.back);
  actor->SetBackfaceProperty(back);
  renderer.AddActor(actor);

  renderer.AutomaticLightCreationOff();
  addLight(renderer, { -0.45, 0.65, 1.0 }, 0.80); // key light, above the left shoulder
  addLight(renderer, { 0.90, -0.10, 0.8 }, 0.33); // fill light from the right
  addLight(renderer, { -0.20, -1.0, 0.6 }, 0.20); // what the floor throws back
}

void aimCamera(vtkRenderer& renderer, const ViewFrame& frame, double viewAngle)
{
  vtkCamera& camera = *renderer.GetActiveCamera();
  camera.SetPosition(frame.position.x, frame.position.y, frame.position.z);
  camera.SetFocalPoint(frame.target.x, frame.target.y, frame.target.z);
  camera.SetViewUp(frame.up.x, frame.up.y, frame.up.z);
  camera.SetParallelProjection(viewAngle <= 0.0);
  camera.SetParallelScale(frame.halfHeight);
  if (viewAngle > 0.0)
  {
    camera.SetViewAngle(viewAngle);
  }
  renderer.ResetCameraClippingRange();
}

} // namespace scan
