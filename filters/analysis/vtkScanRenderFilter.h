// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/base/vtkScanTask.h"

#include "ScanFiltersModule.h" // for the export macro

#include <vtkImageAlgorithm.h>

#include <string>

class vtkPolyData;

/// A picture of a model, without a display: vtkPolyData in, RGB vtkImageData out.
///
/// Triangles are shaded; their backs have another colour, so that holes and flipped triangles show.
/// Lines are drawn beside them, points only when there is neither, shaded like the surface that
/// their neighbours suggest. The model fills the picture but for a small margin. The same input
/// gives the same bytes on the same machine. An input without points is an error, and so is a
/// machine without EGL.
class SCANFILTERS_EXPORT vtkScanRenderFilter
  : public vtkImageAlgorithm
  , public vtkScanTask
{
public:
  static vtkScanRenderFilter* New();
  vtkTypeMacro(vtkScanRenderFilter, vtkImageAlgorithm);
  vtkScanRenderFilter(const vtkScanRenderFilter&) = delete;
  void operator=(const vtkScanRenderFilter&) = delete;
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Size in pixels, 16 to 4096. Default: 1200 by 900.
  vtkSetMacro(Width, int);
  vtkGetMacro(Width, int);
  vtkSetMacro(Height, int);
  vtkGetMacro(Height, int);
  ///@}

  enum ViewType
  {
    ISO,   ///< from the right, the front and above (default)
    FRONT, ///< and on: scan::kViewSides
    BACK,
    LEFT,
    RIGHT,
    TOP,
    BOTTOM
  };
  vtkSetEnumMacro(View, ViewType);
  vtkGetEnumMacro(View, ViewType);

  enum UpType
  {
    Z_UP, ///< front looks along +y (default)
    Y_UP  ///< front looks along -z
  };
  vtkSetEnumMacro(Up, UpType);
  vtkGetEnumMacro(Up, UpType);

  /// The part to show, as in vtkScanPolyDataFilter. Default: empty, all.
  vtkSetMacro(Region, std::string);
  vtkGetMacro(Region, std::string);

  /// Perspective of a lens of 25 degrees, or a parallel projection. Default: true.
  vtkSetMacro(Perspective, bool);
  vtkGetMacro(Perspective, bool);
  vtkBooleanMacro(Perspective, bool);

  /// Draw the edges of the triangles. Default: false.
  vtkSetMacro(Edges, bool);
  vtkGetMacro(Edges, bool);
  vtkBooleanMacro(Edges, bool);

  ///@{
  /// Colour of the model and of what is behind it: an HTML name or "#rrggbb". Empty, the default,
  /// means clay on a light gradient.
  vtkSetMacro(Color, std::string);
  vtkGetMacro(Color, std::string);
  vtkSetMacro(Background, std::string);
  vtkGetMacro(Background, std::string);
  ///@}

  /// Diameter of points in pixels; 0, the default, makes points touch their neighbours.
  vtkSetMacro(PointSize, double);
  vtkGetMacro(PointSize, double);

protected:
  vtkScanRenderFilter() = default;
  ~vtkScanRenderFilter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  void Render(vtkPolyData& model, vtkImageData& image, scan::Execution& execution) const;

  int Width = 1200;
  int Height = 900;
  ViewType View = ISO;
  UpType Up = Z_UP;
  std::string Region;
  bool Perspective = true;
  bool Edges = false;
  std::string Color;
  std::string Background;
  double PointSize = 0.0;
};
