// SPDX-License-Identifier: MIT
#pragma once

#include "core/light/luminaire.h"
#include "core/scene/scene.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// What changed between two scenes, in the terms of what must be computed again.
namespace soffit::scene {

/// One luminaire that differs; each member is a reason.
struct LuminaireChange {
  std::string name;
  bool added = false;
  bool removed = false;
  bool moved = false;         ///< position or rotation
  bool reshaped = false;      ///< shape or scale
  bool photometry = false;    ///< distribution
  bool flux = false;          ///< lumens: the light scales, its pattern stays
  bool casts_shadow = false;  ///< its body blocks light now, or no longer
  bool gain = false;          ///< dimming or on/off
  bool color = false;
  bool group = false;

  /// Light must be computed again with rays; otherwise stored light only needs re-mixing
  /// (gain, color) or scaling (flux).
  [[nodiscard]] bool needsRays() const {
    return added || removed || moved || reshaped || photometry || casts_shadow;
  }
  [[nodiscard]] bool any() const { return needsRays() || flux || gain || color || group; }
};

/// Everything that differs. Materials' reflectances are told by index into the later scene.
struct SceneDiff {
  bool geometry = false;  ///< triangles, or which materials there are
  std::vector<std::size_t> reflectances;
  std::vector<LuminaireChange>
      luminaires;  ///< of the base layout; in the later order, then the removed
  bool layouts = false;
  bool cameras = false;
  bool work_planes = false;
  bool environment = false;
  bool view = false;
  bool quality = false;
  bool name = false;

  [[nodiscard]] bool any() const {
    return geometry || !reflectances.empty() || !luminaires.empty() || layouts || cameras ||
           work_planes || environment || view || quality || name;
  }
};

/// What leads from `before` to `after`. Luminaires are matched by name; shared tables (mesh,
/// images, photometry) by pointer first, then by content.
SceneDiff diff(const Scene& before, const Scene& after);

/// The luminaires' part of it, also for two resolved layouts of one scene.
std::vector<LuminaireChange> diffLuminaires(std::span<const light::Luminaire> before,
                                            std::span<const light::Luminaire> after);

}  // namespace soffit::scene
