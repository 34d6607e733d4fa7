// SPDX-FileCopyrightText: The Scanwrap authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filters/analysis/offscreen_window.h"

#include "filters/base/error.h"

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtk_glew.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <sys/resource.h>

#include <memory>
#include <string>

namespace scan
{
namespace
{

[[noreturn]] void refuse(const std::string& what)
{
  rlimit limit = {};
  if (::getrlimit(RLIMIT_DATA, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
  {
    throw Error(
      ErrorCode::memory, "picture: " + what + " within the memory limit; allow more memory");
  }
  throw Error(ErrorCode::internal,
    "picture: " + what + "; install the packages libegl1, libegl-mesa0 and libgl1-mesa-dri");
}

/// An OpenGL context that draws into textures only.
class EglContext
{
public:
  EglContext();
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  bool makeCurrent() const
  {
    return eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, this->Context) == EGL_TRUE;
  }
  bool isCurrent() const { return eglGetCurrentContext() == this->Context; }

private:
  // shared by the whole process, so never terminated
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLContext Context = EGL_NO_CONTEXT;
};

EglContext::EglContext()
{
  const auto displayOf = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  this->Display = displayOf != nullptr
    ? displayOf(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)
    : EGL_NO_DISPLAY;
  if (this->Display == EGL_NO_DISPLAY ||
    eglInitialize(this->Display, nullptr, nullptr) == EGL_FALSE)
  {
    refuse("EGL cannot draw without a display here");
  }
  constexpr EGLint kWanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
    EGL_OPENGL_BIT, EGL_NONE };
  constexpr EGLint kVersion[] = { EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 2,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
    eglChooseConfig(this->Display, kWanted, &config, 1, &found) == EGL_FALSE || found == 0)
  {
    refuse("EGL offers no OpenGL");
  }
  this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, kVersion);
  if (this->Context == EGL_NO_CONTEXT)
  {
    refuse("EGL offers no OpenGL 3.2");
  }
}

EglContext::~EglContext()
{
  if (this->isCurrent())
  {
    eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(this->Display, this->Context);
}

class OffscreenWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static OffscreenWindow* New();
  vtkTypeMacro(OffscreenWindow, vtkGenericOpenGLRenderWindow);
  OffscreenWindow(const OffscreenWindow&) = delete;
  void operator=(const OffscreenWindow&) = delete;

  void SetContext(std::unique_ptr<EglContext> context) { this->Egl = std::move(context); }
  void MakeCurrent() override { this->Egl->makeCurrent(); }
  bool IsCurrent() override { return this->Egl->isCurrent(); }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void OpenGLInitContext() override;

  bool IsUsable() const { return this->GlewInitValid; }

protected:
  OffscreenWindow() = default;
  ~OffscreenWindow() override { this->Finalize(); }

private:
  std::unique_ptr<EglContext> Egl;
};

vtkStandardNewMacro(OffscreenWindow);

/// As the superclass, except that GLEW may miss an X display: GLEW looks for one, if it was built
/// for X, after it has found the OpenGL functions, all we want of it.
void OffscreenWindow::OpenGLInitContext()
{
  this->ContextCreationTime.Modified();
  if (this->Initialized)
  {
    return;
  }
  const GLenum result = glewInit();
  this->GlewInitValid =
    (result == GLEW_OK || result == GLEW_ERROR_NO_GLX_DISPLAY) && GLEW_VERSION_3_2;
  this->Initialized = this->GlewInitValid;
  if (this->Initialized)
  {
    GLfloat range[2] = { 1.0F, 1.0F };
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range);
    this->MaximumHardwareLineWidth = range[1];
  }
}

} // namespace

vtkSmartPointer<vtkRenderWindow> makeOffscreenWindow(int width, int height)
{
  auto context = std::make_unique<EglContext>(); // may throw, which a VTK constructor must not
  const auto window = vtkSmartPointer<OffscreenWindow>::New();
  window->SetContext(std::move(context));
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->MakeCurrent();
  if (!window->IsCurrent())
  {
    refuse("EGL cannot use its OpenGL context");
  }
  window->OpenGLInit();
  if (!window->IsUsable())
  {
    refuse("there is no OpenGL 3.2");
  }
  return window;
}

} // namespace scan
