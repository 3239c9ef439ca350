// SPDX-License-Identifier: MIT
#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "core/transfer/hemisphere.h"
#include "core/transfer/operators.h"
#include "core/transfer/skeleton.h"
#include "core/transfer/texel_plan.h"
#include "core/transfer/training.h"

#include <algorithm>
#include <atomic>
#include <chrono>

namespace soffit::transfer {
namespace {

class Clock {
 public:
  /// Seconds since construction.
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  /// Seconds since the last lap.
  double lap() {
    const double now = seconds();
    const double passed = now - last_;
    last_ = now;
    return passed;
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double last_ = 0.0;
};

/// Texels of the wished number: whole cells first, the rest where cells are worth splitting. In a
/// room where few are, smaller cells everywhere are the better use; in a large building more texels
/// are.
Texels layTexels(const StaticScene& scene, const BakeSettings& settings) {
  const TexelPlan plan = planTexels(scene, settings);
  std::size_t useful = 0;
  Texels texels =
      makeTexels(*scene.mesh, scene.sides, plan.cell, &scene.caster, plan.count, &useful);
  const double share = 1.0 - 1.3 * static_cast<double>(useful) / static_cast<double>(plan.count);
  if (share < settings.whole_cells + 0.1) return texels;
  const auto whole = static_cast<std::size_t>(share * static_cast<double>(plan.count));
  const double cell = cellForCount(*scene.mesh, scene.sides, whole, plan.least_cell);
  return makeTexels(*scene.mesh, scene.sides, cell, &scene.caster, plan.count);
}

/// Hits of every texel's rays, and with them which texels are valid (design.md section 2).
struct FirstHits {
  std::vector<std::uint32_t> slots;  ///< rays per slot
  std::vector<std::uint8_t> valid;
  std::vector<std::uint8_t> within;  ///< 1 where most rays meet the inside of solids
};

FirstHits traceFirst(const StaticScene& scene, const BakeSettings& settings, const Job& job,
                     Operators& operators) {
  const Texels& texels = operators.texels;
  const auto rays = static_cast<std::size_t>(settings.node_rays * settings.node_rays);
  FirstHits first;
  first.slots.assign(texels.slotCount() * rays, kNoTexel);
  first.valid.assign(texels.slotCount(), 0);
  first.within.assign(texels.slotCount(), 0);
  operators.sends.assign(texels.slotCount(), 0.0F);
  std::atomic<std::size_t> done{0};
  const std::size_t clusters = texels.receivers.clusters.size();
  parallelFor(clusters, 1, [&](std::size_t begin, std::size_t end) {
    HemisphereScratch scratch;
    HemisphereHits hits;
    for (std::size_t i = begin; i < end; ++i) {
      if (job.cancelled()) return;
      const light::Receivers::Cluster& c = texels.receivers.clusters[i];
      for (std::uint32_t s = c.begin; s < c.begin + c.used; ++s) {
        traceHemisphere(scene, texels, texels.receivers.position(s), texels.receivers.normal(s),
                        settings.node_rays, settings.seed * 15485863U + s, texels.gapReach(s),
                        scratch, hits);
        std::copy(hits.slots.begin(), hits.slots.end(),
                  first.slots.begin() + static_cast<std::ptrdiff_t>(s * rays));
        const int total = static_cast<int>(rays);
        first.valid[s] = texels.area[s] > 0.0F && hits.inside * 10 <= total ? 1 : 0;
        first.within[s] = hits.inside * 2 > total ? 1 : 0;
        operators.sends[s] = static_cast<float>(total - hits.missed - hits.inside) /
                             static_cast<float>(total);  // x area below
      }
      job.report("tracing surfaces", static_cast<double>(++done) / static_cast<double>(clusters));
    }
  });
  return first;
}

/// Invalid texels show the light of the nearest valid one of their cluster.
void fillInvalid(const FirstHits& first, Operators& operators) {
  const Texels& texels = operators.texels;
  const auto chartOf = [&](std::uint32_t slot) {
    return texels.charts.chart_of[texels.triangle[slot]];
  };
  operators.area = texels.area;
  operators.fill_from.resize(texels.slotCount());
  operators.buried.assign(texels.slotCount(), 0);
  for (const light::Receivers::Cluster& c : texels.receivers.clusters) {
    for (std::uint32_t s = c.begin; s < c.end; ++s) {
      const std::uint32_t own = s < c.begin + c.used ? s : c.begin + c.used - 1;
      operators.fill_from[s] = own;
      if (first.valid[own] != 0) continue;
      operators.area[s] = 0.0F;
      float best = 1e30F;
      for (std::uint32_t o = c.begin; o < c.begin + c.used; ++o) {
        if (first.valid[o] == 0 ||
            glm::dot(texels.receivers.normal(o), texels.receivers.normal(s)) < 0.7F)
          continue;
        // A door's leaf in a reveal: the light on its other side is not this texel's.
        if (chartOf(o) == chartOf(s) && texels.part[o] != texels.part[s]) continue;
        const vec3 d = texels.receivers.position(o) - texels.receivers.position(s);
        if (glm::dot(d, d) < best) {
          best = glm::dot(d, d);
          operators.fill_from[s] = o;
        }
      }
      if (operators.fill_from[s] == own) operators.buried[s] = first.within[own];
    }
  }
}

/// Light that is there at once: so many texels, and a quarter of the rays.
constexpr int kFirstTexels = 12000;

BakeSettings firstSettings(const BakeSettings& settings) {
  BakeSettings first = settings;
  first.texels = kFirstTexels;
  first.most_cell = 1e30;  // however large the building
  first.node_rays = std::max(2, settings.node_rays / 2);
  return first;
}

/// Texels and nodes. hits: of the texels' rays.
std::shared_ptr<Operators> bakeNodes(const StaticScene& scene, const BakeSettings& settings,
                                     const Job& job, FirstHits& hits, BakeCounts& tally) {
  Clock clock;
  auto operators = std::make_shared<Operators>();
  job.report("laying out texels", 0.0);
  operators->texels = layTexels(scene, settings);
  tally.texel_seconds += clock.lap();
  hits = traceFirst(scene, settings, job, *operators);
  if (job.cancelled()) return nullptr;
  fillInvalid(hits, *operators);
  for (std::size_t s = 0; s < operators->sends.size(); ++s)
    operators->sends[s] *= operators->area[s];
  const int rays = settings.node_rays * settings.node_rays;
  tally.rays +=
      static_cast<std::uint64_t>(operators->texels.texelCount()) * static_cast<std::uint64_t>(rays);
  operators->nodes = makeNodes(operators->texels, operators->area, settings.patch);
  fillNodeMatrix(operators->nodes, operators->area, hits.slots, rays);
  operators->coarse = true;
  tally.node_seconds += clock.lap();
  return operators;
}

}  // namespace

std::size_t Operators::bytes() const {
  return lists.bytes() + node_lists.bytes() + weights.size() * sizeof(Half) + nodes.matrix.bytes() +
         nodes.phi.size() * sizeof(vec2) + list_area.size() * sizeof(float) +
         clusters.size() * sizeof(ClusterWeights);
}

Result<std::shared_ptr<const Operators>> bake(const StaticScene& scene,
                                              const BakeSettings& settings, const Job& job,
                                              const CoarseResult& coarse, BakeCounts* counts) {
  const Error cancelled{"bake", "cancelled", ""};
  Clock clock;
  BakeCounts tally;
  if (scene.mesh->triangles.empty()) {
    // Light in free space: nothing reflects.
    auto none = std::make_shared<Operators>();
    none->coarse = true;
    if (counts != nullptr) *counts = tally;
    return std::shared_ptr<const Operators>(none);
  }
  FirstHits first;
  if (coarse && settings.texels > 3 * kFirstTexels) {
    const auto quick = bakeNodes(scene, firstSettings(settings), job, first, tally);
    if (quick == nullptr) return cancelled;
    tally.first_result_seconds = clock.seconds();
    coarse(quick);
  }
  const auto operators = bakeNodes(scene, settings, job, first, tally);
  if (operators == nullptr) return cancelled;
  tally.coarse_seconds = clock.seconds();
  if (tally.first_result_seconds == 0.0) tally.first_result_seconds = tally.coarse_seconds;
  if (coarse) coarse(std::make_shared<const Operators>(*operators));
  const int rays = settings.node_rays * settings.node_rays;
  clock.lap();
  const TrainingFields fields =
      makeTrainingFields(scene, *operators, first.slots, rays, settings, job);
  if (job.cancelled()) return cancelled;
  tally.training_seconds = clock.lap();
  tally.rays += fillSkeletons(scene, fields, settings, job, *operators);
  if (job.cancelled()) return cancelled;
  operators->coarse = false;
  tally.list_seconds = clock.lap();
  tally.seconds = clock.seconds();
  if (counts != nullptr) *counts = tally;
  return std::shared_ptr<const Operators>(operators);
}

}  // namespace soffit::transfer
