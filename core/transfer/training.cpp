// SPDX-License-Identifier: MIT
#include "core/transfer/training.h"

#include "core/base/parallel.h"
#include "core/light/direct_stage.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/transfer/kernels.h"
#include "core/transfer/shadow_groups.h"
#include "core/transfer/node_solver.h"

#include <algorithm>
#include <numeric>

namespace soffit::transfer {
namespace {

/// A place in the open: above a random texel, somewhere before what lies opposite.
struct Place {
  vec3 position{0.0F};
  vec3 up_hit{0.0F};  ///< the ceiling above it, or as far as the scene reaches
};

class LightDrawer {
 public:
  static constexpr double kFlux = 1000.0;  // lm
  LightDrawer(const StaticScene& scene, const Operators& operators, std::uint64_t seed)
      : scene_(scene), operators_(operators), rng_(seed, 77) {
    cumulative_.resize(operators.area.size());
    double sum = 0.0;
    for (std::size_t s = 0; s < operators.area.size(); ++s) {
      sum += static_cast<double>(operators.area[s]);
      cumulative_[s] = sum;
    }
    size_ = scene.mesh->bounds().diagonal();
  }

  light::Luminaire draw() {
    const Place place = drawPlace();
    light::Luminaire l;
    l.flux = kFlux;
    const float kind = rng_.uniform();
    const double longest = 0.12 * static_cast<double>(size_);
    const auto length = [&] { return std::min(0.1 + 1.1 * rng_.uniformDouble(), longest); };
    if (kind < 0.75F) {
      l.shape = light::Rectangle{length(), length()};
    } else if (kind < 0.9F) {
      l.shape = light::Sphere{0.2 * length()};
    } else {
      l.shape = light::Disk{0.5 * length()};
    }
    const float where = rng_.uniform();
    dvec3 p(place.position);
    if (where < 0.5F) {
      // Most luminaires hang at or below the ceiling and shine down.
      const float drop = rng_.uniform();
      p = dvec3(glm::mix(place.up_hit, place.position, 0.02F + 0.5F * drop * drop));
    } else {
      l.rotation_deg = dvec3(360.0 * rng_.uniformDouble(), 180.0 * rng_.uniformDouble() - 90.0, 0.0);
    }
    l.position = p;
    return l;
  }

 private:
  Place drawPlace() {
    const double u = rng_.uniformDouble() * cumulative_.back();
    const auto slot = static_cast<std::size_t>(std::upper_bound(cumulative_.begin(), cumulative_.end(), u) - cumulative_.begin());
    const std::size_t s = std::min(slot, cumulative_.size() - 1);
    const vec3 p = operators_.texels.receivers.position(s);
    const vec3 n = operators_.texels.receivers.normal(s);
    const vec3 start = geometry::offsetOrigin(p, n);
    const float along = std::min(reach(start, n), size_);
    Place place;
    place.position = start + n * (along * (0.05F + 0.9F * rng_.uniform()));
    const vec3 up(0.0F, 0.0F, 1.0F);
    place.up_hit = place.position + up * std::min(reach(place.position, up), 3.0F);
    return place;
  }

  [[nodiscard]] float reach(const vec3& from, const vec3& direction) const {
    const geometry::Hit hit = scene_.caster.closest({from, 0.0F, direction, 0.5F * size_});
    return hit.valid() ? hit.t : 0.5F * size_;
  }

  const StaticScene& scene_;
  const Operators& operators_;
  Rng rng_;
  std::vector<double> cumulative_;
  float size_ = 1.0F;
};

/// Random reflectance per material for one training light.
std::vector<float> drawReflectances(std::size_t materials, std::uint64_t seed, int t) {
  Rng rng(seed, 1000 + static_cast<std::uint64_t>(t));
  std::vector<float> rho(materials);
  for (float& r : rho) r = 0.15F + 0.7F * rng.uniform();
  return rho;
}

}  // namespace

TrainingFields makeTrainingFields(const StaticScene& scene, const Operators& operators,
                                  std::span<const std::uint32_t> hits, int rays, const BakeSettings& settings,
                                  const Job& job) {
  const Texels& texels = operators.texels;
  const std::size_t slots = texels.slotCount();
  const auto count = static_cast<std::size_t>(settings.trainings);
  TrainingFields fields;
  fields.count = settings.trainings;
  fields.value.assign(slots * count, 0.0F);
  std::vector<float> first(slots * count, 0.0F);  // rho (direct + node indirect)
  std::vector<float> direct(slots * count, 0.0F);
  std::vector<float> reflectance(slots * count, 0.0F);
  const std::size_t materials =
      1 + static_cast<std::size_t>(*std::max_element(texels.material.begin(), texels.material.end()));
  LightDrawer drawer(scene, operators, settings.seed);
  const ShadowGroups groups = makeShadowGroups(texels, operators.fill_from);
  std::vector<float> grouped(groups.points.slotCount());
  std::vector<std::uint8_t> lit(groups.points.clusters.size());
  std::vector<float> lux(slots);
  std::vector<float> rho(slots);
  NodeSolver::Vectors b0(1, std::vector<float>(operators.nodes.stride, 0.0F));
  NodeSolver::Vectors e;
  std::vector<float> x(slots);
  // A handful of reflectance sets is enough: each needs a factorisation of the nodes.
  constexpr std::size_t kSets = 8;
  const std::size_t per_set = (count + kSets - 1) / kSets;
  std::unique_ptr<NodeSolver> solver;
  for (std::size_t t = 0; t < count; ++t) {
    if (job.cancelled()) return fields;
    job.report("training lights", static_cast<double>(t) / static_cast<double>(count));
    if (t % per_set == 0) {
      const std::vector<float> by_material = drawReflectances(materials, settings.seed, static_cast<int>(t));
      for (std::size_t s = 0; s < slots; ++s) {
        rho[s] = operators.buried[s] != 0 ? 0.0F : by_material[texels.material[s]];
      }
      const std::span<const float> channel(rho);
      solver = std::make_unique<NodeSolver>(operators.nodes, operators.area, std::span(&channel, 1));
    }
    // Lights that see next to nothing (inside a cabinet, mostly) are drawn again.
    double most = -1.0;
    for (int attempt = 0; attempt < 8 && most < 0.3 * LightDrawer::kFlux; ++attempt) {
      const auto emitter = light::makeEmitter(drawer.draw());
      if (!emitter) continue;
      light::directIlluminance(light::PreparedLight(*emitter), groups.points, scene.blockers,
                               {.epsilon = scene.epsilon, .bodies = {}}, grouped, lit);
      double received = 0.0;
      for (std::size_t s = 0; s < slots; ++s) {
        received += static_cast<double>(operators.area[s]) * static_cast<double>(grouped[groups.place[s]]);
      }
      if (received <= most) continue;
      most = received;
      for (std::size_t s = 0; s < slots; ++s) lux[s] = grouped[groups.place[s]];
    }
    for (std::size_t s = 0; s < slots; ++s) x[s] = rho[s] * lux[s];
    restrictToNodes(operators.nodes, operators.area, x, b0[0]);
    solver->solve(b0, e);
    prolongFromNodes(operators.nodes, e[0], x);
    for (std::size_t s = 0; s < slots; ++s) {
      direct[s * count + t] = lux[s];
      reflectance[s * count + t] = rho[s];
      first[s * count + t] = rho[s] * std::max(0.0F, lux[s] + x[s]);
    }
  }
  parallelFor(slots, 64, [&](std::size_t begin, std::size_t end) {
    std::vector<float> sum(count);
    for (std::size_t s = begin; s < end; ++s) {
      std::fill(sum.begin(), sum.end(), 0.0F);
      for (int r = 0; r < rays; ++r) {
        const std::uint32_t hit = hits[s * static_cast<std::size_t>(rays) + static_cast<std::size_t>(r)];
        if (hit != kNoTexel) addScaled(1.0F / static_cast<float>(rays), &first[hit * count], sum.data(), count);
      }
      for (std::size_t t = 0; t < count; ++t) {
        fields.value[s * count + t] = reflectance[s * count + t] * (direct[s * count + t] + sum[t]);
      }
    }
  });
  // Equal weight for every light: an area mean of 1.
  std::vector<double> mean(count, 0.0);
  double area = 0.0;
  for (std::size_t s = 0; s < slots; ++s) {
    area += static_cast<double>(operators.area[s]);
    for (std::size_t t = 0; t < count; ++t) {
      mean[t] += static_cast<double>(operators.area[s]) * static_cast<double>(fields.value[s * count + t]);
    }
  }
  for (std::size_t s = 0; s < slots; ++s) {
    for (std::size_t t = 0; t < count; ++t) {
      if (mean[t] > 0.0) fields.value[s * count + t] *= static_cast<float>(area / mean[t]);
    }
  }
  // The last is light that comes from everywhere alike: weights that give it back sum to 1, and
  // neighbours of a small bright spot are not made from large differences.
  constexpr float kEven = 3.0F;
  for (std::size_t s = 0; s < slots; ++s) fields.value[s * count + count - 1] = kEven;
  fields.blocks = FarBlocks(texels, operators.area);
  fields.value.resize(fields.blocks.size() * count);
  fields.blocks.average(0, slots, count, fields.value);
  return fields;
}

}  // namespace soffit::transfer
