// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

class vtkRenderWindow;

namespace scan
{

/// A render window that needs no display: EGL without a surface, whatever DISPLAY says. The OpenGL
/// context is made here and dies with the window; use both on one thread. Throws Error internal,
/// with the packages to install, where EGL or OpenGL 3.2 cannot be had.
vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height);

} // namespace scan
