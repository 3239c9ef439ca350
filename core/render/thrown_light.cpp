// SPDX-License-Identifier: MIT
#include "core/render/thrown_light.h"

#include "core/base/parallel.h"
#include "core/color/luminance.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/render/lamp_choice.h"
#include "core/render/light_aim.h"
#include "core/render/microfacet.h"
#include "core/render/reflecting_places.h"
#include "core/render/surface_sample.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
constexpr std::size_t kBatch = 2048;
/// Batches whose deposits are held at a time, before they are added in order.
constexpr std::size_t kRound = 64;
struct Deposit {
  std::uint32_t slot = 0;
  vec3 flux{0.0F};
};

struct Particle {
  geometry::Ray ray;
  vec3 flux{0.0F};
};

/// What one batch works in.
struct Batch {
  Rng rng{0};
  std::vector<geometry::Ray> rays;
  std::vector<geometry::Hit> hits;
  std::vector<std::uint8_t> blocked;
  std::vector<float> through;
  std::vector<SurfaceSample> places;  ///< where the light of `flux` arrives
  std::vector<vec3> flux;             ///< toward them along the rays
  std::vector<Particle> particles;    ///< on their way
  std::vector<Particle> next;
};

class Thrower {
 public:
  Thrower(const ViewScene& scene, const relight::Lighting& lighting,
          const ThrownLightOptions& options)
      : scene_(scene),
        texels_(lighting.solver().operators().texels),
        lit_(lighting.total()),
        places_(scene, texels_, lit_),
        lamps_(lighting),
        options_(options) {
    if (lighting.environment() != nullptr) {
      const auto spots = lighting.environment()->spots();
      spots_.assign(spots.begin(), spots.end());
    }
  }

  Result<relight::Planes> run(const Job& job) {
    if (places_.empty()) return relight::Planes{};
    for (auto& plane : sum_) plane.assign(texels_.slotCount(), 0.0F);
    squares_.assign(texels_.slotCount(), 0.0F);
    const int most = std::max(options_.most_passes, 1);
    int passes = 0;
    while (passes < most && !(passes > 0 && noise(passes) <= options_.noise)) {
      for (std::size_t from = 0; from < batches(); from += kRound) {
        if (job.cancelled()) return Error{"thrown light", "cancelled", ""};
        runRound(static_cast<std::size_t>(passes), from);
      }
      job.report("following reflections", static_cast<double>(++passes) / most);
    }
    for (auto& plane : sum_) {
      for (std::size_t s = 0; s < plane.size(); ++s) {
        const float area = texels_.area[s];
        plane[s] = area > 0.0F ? plane[s] / (area * static_cast<float>(passes)) : 0.0F;
      }
    }
    return std::move(sum_);
  }

 private:
  [[nodiscard]] vec3 litAt(std::uint32_t slot) const {
    return {lit_[0][slot], lit_[1][slot], lit_[2][slot]};
  }

  [[nodiscard]] std::size_t batches() const { return (options_.samples + kBatch - 1) / kBatch; }

  /// RMS noise over the texels as a share of their mean light: particles are independent, so that
  /// the variance of a sum is about the sum of their squares.
  [[nodiscard]] double noise(int passes) const {
    double variance = 0.0;
    double light = 0.0;
    double areas = 0.0;
    for (std::size_t s = 0; s < squares_.size(); ++s) {
      const auto area = static_cast<double>(texels_.area[s]);
      if (!(area > 0.0)) continue;
      variance += static_cast<double>(squares_[s]) / area;  // of lux, times the area
      light += area * static_cast<double>(color::luminance(litAt(static_cast<std::uint32_t>(s))));
      areas += area;
    }
    return light > 0.0 ? std::sqrt(variance * areas) / (light * passes) : 0.0;
  }

  void runRound(std::size_t pass, std::size_t from) {
    const std::size_t count = std::min(kRound, batches() - from);
    found_.resize(kRound);
    parallelFor(count, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        found_[i].clear();
        runBatch(pass, from + i, found_[i]);
      }
    });
    for (std::size_t i = 0; i < count; ++i) add(found_[i]);
  }

  void runBatch(std::size_t pass, std::size_t index, std::vector<Deposit>& out) const {
    Batch b;
    b.rng = Rng(options_.seed, pass * batches() + index);
    const std::size_t samples = batches() * kBatch;
    std::vector<SurfaceSample> places;
    std::vector<std::uint32_t> slots;
    std::vector<float> areas;  // that a place stands for
    for (std::size_t k = 0; k < kBatch; ++k) {
      const std::size_t i = index * kBatch + k;
      const auto [side, stands_for] = places_.pick(
          (static_cast<double>(i) + b.rng.uniformDouble()) / static_cast<double>(samples));
      const vec2 at = inTriangle(r2Sequence(static_cast<std::uint32_t>(pass * samples + i)));
      const vec3 p = pointOf(scene_.mesh(), side.triangle, at);
      const std::uint32_t slot = texels_.at(side.triangle, side.front, p);
      if (slot == transfer::kNoTexel) continue;
      places.push_back(lookAt(side, p, at));
      slots.push_back(slot);
      areas.push_back(static_cast<float>(stands_for / static_cast<double>(samples)));
    }
    fromLamps(places, slots, areas, b);
    fromRoom(places, areas, b);
    for (int depth = 1; depth <= options_.most_reflections && !b.particles.empty(); ++depth) {
      land(b, depth < options_.most_reflections, out);
    }
  }

  /// The place as somebody right above it sees it.
  [[nodiscard]] SurfaceSample lookAt(const ReflectingSide& s, const vec3& p, const vec2& at) const {
    const vec3 normal = s.front ? scene_.normal(s.triangle) : -scene_.normal(s.triangle);
    constexpr float kHeight = 0.01F;
    const geometry::Ray ray{p + kHeight * normal, 0.0F, -normal};
    geometry::Hit hit;
    hit.t = kHeight;
    hit.triangle = s.triangle;
    hit.u = at.x;
    hit.v = at.y;
    return sampleSurface(scene_, ray, hit, {.footprint = 1.0e-3F});
  }

  /// One luminaire or spot for each place, chosen by what it sends there.
  void fromLamps(const std::vector<SurfaceSample>& places, const std::vector<std::uint32_t>& slots,
                 const std::vector<float>& areas, Batch& b) const {
    b.rays.clear();
    b.places.clear();
    b.flux.clear();
    for (std::size_t k = 0; k < places.size(); ++k) aimOne(places[k], slots[k], areas[k], b);
    b.blocked.resize(b.rays.size());
    scene_.caster().occluded(b.rays, b.blocked);
    dim(b.rays, b);
    for (std::size_t k = 0; k < b.rays.size(); ++k) {
      if (b.blocked[k] == 0)
        throwOn(b.places[k], b.rays[k].direction, b.through[k] * b.flux[k], b.particles, b.rng);
    }
  }

  void aimOne(const SurfaceSample& at, std::uint32_t slot, float area, Batch& b) const {
    const LampChoice::Pick pick = lamps_.pick(slot, b.rng.uniformDouble());
    const vec2 u{b.rng.uniform(), b.rng.uniform()};
    if (!(pick.probability > 0.0)) return;
    geometry::Ray ray{geometry::offsetOrigin(at.point.position, at.point.normal), 0.0F, {}};
    vec3 lux(0.0F);  // on a plane that faces the source
    const auto& emitters = scene_.emitters();
    const bool spot = pick.source >= emitters.size();
    if (spot) {
      const daylight::Spot& sun = spots_[pick.source - emitters.size()];
      ray.direction = vec3(sun.direction);
      lux = vec3(sun.normal_illuminance);
    } else {
      const LightAim aim = aimAt(emitters[pick.source], dvec3(ray.origin), u);
      if (!(aim.distance > 0.0)) return;
      ray.direction = vec3(aim.direction);
      ray.t_max = static_cast<float>(aim.distance * (1.0 - 1.0e-4) - 5.0e-4);
      lux = aim.pdf > 0.0
                ? scene_.emitted(static_cast<int>(pick.source), vec3(aim.normal), -ray.direction) /
                      static_cast<float>(aim.pdf)
                : aim.intensity;
    }
    const float cosine = glm::dot(ray.direction, at.point.shading_normal);
    if (cosine <= 0.0F || glm::dot(ray.direction, at.point.normal) <= 0.0F) return;
    if (!(color::luminance(lux) > 0.0F)) return;
    const int lamp = spot ? kNoEmitter : static_cast<int>(pick.source);
    if (scene_.emitterHits().blocked(ray, lamp)) return;
    b.rays.push_back(ray);
    b.places.push_back(at);
    b.flux.push_back(lux * (cosine * area / static_cast<float>(pick.probability)));
  }

  void fromRoom(const std::vector<SurfaceSample>& places, const std::vector<float>& areas,
                Batch& b) const {
    b.rays.clear();
    for (const SurfaceSample& at : places) {
      const float r = std::sqrt(b.rng.uniform());
      const float phi = 2.0F * kPiF * b.rng.uniform();
      const float z = std::sqrt(std::max(0.0F, 1.0F - r * r));
      vec3 t(0.0F), s(0.0F);
      orthonormalBasis(at.point.shading_normal, t, s);
      const vec3 wi = r * std::cos(phi) * t + r * std::sin(phi) * s + z * at.point.shading_normal;
      geometry::Ray ray{geometry::offsetOrigin(at.point.position, at.point.normal), 0.0F, wi};
      if (glm::dot(wi, at.point.normal) <= 0.0F) ray.t_max = -1.0F;
      b.rays.push_back(ray);
    }
    trace(b);
    for (std::size_t k = 0; k < b.rays.size(); ++k) {
      if (b.rays[k].t_max < 0.0F || b.blocked[k] != 0) continue;
      const vec3 lux = b.through[k] * arriving(b.rays[k], b.hits[k]);
      throwOn(places[k], b.rays[k].direction, areas[k] * lux, b.particles, b.rng);
    }
  }

  /// pi times the radiance of what a ray meets.
  [[nodiscard]] vec3 arriving(const geometry::Ray& ray, const geometry::Hit& hit) const {
    if (!hit.valid()) return kPiF * scene_.outside(ray.direction, false).value_or(vec3(0.0F));
    const std::uint32_t slot = slotAt(ray, hit);
    if (slot == transfer::kNoTexel) return vec3(0.0F);
    return sampleSurface(scene_, ray, hit, {.spread = 0.05F}).albedo * litAt(slot);
  }

  [[nodiscard]] std::uint32_t slotAt(const geometry::Ray& ray, const geometry::Hit& hit) const {
    const bool front = glm::dot(scene_.normal(hit.triangle), ray.direction) < 0.0F;
    return texels_.at(hit.triangle, front, pointOf(scene_.mesh(), hit.triangle, {hit.u, hit.v}));
  }

  /// Light of direction wi leaves by the lobe.
  void throwOn(const SurfaceSample& at, const vec3& wi, const vec3& flux,
               std::vector<Particle>& out, Rng& rng) const {
    const ViewMaterial& m = scene_.material(at.point.triangle);
    vec3 t(0.0F), s(0.0F);
    const vec3& n = at.point.shading_normal;
    orthonormalBasis(n, t, s);
    const LobeSample lobe = sampleGgx({glm::dot(wi, t), glm::dot(wi, s), glm::dot(wi, n)}, m.f0,
                                      at.alpha, {rng.uniform(), rng.uniform()});
    if (!(lobe.weight > 0.0F)) return;
    const vec3 wo = lobe.wi.x * t + lobe.wi.y * s + lobe.wi.z * n;
    if (glm::dot(wo, at.point.normal) <= 0.0F) return;
    out.push_back({{geometry::offsetOrigin(at.point.position, at.point.normal), 0.0F, wo},
                   flux * lobe.weight});
  }

  /// Where the particles arrive; on reflecting surfaces they go on.
  void land(Batch& b, bool go_on, std::vector<Deposit>& out) const {
    b.rays.clear();
    for (const Particle& p : b.particles) b.rays.push_back(p.ray);
    trace(b);
    b.next.clear();
    for (std::size_t k = 0; k < b.rays.size(); ++k) {
      const geometry::Hit& hit = b.hits[k];
      if (!hit.valid() || b.blocked[k] != 0) continue;
      const vec3 flux = b.through[k] * b.particles[k].flux;
      const std::uint32_t slot = slotAt(b.rays[k], hit);
      if (slot != transfer::kNoTexel) out.push_back({slot, flux});
      if (!go_on || scene_.material(hit.triangle).f0 <= 0.0F) continue;
      const SurfaceSample at = sampleSurface(scene_, b.rays[k], hit, {.footprint = 1.0e-3F});
      throwOn(at, -b.rays[k].direction, flux, b.next, b.rng);
    }
    std::swap(b.particles, b.next);
  }

  /// What the batch's rays meet, which of them a luminaire's body stops, and what glass leaves.
  void trace(Batch& b) const {
    b.hits.resize(b.rays.size());
    scene_.caster().closest(b.rays, b.hits, false);
    b.blocked.assign(b.rays.size(), 0);
    std::vector<geometry::Ray> ways(b.rays);
    for (std::size_t k = 0; k < ways.size(); ++k) {
      if (b.hits[k].valid()) ways[k].t_max = b.hits[k].t;
      if (scene_.emitterHits().hasBodies() && scene_.emitterHits().blocked(ways[k], kNoEmitter)) {
        b.blocked[k] = 1;
      }
    }
    dim(ways, b);
  }

  void dim(std::span<const geometry::Ray> ways, Batch& b) const {
    b.through.assign(ways.size(), 1.0F);
    if (scene_.panes() != nullptr) scene_.panes()->attenuate(ways, b.through);
  }

  void add(const std::vector<Deposit>& deposits) {
    for (const Deposit& d : deposits) {
      for (std::size_t c = 0; c < 3; ++c) sum_[c][d.slot] += d.flux[static_cast<int>(c)];
      const float light = color::luminance(d.flux);
      squares_[d.slot] += light * light;
    }
  }

  const ViewScene& scene_;
  const transfer::Texels& texels_;
  relight::Planes lit_;  ///< lux of everything, per slot
  ReflectingPlaces places_;
  LampChoice lamps_;
  ThrownLightOptions options_;
  std::vector<daylight::Spot> spots_;
  std::vector<std::vector<Deposit>> found_;  ///< of a round
  relight::Planes sum_;                      ///< lumens per slot
  std::vector<float> squares_;               ///< of their parts
};

}  // namespace

Result<relight::Planes> thrownLight(const ViewScene& scene, const relight::Lighting& lighting,
                                    const ThrownLightOptions& options, const Job& job) {
  if (!scene.hasSpecular() || lighting.solver().operators().texels.slotCount() == 0) {
    return relight::Planes{};
  }
  return Thrower(scene, lighting, options).run(job);
}

}  // namespace soffit::render
