// SPDX-License-Identifier: MIT
#include "ui/viewport/traced_view.h"

#include "core/scene/equality.h"

namespace soffit::ui {

bool showsSame(const LightFrame& a, const scene::Scene& scene_a, const LightFrame& b,
               const scene::Scene& scene_b) {
  if (&a == &b && &scene_a == &scene_b) return true;
  if (a.solver != b.solver || scene_a.mesh != scene_b.mesh || a.complete != b.complete)
    return false;
  if (a.names != b.names || a.lux != b.lux) return false;
  const auto& sky_a = scene_a.environment;
  const auto& sky_b = scene_b.environment;
  if (sky_a.has_value() != sky_b.has_value() || (sky_a && !scene::same(*sky_a, *sky_b))) {
    return false;
  }
  return scene::sameReflectances(scene_a.materials, scene_b.materials);
}

}  // namespace soffit::ui
