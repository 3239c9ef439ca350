// SPDX-License-Identifier: MIT
#include <vtk_glew.h>

#include "ui/viewport/gl_window.h"

#include <vtkObjectFactory.h>

namespace soffit::ui {
namespace {

constexpr GLenum kNoGlxDisplay = 4;  // GLEW_ERROR_NO_GLX_DISPLAY of GLEW 2.2

}  // namespace

vtkStandardNewMacro(GlWindow);

void GlWindow::OpenGLInitContext() {
  if (!this->Initialized) {
    glewExperimental = GL_TRUE;
    const GLenum outcome = glewInit();
    if (outcome == kNoGlxDisplay && GLEW_VERSION_3_2) {
      this->GlewInitValid = true;
      this->Initialized = true;
      this->MaximumHardwareLineWidth = 1.0F;
    }
  }
  this->Superclass::OpenGLInitContext();
}

}  // namespace soffit::ui
