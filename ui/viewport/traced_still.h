// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/render/engine_light.h"
#include "core/render/film.h"
#include "ui/viewport/still.h"

#include <memory>

namespace soffit::ui {

/// Whether a picture can be traced: one that an eye sees. Lines and false colours show illuminance,
/// flat views have no eye.
[[nodiscard]] bool isTraceable(const ViewCamera& camera, const Look& look);
[[nodiscard]] inline bool isTraceable(const Still& still) {
  return isTraceable(still.camera, still.look);
}

/// Makes a still's picture as `soffit render` does: direct light at every pixel, reflections by
/// rays, what specular surfaces throw on others. Through the same view transform as a view.
/// The light of the last still is kept: pictures of one layout from several cameras share it, and
/// after a change of luminaires only those that changed are computed. One thread at a time.
class TracedStill {
 public:
  /// Without marks. still: isTraceable(); its shot has the luminaires. Tells its progress in one go
  /// from 0 to 1.
  /// Errors: the renderer's; cancelled. Throws std::bad_alloc.
  Result<Picture> draw(const Still& still, const Job& job);
  /// The light itself.
  Result<render::Film> trace(const Still& still, const Job& job);
  /// Forgets the light.
  void release();

 private:
  Result<void> take(const Still& still, const Job& job);

  LightFramePtr frame_;  ///< that the light is of
  std::shared_ptr<relight::Lighting> lighting_;
  std::shared_ptr<const scene::Scene> scene_;
  std::unique_ptr<const render::ViewScene> view_;
  std::shared_ptr<const render::EngineLight> light_;
};

}  // namespace soffit::ui
