// SPDX-License-Identifier: MIT
#include "core/design/shadow_rays.h"

#include "core/base/parallel.h"
#include "core/light/emitter_sampling.h"
#include "core/light/prepared_light.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace soffit::design {
namespace {

/// Turns of the point set; receivers take them in a scrambled order, so that what a set gets wrong
/// is noise and not a band.
constexpr std::uint32_t kTurns = 64;

struct LightPoints {
  std::vector<light::EmitterSample> points;  ///< kTurns sets of `count`
  std::size_t count = 0;
};

LightPoints pointsOn(const light::Emitter& emitter, int rays) {
  LightPoints out;
  out.count = emitter.kind == light::EmitterKind::point ? 1 : static_cast<std::size_t>(rays);
  for (std::uint32_t turn = 0; turn < kTurns; ++turn) {
    Rng rng(turn);
    const dvec2 shift{rng.uniformDouble(), rng.uniformDouble()};
    for (std::uint32_t i = 0; i < out.count; ++i) {
      dvec2 u = r2Sequence(i) + shift;
      u -= glm::floor(u);
      out.points.push_back(light::sampleByArea(emitter, u));
    }
  }
  return out;
}

/// What a point of the light sends to a receiver, up to a factor.
double weightOf(const light::Emitter& emitter, const light::EmitterSample& s, const dvec3& p,
                const dvec3& n) {
  const dvec3 to = s.point - p;
  const double r2 = glm::dot(to, to);
  if (!(r2 > 0.0)) return 0.0;
  const dvec3 d = to / std::sqrt(r2);
  const double cosine = glm::dot(n, d);
  if (cosine <= 0.0) return 0.0;
  const double intensity = emitter.kind == light::EmitterKind::point
                               ? emitter.pointIntensity(-d)
                               : emitter.intensityPerArea(s.normal, -d);
  return cosine * intensity / r2;
}

class RayStage {
 public:
  RayStage(const light::Emitter& emitter, const light::Receivers& receivers,
           const geometry::RayCaster& caster, int rays)
      : prepared_(emitter),
        emitter_(emitter),
        receivers_(receivers),
        caster_(caster),
        points_(pointsOn(emitter, rays)) {}

  /// 16 receivers from `slot` on; returns the rays traced.
  std::uint64_t group(std::uint32_t slot, float* lux) const {
    const light::Receivers& r = receivers_;
    const Box& box = r.groups[slot / light::Receivers::kGroup].box;
    const vec3 gap =
        glm::max(glm::max(box.lo - emitter_.bounds.hi, emitter_.bounds.lo - box.hi), vec3(0.0F));
    alignas(64) std::array<double, 16> whole{};
    prepared_.unoccluded(
        {&r.x[slot], &r.y[slot], &r.z[slot], &r.nx[slot], &r.ny[slot], &r.nz[slot]},
        glm::length(gap), whole.data());
    std::uint64_t traced = 0;
    for (std::uint32_t i = 0; i < light::Receivers::kGroup; ++i) {
      lux[i] = 0.0F;
      if (whole[i] <= 0.0) continue;
      lux[i] = static_cast<float>(whole[i] * visibleShare(slot + i, traced));
    }
    return traced;
  }

 private:
  double visibleShare(std::uint32_t slot, std::uint64_t& traced) const {
    thread_local std::vector<geometry::Ray> rays;
    thread_local std::vector<double> weights;
    thread_local std::vector<std::uint8_t> blocked;
    rays.clear();
    weights.clear();
    const vec3 n = receivers_.normal(slot);
    const vec3 origin = geometry::offsetOrigin(receivers_.position(slot), n);
    const std::size_t turn = mixBits(slot + 1) % kTurns;
    double sum = 0.0;
    for (std::size_t i = 0; i < points_.count; ++i) {
      const light::EmitterSample& s = points_.points[turn * points_.count + i];
      const double f = weightOf(emitter_, s, dvec3(receivers_.position(slot)), dvec3(n));
      if (f <= 0.0) continue;
      geometry::Ray ray;
      ray.origin = origin;
      ray.direction = vec3(s.point) - origin;
      ray.t_max = 1.0F - 1e-4F;
      rays.push_back(ray);
      weights.push_back(f);
      sum += f;
    }
    if (rays.empty()) return 0.0;
    blocked.resize(rays.size());
    caster_.occluded(rays, blocked);
    traced += rays.size();
    double seen = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) seen += blocked[i] == 0 ? weights[i] : 0.0;
    return seen / sum;
  }

  light::PreparedLight prepared_;
  const light::Emitter& emitter_;
  const light::Receivers& receivers_;
  const geometry::RayCaster& caster_;
  LightPoints points_;
};

}  // namespace

std::uint64_t shadowRayIlluminance(const light::Emitter& emitter, const light::Receivers& receivers,
                                   const geometry::RayCaster& caster, int rays,
                                   std::span<float> lux, std::span<std::uint8_t> lit) {
  const RayStage stage(emitter, receivers, caster, rays);
  std::vector<std::uint64_t> traced(receivers.clusters.size(), 0);
  parallelFor(receivers.clusters.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const light::Receivers::Cluster& c = receivers.clusters[i];
      bool any = false;
      for (std::uint32_t slot = c.begin; slot < c.end; slot += light::Receivers::kGroup) {
        traced[i] += stage.group(slot, &lux[slot]);
        for (std::uint32_t k = 0; k < light::Receivers::kGroup; ++k) any = any || lux[slot + k] > 0;
      }
      lit[i] = any ? 1 : 0;
    }
  });
  std::uint64_t sum = 0;
  for (const std::uint64_t t : traced) sum += t;
  return sum;
}

}  // namespace soffit::design
