// SPDX-License-Identifier: MIT
#pragma once

#include <vtkGenericOpenGLRenderWindow.h>

namespace soffit::ui {

/// A render window in a context that somebody else made. Works with EGL contexts (Wayland) too,
/// where a GLEW that was built for GLX loads everything and then reports that there is no GLX.
class GlWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static GlWindow* New();
  vtkTypeMacro(GlWindow, vtkGenericOpenGLRenderWindow)

      void OpenGLInitContext() override;

 protected:
  GlWindow() = default;
};

}  // namespace soffit::ui
