// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/display_mesh.h"

#include <memory>
#include <vector>

namespace soffit::ui {

/// A building before there is any light: its surfaces in even light, a little darker the more they
/// look down, so that its shape can be read. Both sides of everything are there.
struct PlainPreview {
  std::shared_ptr<const DisplayMesh> mesh;
  std::vector<vec3> lux;  ///< per vertex
};

PlainPreview makePlainPreview(const geometry::Mesh& mesh,
                              std::span<const scene::Material> materials);

}  // namespace soffit::ui
