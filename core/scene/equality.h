// SPDX-License-Identifier: MIT
#pragma once

#include "core/geometry/mesh.h"
#include "core/light/luminaire.h"
#include "core/photometry/intensity_distribution.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <vector>

/// Equality of the scene's values, by content: what diff(), editBetween() and saving ask.
/// Shared tables are compared by pointer first, then by content, so equal scenes that were loaded
/// twice are equal. No tolerance: a value that was not edited is bit for bit the same.
namespace soffit::scene {

bool same(const photometry::IntensityDistribution& a, const photometry::IntensityDistribution& b);
bool same(const Glass& a, const Glass& b);
bool same(const geometry::Mesh& a, const geometry::Mesh& b);
bool same(const light::Shape& a, const light::Shape& b);
bool same(const light::Colour& a, const light::Colour& b);
bool same(const light::Distribution& a, const light::Distribution& b);
bool same(const Image& a, const Image& b);
/// Everything but the name.
bool sameReflectance(const Material& a, const Material& b);
/// Everything but the description.
bool same(const Environment& a, const Environment& b);
bool same(const Camera& a, const Camera& b);
bool same(const WorkPlane& a, const WorkPlane& b);
bool same(const View& a, const View& b);
bool same(const Quality& a, const Quality& b);
bool same(const light::Luminaire& a, const light::Luminaire& b);
bool same(const LuminaireEdit& a, const LuminaireEdit& b);
bool same(const Layout& a, const Layout& b);

/// Lists: in number, order and all that each says.
template <class T>
bool sameList(const std::vector<T>& a, const std::vector<T>& b) {
  return std::ranges::equal(a, b, [](const T& x, const T& y) { return same(x, y); });
}
/// Everything but the names.
bool sameReflectances(const std::vector<Material>& a, const std::vector<Material>& b);

}  // namespace soffit::scene
