// SPDX-License-Identifier: MIT
#pragma once

#include "ui/viewport/emitter_set.h"
#include "ui/viewport/look.h"
#include "ui/viewport/view_camera.h"

#include "core/render/line_labels.h"
#include "ui/jobs/light_frame.h"

#include <QImage>
#include <QSize>

#include <memory>
#include <optional>
#include <vector>

namespace soffit::ui {

/// A picture that is wanted of a view's building: from anywhere, in any light, at any size. What is
/// absent is the view's own.
struct Shot {
  QSize pixels;
  std::optional<ViewCamera> camera;
  LightFramePtr frame;  ///< of the solver whose mesh the view has; with its luminaires
  std::shared_ptr<const EmitterSet> luminaires;
  std::optional<Look> look;
  int samples = 0;      ///< per pixel; 0: as many as a view at rest
  bool linear = false;  ///< also the light itself
  bool lux = false;     ///< also the illuminance of surfaces
  bool traced = false;  ///< with exact shadows and reflections (TracedStill), where it can be
  std::vector<light::Luminaire> lamps;  ///< if traced: whose light it is
};

struct Picture {
  QImage image;              ///< through the view transform, RGB888; null where there was no light
  std::vector<vec3> linear;  ///< cd/m^2, mean over the samples, the top row first; if asked for
  render::LuxPicture lux;    ///< of the middle of each pixel; if asked for
};

}  // namespace soffit::ui
