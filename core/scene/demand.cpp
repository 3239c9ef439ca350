// SPDX-License-Identifier: MIT
#include "core/scene/demand.h"

#include <algorithm>

namespace soffit::scene {
namespace {

bool isGrey(const dvec3& color) {
  return color.x == color.y && color.y == color.z;
}

void decide(Demand& demand, bool wanted, const char* what, const char* why_not) {
  if (wanted) {
    demand.needed.emplace_back(what);
  } else {
    demand.skipped.push_back({what, why_not});
  }
}

}  // namespace

Demand demandOf(const Scene& scene) {
  Demand demand;
  const auto& luminaires = scene.luminaires;
  const auto lit = [](const light::Luminaire& l) { return l.on && l.dimming > 0.0; };
  const bool any_surface = scene.mesh->triangleCount() > 0;
  const bool reflecting = std::ranges::any_of(scene.materials, [](const Material& m) {
    return m.diffuse != dvec3(0.0) || m.specular > 0.0;
  });
  const bool glossy =
      std::ranges::any_of(scene.materials, [](const auto& m) { return m.specular > 0.0; });
  const bool colored = std::ranges::any_of(scene.materials, [](const auto& m) {
    return !isGrey(m.diffuse) || m.diffuse_image != nullptr;
  });
  const bool measured = std::ranges::any_of(
      luminaires, [](const auto& l) { return l.distribution.table != nullptr; });
  const bool bodies = std::ranges::any_of(luminaires, [](const auto& l) { return l.casts_shadow; });
  const bool glass =
      std::ranges::any_of(scene.materials, [](const auto& m) { return m.glass.has_value(); });
  const auto* sky = scene.environment ? std::get_if<Sky>(&scene.environment->light) : nullptr;
  const bool sun =
      sky != nullptr && sky->direct_normal_illuminance > 0.0 && sky->sun_altitude_deg > 0.0;
  decide(demand, std::ranges::any_of(luminaires, lit), "direct light", "no luminaire is on");
  decide(demand, any_surface && reflecting, "interreflection", "no surface reflects");
  decide(demand, any_surface, "visibility", "there is no geometry");
  decide(demand, colored, "three color channels", "all reflectances are grey");
  decide(demand, glossy, "highlights and reflections", "no material has a specular share");
  const auto mapped = [&](const auto& image) {
    return std::ranges::any_of(scene.materials,
                               [&](const Material& m) { return m.*image != nullptr; });
  };
  decide(demand, mapped(&Material::diffuse_image), "pictures on surfaces",
         "no material has a diffuse map");
  decide(demand, mapped(&Material::normal_image), "bent normals", "no material has a normal map");
  decide(demand, glossy && mapped(&Material::roughness_image), "roughness that changes",
         glossy ? "no material has a roughness map" : "no material has a specular share");
  decide(demand, measured, "measured photometry", "no luminaire names a file");
  decide(demand, bodies, "luminaires as obstacles", "no luminaire casts a shadow");
  decide(demand, scene.environment.has_value(), "light from outside",
         "the project has no environment");
  decide(demand, sun, "sunlight", "the environment has no sun");
  decide(demand, glass, "light through glass", "no material is glass");
  return demand;
}

}  // namespace soffit::scene
