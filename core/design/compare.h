// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/light/luminaire.h"
#include "core/photometry/metrics.h"
#include "core/relight/lighting.h"
#include "core/scene/scene.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Layouts side by side: what a designer weighs up.
namespace soffit::design {

/// A variant of the luminaires of one scene.
struct LayoutCase {
  std::string name;
  std::vector<light::Luminaire> luminaires;  ///< resolved
};

struct LayoutFigures {
  std::string name;
  struct Plane {
    std::string name;
    photometry::FieldMetrics lux;
  };
  std::vector<Plane> planes;        ///< in the scene's order
  std::size_t luminaires_on = 0;    ///< with dimming above 0
  double emitted_lm = 0.0;          ///< of those that are on, as they are dimmed
  double installed_lm = 0.0;        ///< of all, undimmed
  double lm_per_m2 = 0.0;           ///< emitted per area of all work planes; 0 without any
  std::size_t lights_computed = 0;  ///< whose light the layout before did not already have
};

/// The figures of one layout.
///
/// emitters  its luminaires.
/// light     at the sensors of the work planes, plane by plane in the order of sensorsOf(); empty
///           when there are none.
/// lights_computed is left at 0.
LayoutFigures layoutFigures(std::string name, std::span<const light::Emitter> emitters,
                            std::span<const scene::WorkPlane> planes,
                            std::span<const relight::SensorLight> light);

/// Sensors of all work planes, plane by plane.
std::vector<scene::Sensor> sensorsOfAll(std::span<const scene::WorkPlane> planes);

/// Area of all work planes, m^2.
double areaOfAll(std::span<const scene::WorkPlane> planes);

/// Called for each layout while its light is at hand, say to take pictures.
using LayoutVisitor =
    std::function<Result<void>(std::size_t index, std::shared_ptr<const relight::Lighting>)>;

/// Figures of every layout, computed one after the other on one engine: the bake is shared, and
/// so is the light of each luminaire that the layout before has at the same place.
///
/// environment  shines in every layout; null: none.
/// sensor_rays  squared: gather rays per point of a work plane (QualitySettings).
/// Errors: a luminaire's, with the layout's name; the visitor's; cancelled.
Result<std::vector<LayoutFigures>> compareLayouts(
    const std::shared_ptr<const relight::Solver>& solver, std::span<const scene::WorkPlane> planes,
    std::span<const LayoutCase> layouts, int sensor_rays, std::uint64_t seed, const Job& job,
    const LayoutVisitor& visit = {},
    std::shared_ptr<const daylight::Environment> environment = nullptr);

}  // namespace soffit::design
