// SPDX-License-Identifier: MIT
#pragma once

#include "ui/document/document.h"

#include <functional>
#include <optional>

/// What the user changes of a surface, as values. Reflectances stay what matter can have: diffuse
/// and specular together at most 1 in each channel.
namespace soffit::ui {

/// With another reflectance rho (all of it, diffuse and specular: scene::reflectance()), the colour
/// kept as far as channels allow. A black surface becomes grey.
scene::Material withReflectance(const scene::Material& material, double rho);

/// With the chromaticity of a colour (linear Rec.709), the reflectance kept as far as it allows.
scene::Material withColour(const scene::Material& material, const dvec3& colour);

/// With another specular reflectance; the diffuse one gives way where they would exceed 1.
scene::Material withSpecular(const scene::Material& material, double specular);

/// Changes a material by name, as one undo step; consecutive changes with one merge_key are one.
void editMaterial(Document& document, const QString& text, const std::string& name,
                  const std::function<scene::Material(const scene::Material&)>& change,
                  int merge_key = -1);

/// Beyond this a surface hardly exists: the whitest paints reach 0.85 to 0.9.
inline constexpr double kWhitest = 0.9;

}  // namespace soffit::ui
