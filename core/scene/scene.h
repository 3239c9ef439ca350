// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/light/luminaire.h"
#include "core/math/vec.h"
#include "core/scene/environment.h"
#include "core/scene/material.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

/// The whole of a project as values: what the engine, the reference and the pictures work from.
/// World coordinates in metres, z up. A Scene is cheap to copy (geometry and tables are shared)
/// and, once handed out as shared_ptr<const Scene>, immutable.
namespace soffit::scene {

/// Fields of a luminaire that a layout changes; absent fields keep the base value.
struct LuminaireEdit {
  std::optional<light::Shape> shape;
  std::optional<dvec3> position;
  std::optional<dvec3> rotation_deg;
  std::optional<double> scale;
  std::optional<double> flux;
  std::optional<light::Colour> colour;
  std::optional<light::Distribution> distribution;
  std::optional<bool> casts_shadow;
  std::optional<double> dimming;
  std::optional<bool> on;
  std::optional<std::string> group;
};

/// A variant of the lighting. `edits` is by luminaire name; a name that the base lacks is a
/// complete luminaire of this layout alone (missing fields take Luminaire's defaults).
struct Layout {
  std::string name;
  std::map<std::string, LuminaireEdit> edits;
};

struct Camera {
  std::string name;
  dvec3 position{0.0, 0.0, 1.6};
  dvec3 target{1.0, 0.0, 1.6};
  double vertical_fov_deg = 50.0;
};

/// A grid of calculation points: cell centres origin + u(i+1/2)/nu + v(j+1/2)/nv, i fastest,
/// normal u x v.
struct WorkPlane {
  std::string name;
  dvec3 origin{0.0};
  dvec3 u{1.0, 0.0, 0.0};
  dvec3 v{0.0, 1.0, 0.0};
  int nu = 1;
  int nv = 1;
  std::string room_type;
};

struct View {
  double exposure = 0.0;  ///< EV
  std::string ocio_display = "sRGB";
  std::string ocio_view = "Filmic";
  std::string ocio_look;
  double white_balance = 0.0;    ///< kelvin that are shown as white, 0: daylight (color::whiteBalance)
  double tone_key = 0.0;         ///< of views that adapt: 0 as the picture asks (color::ToneSettings)
  double tone_white = 0.0;       ///< the same
  double bloom_threshold = 0.0;  ///< cd/m^2, 0: none (render::Bloom)
  double bloom_strength = 0.1;   ///< 0..1
};

/// Named preset or single settings; unset members follow the preset.
struct Quality {
  std::string preset = "interactive";  ///< "draft" | "interactive" | "final"
  std::map<std::string, double> settings;
  std::map<std::string, std::string> methods;  ///< single settings that are names
};

struct Scene {
  std::string name;
  std::shared_ptr<const geometry::Mesh> mesh;  ///< never null; may be empty
  std::vector<Material> materials;             ///< index = Mesh::material_of
  std::vector<light::Luminaire> luminaires;    ///< the base layout
  std::vector<Layout> layouts;
  std::vector<Camera> cameras;
  std::vector<WorkPlane> work_planes;
  std::optional<Environment> environment;
  View view;
  Quality quality;
};

/// The luminaires of a layout: the base with the layout's edits, then its own luminaires by name.
std::vector<light::Luminaire> resolveLayout(const Scene& scene, const Layout& layout);

/// A point with a direction at which illuminance is asked for; world, n unit.
struct Sensor {
  dvec3 position{0.0};
  dvec3 normal{0.0, 0.0, 1.0};
};

/// The sensors of a work plane in its order, i fastest.
std::vector<Sensor> sensorsOf(const WorkPlane& plane);

}  // namespace soffit::scene
