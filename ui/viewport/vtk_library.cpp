// SPDX-License-Identifier: MIT
#include "ui/viewport/vtk_library.h"

#include <vtkVersion.h>

namespace soffit::ui {

Library viewLibrary() {
  return {"VTK", vtkVersion::GetVTKVersion(), "BSD-3-Clause"};
}

}  // namespace soffit::ui
