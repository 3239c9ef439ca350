// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/geometry/cleaning.h"
#include "core/math/vec.h"

struct aiScene;

namespace soffit::io {

/// All mesh instances of a scene as one soup, and what was left out of it.
struct ConvertedScene {
  geometry::RawMesh raw;  ///< `materials` is left empty; material_of counts as the scene does
  std::size_t points = 0;
  std::size_t lines = 0;
};

/// Walks the node tree and transforms every mesh instance to the world.
///
/// world_from_root  applied after the node transforms; may mirror.
/// skip_root        leave out the root node's own transform.
/// model_name       what objects without a name are called.
///
/// Where the transform mirrors, triangles are turned over, so that fronts stay fronts. Error: more
/// than 100 million triangles.
Result<ConvertedScene> convertScene(const aiScene& scene, const glm::dmat4& world_from_root,
                                    bool skip_root, const std::string& model_name);

}  // namespace soffit::io
