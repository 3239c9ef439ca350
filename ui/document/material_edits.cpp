// SPDX-License-Identifier: MIT
#include "ui/document/material_edits.h"

#include "core/light/emitter.h"
#include "core/scene/reflectances.h"
#include "ui/document/text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace soffit::ui {
namespace {

/// Whole hundred-thousandths, as a file should read.
double rounded(double v) {
  return std::round(v * 1e5) / 1e5;
}

scene::Material finished(scene::Material material) {
  for (int c = 0; c < 3; ++c) {
    material.diffuse[c] = rounded(std::clamp(material.diffuse[c], 0.0, 1.0 - material.specular));
  }
  return material;
}

/// The diffuse part of a reflectance at full white: what a picture leaves of it.
double diffuseShare(const scene::Material& material) {
  scene::Material white = material;
  white.diffuse = dvec3(1.0);
  white.specular = 0.0;
  return scene::reflectance(white);
}

}  // namespace

scene::Material withReflectance(const scene::Material& material, double rho) {
  scene::Material changed = material;
  const double wanted = std::clamp(rho, 0.0, 1.0) - material.specular;
  scene::Material matt = material;
  matt.specular = 0.0;
  const double now = scene::reflectance(matt);
  if (now > 1e-6) {
    changed.diffuse = std::max(wanted, 0.0) / now * material.diffuse;
  } else {
    changed.diffuse = dvec3(std::max(wanted, 0.0) / std::max(diffuseShare(material), 1e-6));
  }
  return finished(std::move(changed));
}

scene::Material withColour(const scene::Material& material, const dvec3& colour) {
  const double luminance = glm::dot(light::kLuminance, colour);
  if (luminance <= 0.0) return withReflectance(material, 0.0);
  const double before = scene::reflectance(material);
  scene::Material changed = material;
  changed.diffuse = colour / luminance;
  // Scaled down first: reflectance() is cut at 1.
  changed.diffuse *= 0.01;
  return withReflectance(changed, before);
}

scene::Material withSpecular(const scene::Material& material, double specular) {
  scene::Material changed = material;
  changed.specular = rounded(std::clamp(specular, 0.0, 1.0));
  return finished(std::move(changed));
}

void editMaterial(Document& document, const QString& text, const std::string& name,
                  const std::function<scene::Material(const scene::Material&)>& change,
                  int merge_key) {
  scene::Scene next = *document.scene();
  const auto found = std::ranges::find(next.materials, name, &scene::Material::name);
  if (found == next.materials.end()) return;
  *found = change(*found);
  document.edit(text, std::move(next), merge_key);
}

}  // namespace soffit::ui
