// SPDX-License-Identifier: MIT
#include "core/relight/direct_light.h"

#include "core/base/parallel.h"
#include "core/relight/bodies.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace soffit::relight {
namespace {

/// Clusters of receivers that glass may stand before, as receivers of their own.
struct Behind {
  light::Receivers receivers;
  std::vector<std::uint32_t> clusters;  ///< in the whole
};

void append(const light::Receivers& from, std::uint32_t index, Behind& out) {
  const light::Receivers::Cluster& c = from.clusters[index];
  light::Receivers::Cluster copy = c;
  light::Receivers& to = out.receivers;
  copy.begin = static_cast<std::uint32_t>(to.x.size());
  copy.end = copy.begin + (c.end - c.begin);
  const auto take = [&](const std::vector<float>& a, std::vector<float>& b) {
    b.insert(b.end(), a.begin() + c.begin, a.begin() + c.end);
  };
  take(from.x, to.x);
  take(from.y, to.y);
  take(from.z, to.z);
  take(from.nx, to.nx);
  take(from.ny, to.ny);
  take(from.nz, to.nz);
  to.groups.insert(to.groups.end(), from.groups.begin() + c.begin / light::Receivers::kGroup,
                   from.groups.begin() + c.end / light::Receivers::kGroup);
  to.clusters.push_back(copy);
  out.clusters.push_back(index);
}

Behind clustersBehindGlass(const transfer::StaticScene& scene, const light::Emitter& emitter,
                           const light::Receivers& receivers, std::span<const std::uint8_t> lit) {
  std::vector<Box> panes;
  for (const light::MaskBlocker& face : scene.pane_faces) panes.push_back(boxOf({&face, 1}));
  Behind out;
  for (std::uint32_t i = 0; i < receivers.clusters.size(); ++i) {
    if (lit[i] == 0) continue;
    Box hull = receivers.clusters[i].bounds.box;
    hull.add(emitter.bounds);
    const auto meets = [&](const Box& pane) { return hull.overlaps(pane); };
    if (std::any_of(panes.begin(), panes.end(), meets)) append(receivers, i, out);
  }
  return out;
}

/// Mean transmittance of the sheets between a receiver and the light, over what is seen through
/// any; 1 when no point of the light is.
double meanTransmittance(const daylight::Panes& panes, const light::PointLightSamples& points,
                         const dvec3& p, const dvec3& n) {
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const dvec3 to = dvec3(points.x[k], points.y[k], points.z[k]) - p;
    const double squared = glm::dot(to, to);
    if (!(squared > 0.0)) continue;
    const dvec3 facing(points.nx[k], points.ny[k], points.nz[k]);
    const double slant = facing == dvec3(0.0) ? std::sqrt(squared) : -glm::dot(to, facing);
    const double weight = static_cast<double>(points.weight[k]) * std::max(0.0, glm::dot(to, n)) *
                          std::max(0.0, slant) / (squared * squared);
    if (!(weight > 0.0)) continue;
    const double length = std::sqrt(squared);
    geometry::Ray ray{vec3(p), 0.0F, vec3(to / length), static_cast<float>(length)};
    daylight::PaneCrossing at;
    if (!panes.next(ray, at)) continue;
    ray.t_min = daylight::Panes::beyond(at.t, ray.direction);
    sum += weight * at.transmitted * panes.transmittance(ray);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : -1.0;
}

/// A share of the light that neither 16 nor 256 points find behind glass: its middle decides.
double transmittanceToward(const transfer::StaticScene& scene, const light::PreparedLight& light,
                           const dvec3& p, const dvec3& n) {
  const auto& emitter = light.emitter();
  const double distance = glm::length(dvec3(emitter.bounds.center()) - p);
  const bool far = distance > 30.0 * static_cast<double>(emitter.bounds.diagonal());
  for (const int level : {far ? 1 : 2, 4}) {
    const double found = meanTransmittance(*scene.panes, light.samples(level), p, n);
    if (found >= 0.0) return found;
  }
  // The sliver of a pane: take the nearest one's at the angle of the light's middle.
  const vec3 at(p);
  std::uint32_t nearest = scene.panes->triangles().front();
  for (const std::uint32_t t : scene.panes->triangles()) {
    if (glm::distance(scene.panes->center(t), at) <
        glm::distance(scene.panes->center(nearest), at)) {
      nearest = t;
    }
  }
  const dvec3 way = glm::normalize(dvec3(emitter.bounds.center()) - p);
  return scene.panes->slab(nearest)
      .at(glm::dot(way, dvec3(scene.panes->normal(nearest))))
      .transmitted;
}

}  // namespace

void directLight(const transfer::StaticScene& scene, const light::PreparedLight& light,
                 const light::Receivers& receivers, std::span<const light::MaskBlocker> bodies,
                 std::span<float> lux, std::span<std::uint8_t> lit, light::DirectCounts* counts,
                 std::span<const Box> changed) {
  std::vector<std::uint8_t> kept(scene.panes == nullptr ? 0 : receivers.groups.size());
  light::directIlluminance(
      light, receivers, scene.blockers,
      {.epsilon = scene.epsilon, .bodies = bodies, .changed = changed, .kept = kept}, lux, lit,
      counts);
  if (scene.panes == nullptr) return;
  const Behind behind = clustersBehindGlass(scene, light.emitter(), receivers, lit);
  if (behind.clusters.empty()) return;
  std::vector<light::MaskBlocker> blockers(bodies.begin(), bodies.end());
  blockers.insert(blockers.end(), scene.pane_faces.begin(), scene.pane_faces.end());
  std::vector<float> beside(behind.receivers.slotCount());
  std::vector<std::uint8_t> beside_lit(behind.clusters.size());
  light::directIlluminance(light, behind.receivers, scene.blockers,
                           {.epsilon = scene.epsilon, .bodies = blockers, .changed = changed},
                           beside, beside_lit);
  parallelFor(behind.clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const light::Receivers::Cluster& whole = receivers.clusters[behind.clusters[i]];
      const std::uint32_t from = behind.receivers.clusters[i].begin;
      for (std::uint32_t s = whole.begin; s < whole.end; ++s) {
        if (kept[s / light::Receivers::kGroup] != 0) continue;  // seen through glass already
        const float clear = beside[from + s - whole.begin];
        // What differs by rounding alone did not come through glass.
        if (lux[s] - clear <= 1.0e-6F * lux[s]) continue;
        const double tau = transmittanceToward(scene, light, dvec3(receivers.position(s)),
                                               dvec3(receivers.normal(s)));
        lux[s] = clear + (lux[s] - clear) * static_cast<float>(tau);
      }
    }
  });
}

}  // namespace soffit::relight
