// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/light_frame.h"
#include "ui/viewport/emitter_set.h"
#include "ui/viewport/surroundings.h"
#include "ui/viewport/view_camera.h"

#include <QRectF>
#include <QStringList>

#include <optional>
#include <string>

namespace soffit::ui {

/// What lies under a pixel.
struct PointedAt {
  std::string luminaire;                  ///< in front of all surfaces; empty: none
  std::optional<SurfaceReading> surface;  ///< the surface, through luminaires
  dvec3 place{0.0};                       ///< world, of the luminaire or the surface
  bool hit = false;
};

/// What a view can point at; what is null is not there.
struct Pointable {
  const scene::Scene* scene = nullptr;
  const LightFrame* frame = nullptr;
  const EmitterSet* luminaires = nullptr;
  std::vector<bool> cut_away;  ///< per luminaire, whether the cut took it away; empty: none
};

/// size, mouse: logical pixels.
PointedAt pointAt(const Pointable& things, const ViewCamera& camera, const dvec2& size,
                  const dvec2& mouse);

/// The luminaires that a rectangle on the screen touches and no surface hides.
QStringList luminairesIn(const Pointable& things, const ViewCamera& camera, const dvec2& size,
                         const QRectF& band);

/// Whether no surface that is drawn lies between the eye and a place, world; walls seen from outside
/// are not drawn, nor is what a view cuts away. Before there is light, everything is seen.
bool isSeen(const Pointable& things, const ViewCamera& camera, const dvec3& place);

/// Surfaces and the luminaires that are not `moving`.
Surroundings surroundingsOf(const scene::Scene& scene, const LightFramePtr& frame,
                            const EmitterSet* luminaires, const QStringList& moving);

}  // namespace soffit::ui
