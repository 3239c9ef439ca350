// SPDX-License-Identifier: MIT
#pragma once

#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace soffit::scene {

/// m² of one side of each material's triangles; index = Scene::materials.
std::vector<double> materialAreas(const Scene& scene);

/// The Rec.709 luminance of what a material reflects in all, diffuse and specular, 0..1; with a map
/// its mean, linear.
double reflectance(const Material& material);

/// One line for each material in use that hardly exists: reflecting more than 90 % (the whitest
/// paints reach 0.85 to 0.9, and light in the room grows without bound towards 1), or nothing at
/// all. Design models carry colours for the screen, not measured ones.
std::vector<std::string> implausibleReflectances(const Scene& scene);

}  // namespace soffit::scene
