// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/render/film.h"
#include "core/render/illumination.h"
#include "core/render/render_options.h"
#include "core/render/view_scene.h"
#include "core/scene/scene.h"

namespace soffit::render {

/// Renders a picture without a display: what the camera sees, in cd/m^2.
///
/// Surfaces show albedo (E_direct + E_indirect) / pi, with E from `illumination`, asked for whole
/// tiles; plus the light of their specular lobe (Reflector). Luminaires show their luminance
/// (EmitterRadiance); points are too small to be seen. Every pixel takes min(4, samples) rays;
/// samples that see the same place share one evaluation. A second pass takes all samples where
/// they see different places, and evaluates each on its own where a shadow's edge passes.
///
/// The picture does not depend on the number of threads if `illumination` does not.
/// Errors: see CameraFrame::create(); samples outside 1..1024; cancelled by `job`.
Result<Film> renderView(const ViewScene& scene, const scene::Camera& camera,
                        const Illumination& illumination, const RenderOptions& options,
                        const Job& job = {});

}  // namespace soffit::render
