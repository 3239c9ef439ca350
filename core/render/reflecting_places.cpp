// SPDX-License-Identifier: MIT
#include "core/render/reflecting_places.h"

#include "core/color/luminance.h"
#include "core/geometry/triangle_area.h"
#include "core/math/sampling.h"
#include "core/relight/reflectance.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr double kLeastShare = 0.1;
/// Points per square metre at which a side is looked at, and the fewest and the most.
constexpr double kLooksPerArea = 16.0;
constexpr int kFewestLooks = 4;
constexpr int kMostLooks = 256;

}  // namespace

vec3 pointOf(const geometry::Mesh& mesh, std::uint32_t triangle, const vec2& barycentric) {
  const uvec3& t = mesh.triangles[triangle];
  return (1.0F - barycentric.x - barycentric.y) * mesh.positions[t.x] +
         barycentric.x * mesh.positions[t.y] + barycentric.y * mesh.positions[t.z];
}

vec2 inTriangle(const dvec2& u) {
  const double root = std::sqrt(u.x);
  return {root * (1.0 - u.y), root * u.y};
}

ReflectingPlaces::ReflectingPlaces(const ViewScene& scene, const transfer::Texels& texels,
                                   const relight::Planes& lit) {
  std::vector<double> lobe;  // per material
  double light = 0.0;
  double weights = 0.0;
  for (std::uint32_t t = 0; t < scene.mesh().triangles.size(); ++t) {
    const ViewMaterial& m = scene.material(t);
    if (m.f0 <= 0.0F || (scene.panes() != nullptr && scene.panes()->isGlass(t))) continue;
    const std::uint32_t index = scene.materialIndex(t);
    if (index >= lobe.size()) lobe.resize(index + 1, -1.0);
    if (lobe[index] < 0.0) {
      lobe[index] = relight::lobeAlbedo(static_cast<double>(m.f0),
                                        std::sqrt(static_cast<double>(m.mean_alpha)));
    }
    for (const bool front : {true, false}) {
      ReflectingSide side{t, front, geometry::areaOf(scene.mesh(), t), 0.0};
      side.weight = meanLight(scene, texels, lit, side);
      if (side.weight < 0.0) continue;
      sides_.push_back(side);
      light += side.area * side.weight * lobe[index];
      weights += side.area * lobe[index];
    }
  }
  const double least = weights > 0.0 ? kLeastShare * light / weights : 0.0;
  for (ReflectingSide& side : sides_) {
    side.weight = side.area * lobe[scene.materialIndex(side.triangle)] * (side.weight + least);
    total_ += side.weight;
    cumulative_.push_back(total_);
  }
}

/// Luminance of the illuminance; negative where the side carries no light.
double ReflectingPlaces::meanLight(const ViewScene& scene, const transfer::Texels& texels,
                                   const relight::Planes& lit, const ReflectingSide& side) {
  const int looks =
      std::clamp(static_cast<int>(side.area * kLooksPerArea), kFewestLooks, kMostLooks);
  double sum = 0.0;
  int seen = 0;
  for (int k = 0; k < looks; ++k) {
    const vec2 at = inTriangle(r2Sequence(static_cast<std::uint32_t>(k)));
    const std::uint32_t slot =
        texels.at(side.triangle, side.front, pointOf(scene.mesh(), side.triangle, at));
    if (slot == transfer::kNoTexel) continue;
    sum += static_cast<double>(color::luminance(vec3(lit[0][slot], lit[1][slot], lit[2][slot])));
    ++seen;
  }
  return seen > 0 ? std::max(sum, 0.0) / looks : -1.0;
}

std::pair<ReflectingSide, double> ReflectingPlaces::pick(double u) const {
  const auto found = std::lower_bound(cumulative_.begin(), cumulative_.end(), u * total_);
  const auto at =
      std::min(static_cast<std::size_t>(found - cumulative_.begin()), sides_.size() - 1);
  const ReflectingSide& side = sides_[at];
  return {side, total_ * side.area / side.weight};
}

}  // namespace soffit::render
