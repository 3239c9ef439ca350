// SPDX-License-Identifier: MIT
#pragma once

#include "app/cli/common_options.h"
#include "app/cli/session.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/geometry/ray_caster.h"
#include "core/io/project/project.h"
#include "core/render/illumination.h"
#include "core/render/view_scene.h"

#include <functional>
#include <memory>

namespace CLI {
class App;
}

namespace soffit::cli {

/// What the light engine contributes to a picture.
struct PictureLight {
  std::shared_ptr<const render::Illumination>
      illumination;  ///< converged, of the project's luminaires
  /// Over the mesh of the project's scene, when the engine has one; null: the command makes its
  /// own.
  std::shared_ptr<const geometry::RayCaster> caster;
  /// The illumination of final pictures of a scene with specular surfaces; empty: the same.
  std::function<Result<std::shared_ptr<const render::Illumination>>(const render::ViewScene&,
                                                                    const Job&)>
      best = {};
};

/// Bakes or loads what the project needs and computes its light.
using MakePictureLight =
    std::function<Result<PictureLight>(const io::Project&, const CommonOptions&, const Job&)>;

/// `soffit render`: the light comes from `make`, everything else is here.
void addRenderCommand(CLI::App& app, Session& session, MakePictureLight make);

}  // namespace soffit::cli
