// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"
#include "ui/viewport/view_camera.h"

#include <QSize>

#include <memory>
#include <vector>

namespace soffit::ui {

/// A traced picture of what a view shows, and of what state. It fits while neither camera nor light
/// nor size is another; how light becomes colours may change.
struct TracedView {
  ViewCamera camera;
  LightFramePtr frame;
  std::shared_ptr<const scene::Scene> scene;
  QSize pixels;
  /// cd/m^2 of red, green, blue; lux, -1 on luminaires, -2 beyond the building. Four per pixel, the
  /// bottom row first.
  std::vector<float> light;
};

/// The same light on the same surfaces, reflected alike.
[[nodiscard]] bool showsSame(const LightFrame& a, const scene::Scene& scene_a, const LightFrame& b,
                             const scene::Scene& scene_b);

}  // namespace soffit::ui
