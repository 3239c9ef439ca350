// SPDX-License-Identifier: MIT
#include "core/render/view_scene.h"

#include "core/math/rng.h"
#include "core/render/microfacet.h"
#include "core/scene/roughness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace soffit::render {
namespace {

using MapCache = std::map<const scene::Image*, std::shared_ptr<const MipMap>>;

std::shared_ptr<const MipMap> mapOf(const std::shared_ptr<const scene::Image>& image,
                                    MapCache& cache) {
  if (image == nullptr || image->width < 1 || image->height < 1 || image->channels != 3)
    return nullptr;
  auto& map = cache[image.get()];
  if (map == nullptr) map = std::make_shared<const MipMap>(*image);
  return map;
}

/// Planes that round to the same numbers are one surface; it matters little where the rounding
/// splits one, for the numbers only group what is shaded together.
std::uint64_t planeKey(const vec3& normal, double distance, double step, std::uint64_t part) {
  std::uint64_t key = mixBits(part + 1);
  for (int axis = 0; axis < 3; ++axis) {
    key = mixBits(
        key ^ static_cast<std::uint64_t>(std::llround(static_cast<double>(normal[axis]) * 256.0)));
  }
  return mixBits(key ^ static_cast<std::uint64_t>(std::llround(distance / step)));
}

}  // namespace

ViewScene::ViewScene(std::shared_ptr<const scene::Scene> scene,
                     std::shared_ptr<const geometry::RayCaster> caster,
                     std::vector<light::Emitter> emitters)
    : scene_(std::move(scene)),
      caster_(std::move(caster)),
      emitters_(std::move(emitters)),
      emitter_hits_(emitters_) {
  for (const light::Emitter& e : emitters_) emitter_radiance_.emplace_back(e);
  panes_ = daylight::Panes::make(mesh(), scene_->materials);
  if (scene_->environment) environment_.emplace(*scene_->environment);
  makeMaterials();
  makeSurfaces();
}

std::optional<vec3> ViewScene::outside(const vec3& direction, bool sun) const {
  if (!environment_) return std::nullopt;
  const dvec3 d = glm::normalize(dvec3(direction));
  const auto& disc = environment_->sun();
  if (sun && disc && disc->covers(d)) return vec3(static_cast<float>(disc->radiance()));
  return vec3(environment_->radiance(d));
}

void ViewScene::makeMaterials() {
  MapCache cache;
  for (const scene::Material& m : scene_->materials) {
    ViewMaterial made;
    made.alpha = static_cast<float>(m.roughness * m.roughness);
    const scene::RoughnessRange range = scene::roughnessRange(m);
    made.least_alpha =
        std::max(static_cast<float>(range.least * range.least), std::min(made.alpha, kMirrorAlpha));
    made.mean_alpha = static_cast<float>(range.mean * range.mean);
    if (m.glass) {
      made.diffuse = vec3(0.0F);
    } else {
      made.diffuse = vec3(m.diffuse);
      made.f0 = static_cast<float>(m.specular);
      made.diffuse_map = mapOf(m.diffuse_image, cache);
      made.normal_map = mapOf(m.normal_image, cache);
      if (made.f0 > 0.0F) made.roughness_map = mapOf(m.roughness_image, cache);
    }
    has_specular_ = has_specular_ || made.f0 > 0.0F;
    materials_.push_back(std::move(made));
  }
  std::uint32_t needed = 1;
  for (const std::uint32_t index : mesh().material_of) needed = std::max(needed, index + 1);
  if (materials_.size() < needed) materials_.resize(needed);
}

void ViewScene::makeSurfaces() {
  const geometry::Mesh& m = mesh();
  const double step = 1.0e-5 + 1.0e-5 * static_cast<double>(m.bounds().diagonal());
  std::unordered_map<std::uint64_t, std::uint32_t> known;
  normals_.reserve(m.triangleCount());
  surfaces_.reserve(m.triangleCount());
  for (std::size_t i = 0; i < m.triangleCount(); ++i) {
    const uvec3& t = m.triangles[i];
    const dvec3 a(m.positions[t.x]);
    const dvec3 n = glm::cross(dvec3(m.positions[t.y]) - a, dvec3(m.positions[t.z]) - a);
    const double length = glm::length(n);
    const dvec3 unit = length > 0.0 ? n / length : dvec3(0.0, 0.0, 1.0);
    normals_.emplace_back(unit);
    const std::uint64_t object = m.object_of.empty() ? 0 : m.object_of[i];
    const std::uint64_t part = object << 32U | materialIndex(static_cast<std::uint32_t>(i));
    const std::uint64_t key = planeKey(normals_.back(), glm::dot(unit, a), step, part);
    surfaces_.push_back(
        known.try_emplace(key, static_cast<std::uint32_t>(known.size())).first->second);
  }
}

}  // namespace soffit::render
