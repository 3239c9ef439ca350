// SPDX-License-Identifier: MIT
#include "core/render/reflector.h"

#include "core/color/luminance.h"
#include "core/math/rng.h"
#include "core/math/sampling.h"
#include "core/render/light_aim.h"
#include "core/render/pixel_mean.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr float kPiF = 3.14159265358979F;
/// Paths that carry less than this share of what they meet are given up.
constexpr float kLeastThroughput = 0.02F;
/// How far rays of a lobe lie apart, in units of alpha: what detail a rough reflection resolves.
constexpr float kLobeSpread = 0.25F;
/// Light that a lobe reflects may be blurred by so many times the detail that it resolves: half of
/// how wide the lobe is there.
constexpr float kLightBlur = 2.0F;
/// A lobe reflects strongly from here on and gets twice the rays.
constexpr float kStrong = 0.2F;

vec2 fraction(const dvec2& v) {
  // Below 1 also after rounding to single precision.
  const auto part = [](double x) {
    return std::min(static_cast<float>(x - std::floor(x)), 0.99999994F);
  };
  return {part(v.x), part(v.y)};
}

dvec2 hashed(std::uint64_t key) {
  const std::uint64_t bits = mixBits(key + 0x9e3779b97f4a7c15ULL);
  return {static_cast<double>(bits >> 32U) * 0x1p-32,
          static_cast<double>(bits & 0xffffffffU) * 0x1p-32};
}

std::uint32_t phaseOf(int x, int y) {
  return static_cast<std::uint32_t>((y % kPhases) * kPhases + x % kPhases);
}

/// Turns a direction of the normal's frame into the scene's, and back.
struct Frame {
  vec3 t{0.0F}, b{0.0F}, n;
  explicit Frame(const vec3& normal) : n(normal) { orthonormalBasis(n, t, b); }
  [[nodiscard]] vec3 toScene(const vec3& v) const { return v.x * t + v.y * b + v.z * n; }
  [[nodiscard]] vec3 toLocal(const vec3& v) const {
    return {glm::dot(v, t), glm::dot(v, b), glm::dot(v, n)};
  }
};

/// A shading normal may send a reflection into the surface; fold it back above the real plane.
vec3 aboveSurface(const vec3& direction, const vec3& normal) {
  const float below = glm::dot(direction, normal);
  return below > 0.0F ? direction : glm::normalize(direction + (1.0e-3F - 2.0F * below) * normal);
}

std::uint64_t cellOf(const SurfaceSample& s, float size) {
  const float level = std::floor(std::log2(std::max(size, 1.0e-6F)));
  const vec3 place = glm::floor(s.point.position / std::exp2(level));
  std::uint64_t key = mixBits((static_cast<std::uint64_t>(s.surface) << 32U) ^
                              static_cast<std::uint64_t>(static_cast<std::int64_t>(level)));
  for (int axis = 0; axis < 3; ++axis) {
    key = mixBits(key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(place[axis])));
  }
  // The two sides of a sheet are lit differently.
  return mixBits(key ^ (glm::dot(s.point.normal, vec3(1.0F, 2.0F, 4.0F)) > 0.0F ? 1U : 0U));
}

}  // namespace

int Reflector::rayCount(const ViewMaterial& m) const {
  return std::max(options_.reflection_samples, 1) * (m.f0 > kStrong ? 2 : 1);
}

void Reflector::follow(std::span<const ReflectingPixel> pixels, ReflectorScratch& s) const {
  s.rays.clear();
  s.paths.clear();
  s.shadow_rays.clear();
  s.shadows.clear();
  s.first_ray.clear();
  s.radiance.clear();
  for (const ReflectingPixel& pixel : pixels) {
    s.first_ray.push_back(static_cast<std::uint32_t>(s.rays.size()));
    spawn(pixel, s);
  }
  s.first_ray.push_back(static_cast<std::uint32_t>(s.rays.size()));
  s.radiance.assign(s.rays.size(), vec3(0.0F));
  for (int depth = 1; depth <= options_.max_reflections && !s.rays.empty(); ++depth) {
    traceWave(s, depth == options_.max_reflections);
  }
  traceShadows(s);
}

void Reflector::render(std::span<ReflectingPixel> pixels, ReflectorScratch& s,
                       SpecularLayer& layer) const {
  for (ReflectingPixel& pixel : pixels) {
    pixel.part = phaseOf(pixel.x, pixel.y);
    pixel.rays = rayCount(scene_.material(pixel.samples.front().point.triangle));
  }
  follow(pixels, s);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const SurfaceSample& first = pixels[i].samples.front();
    // Only mirrors show edges sharp enough to need weights.
    PixelMean mean(first.alpha < kMirrorAlpha ? options_.edge_white : 0.0F);
    for (std::uint32_t ray = s.first_ray[i]; ray < s.first_ray[i + 1]; ++ray)
      mean.add(s.radiance[ray]);
    auto& out =
        layer.pixels[static_cast<std::size_t>(pixels[i].y) * static_cast<std::size_t>(layer.width) +
                     static_cast<std::size_t>(pixels[i].x)];
    out.radiance = mean.value();
    out.position = first.point.position;
    out.normal = first.point.shading_normal;
    out.alpha = first.alpha;
    out.material = first.material;
  }
}

void Reflector::renderWhole(std::span<const ReflectingPixel> pixels, ReflectorScratch& s,
                            SpecularLayer& layer) const {
  s.alone.clear();
  for (const ReflectingPixel& pixel : pixels) {
    const auto count = static_cast<int>(pixel.samples.size());
    for (int k = 0; k < count; ++k) {
      const auto sample = pixel.samples.subspan(static_cast<std::size_t>(k), 1);
      const int block =
          kPhases * kPhases * rayCount(scene_.material(sample.front().point.triangle));
      // Neighbours start elsewhere in the set, lest they all err alike.
      const auto part = static_cast<std::uint32_t>(phaseOf(pixel.x, pixel.y)) *
                            static_cast<std::uint32_t>(count) +
                        static_cast<std::uint32_t>(k);
      s.alone.push_back({pixel.x, pixel.y, sample, part, (block + count - 1) / count});
    }
  }
  follow(s.alone, s);
  std::size_t at = 0;
  for (const ReflectingPixel& pixel : pixels) {
    vec3 sum(0.0F);
    for (std::size_t k = 0; k < pixel.samples.size(); ++k, ++at) {
      vec3 own(0.0F);
      for (std::uint32_t ray = s.first_ray[at]; ray < s.first_ray[at + 1]; ++ray) {
        own += s.radiance[ray];
      }
      sum += own / static_cast<float>(s.first_ray[at + 1] - s.first_ray[at]);
    }
    auto& out =
        layer.pixels[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(layer.width) +
                     static_cast<std::size_t>(pixel.x)];
    out.radiance = sum / static_cast<float>(pixel.samples.size());
    out.whole = true;
  }
}

void Reflector::spawn(const ReflectingPixel& pixel, ReflectorScratch& s) const {
  const ViewMaterial& m = scene_.material(pixel.samples.front().point.triangle);
  const bool mirror = pixel.samples.front().alpha < kMirrorAlpha;
  const int count = mirror ? static_cast<int>(pixel.samples.size()) : pixel.rays;
  const dvec2 turn = hashed(options_.seed);
  const std::uint32_t base = pixel.part * static_cast<std::uint32_t>(count);
  for (int k = 0; k < count; ++k) {
    const SurfaceSample& from = pixel.samples[static_cast<std::size_t>(k) % pixel.samples.size()];
    const Frame frame(from.point.shading_normal);
    const vec2 u = fraction(r2Sequence(base + static_cast<std::uint32_t>(k)) + turn);
    const LobeSample lobe = sampleGgx(frame.toLocal(from.to_eye), m.f0, from.alpha, u);
    geometry::Ray ray;
    ray.origin = geometry::offsetOrigin(from.point.position, from.point.normal);
    ray.direction = aboveSurface(frame.toScene(lobe.wi), from.point.normal);
    if (lobe.weight <= 0.0F) ray.t_max = -1.0F;  // carries nothing: meets nothing
    s.rays.push_back(ray);
    s.paths.push_back({.target = static_cast<std::uint32_t>(s.rays.size() - 1),
                       .throughput = vec3(lobe.weight),
                       .pdf = static_cast<float>(count) * lobe.pdf,
                       .alpha = from.alpha,
                       .spread = pixel_angle_ + kLobeSpread * from.alpha,
                       .footprint = from.footprint});
  }
  // The highlight belongs to the pixel: its first ray takes it for all.
  const auto rays = static_cast<float>(count);
  const auto first = static_cast<std::uint32_t>(s.rays.size()) - static_cast<std::uint32_t>(count);
  aimAtLuminaires(
      {pixel.samples.front(), m.f0, pixel.samples.front().alpha, rays, vec3(rays), first},
      [&](std::size_t e) {
        return fraction(r2Sequence(pixel.part) + hashed(options_.seed + e + 1));
      },
      s);
}

template <class Points>
void Reflector::aimAtLuminaires(const Lobe& lobe, const Points& u_of, ReflectorScratch& s) const {
  if (lobe.alpha < kMirrorAlpha) return;
  const SurfacePoint& point = lobe.at.point;
  const Frame frame(point.shading_normal);
  const vec3 wo = frame.toLocal(lobe.at.to_eye);
  const vec3 origin = geometry::offsetOrigin(point.position, point.normal);
  const auto& emitters = scene_.emitters();
  for (std::size_t e = 0; e < emitters.size(); ++e) {
    const light::Emitter& emitter = emitters[e];
    if (emitter.gain <= 0.0) continue;
    const LightAim aim = aimAt(emitter, dvec3(origin), u_of(e));
    const vec3 wi(aim.direction);
    if (!(aim.distance > 0.0) || glm::dot(wi, point.normal) <= 0.0F) continue;
    const vec3 local = frame.toLocal(wi);
    const float reflected = ggxReflection(wo, local, lobe.f0, lobe.alpha);
    if (reflected <= 0.0F) continue;
    vec3 carried = aim.intensity * reflected;  // a point, else 0
    if (aim.pdf > 0.0) {
      const float pdf = lobe.rays * ggxPdf(wo, local, lobe.alpha) + static_cast<float>(aim.pdf);
      carried = scene_.emitted(static_cast<int>(e), vec3(aim.normal), -wi) * (reflected / pdf);
    }
    if (color::luminance(carried) <= 0.0F) continue;
    // Ends short of the luminaire, which may lie in a ceiling.
    const geometry::Ray ray{origin, 0.0F, wi,
                            static_cast<float>(aim.distance * (1.0 - 1.0e-4) - 5.0e-4)};
    if (scene_.emitterHits().blocked(ray, static_cast<int>(e))) continue;
    s.shadow_rays.push_back(ray);
    s.shadows.push_back({lobe.target, lobe.throughput * carried});
  }
}

void Reflector::traceShadows(ReflectorScratch& s) const {
  s.blocked.resize(s.shadow_rays.size());
  scene_.caster().occluded(s.shadow_rays, s.blocked);
  std::vector<float> through;
  if (scene_.panes() != nullptr) {
    for (const std::uint8_t blocked : s.blocked) through.push_back(blocked == 0 ? 1.0F : 0.0F);
    scene_.panes()->attenuate(s.shadow_rays, through);
  }
  for (std::size_t i = 0; i < s.shadows.size(); ++i) {
    if (s.blocked[i] != 0) continue;
    const float share = through.empty() ? 1.0F : through[i];
    s.radiance[s.shadows[i].target] += share * s.shadows[i].radiance;
  }
}

void Reflector::traceWave(ReflectorScratch& s, bool last) const {
  s.hits.resize(s.rays.size());
  s.first.resize(s.rays.size());
  traceFirst(scene_, s.rays, {}, s.hits, s.first);
  s.arrivals.clear();
  s.next_rays.clear();
  s.next_paths.clear();
  for (std::size_t i = 0; i < s.rays.size(); ++i) {
    if (s.first[i].emitter.valid()) {
      meetEmitter(i, s);
    } else if (s.first[i].surface.valid()) {
      meetSurface(i, last, s);
    } else {
      // The sun in a rough lobe would be nothing but sparks: mirrors alone show it.
      const bool mirror = s.paths[i].alpha < kMirrorAlpha;
      s.radiance[s.paths[i].target] +=
          s.first[i].through * s.paths[i].throughput *
          scene_.outside(s.rays[i].direction, mirror).value_or(options_.background);
    }
  }
  lightArrivals(s);
  std::swap(s.rays, s.next_rays);
  std::swap(s.paths, s.next_paths);
}

void Reflector::meetEmitter(std::size_t i, ReflectorScratch& s) const {
  const ReflectorScratch::Path& path = s.paths[i];
  const EmitterHit& hit = s.first[i].emitter;
  if (!hit.emits) return;
  float share = 1.0F;
  if (path.pdf > 0.0F) {
    const auto& emitter = scene_.emitters()[static_cast<std::size_t>(hit.emitter)];
    const double pdf = aimPdf(emitter, dvec3(s.rays[i].origin), dvec3(s.rays[i].direction),
                              static_cast<double>(hit.t), dvec3(hit.normal));
    share = path.pdf / (path.pdf + static_cast<float>(pdf));
  }
  s.radiance[path.target] += s.first[i].through * share * path.throughput *
                             scene_.emitted(hit.emitter, hit.normal, -s.rays[i].direction);
}

void Reflector::meetSurface(std::size_t i, bool last, ReflectorScratch& s) const {
  const ReflectorScratch::Path& path = s.paths[i];
  const SurfaceSample at = sampleSurface(scene_, s.rays[i], s.first[i].surface,
                                         {.spread = path.spread, .footprint = path.footprint});
  const vec3 arriving = s.first[i].through * path.throughput;
  const ViewMaterial& m = scene_.material(at.point.triangle);
  // Beyond the last reflection a rough lobe stands as so much more diffuse reflection.
  const bool ends = last && at.alpha >= kMirrorAlpha;
  const vec3 factor = arriving * (ends ? sent_.of(at) : at.albedo) / kPiF;
  if (color::luminance(factor) > 0.0F) {
    s.arrivals.push_back({cellOf(at, at.footprint), path.target, factor, at.point, at.surface});
    if (path.alpha >= kMirrorAlpha) s.arrivals.back().point.blur = kLightBlur * at.footprint;
  }
  if (last || m.f0 <= 0.0F) return;
  const float fresnel = schlick(m.f0, glm::dot(at.point.shading_normal, at.to_eye));
  if (color::luminance(arriving) * fresnel < kLeastThroughput) return;
  const float alpha = std::max(at.alpha, path.alpha);
  const std::uint64_t key = options_.seed ^ mixBits(cellOf(at, 1.0e-6F) + path.target);
  aimAtLuminaires(
      {at, m.f0, alpha, 1.0F, arriving, path.target},
      [&](std::size_t e) { return fraction(hashed(key + e + 1)); }, s);
  const Frame frame(at.point.shading_normal);
  const LobeSample lobe = sampleGgx(frame.toLocal(at.to_eye), m.f0, alpha, fraction(hashed(key)));
  if (lobe.weight <= 0.0F) return;
  geometry::Ray ray;
  ray.origin = geometry::offsetOrigin(at.point.position, at.point.normal);
  ray.direction = aboveSurface(frame.toScene(lobe.wi), at.point.normal);
  s.next_rays.push_back(ray);
  s.next_paths.push_back({.target = path.target,
                          .throughput = arriving * lobe.weight,
                          .pdf = lobe.pdf,
                          .alpha = alpha,
                          .spread = path.spread + kLobeSpread * alpha,
                          .footprint = at.footprint});
}

void Reflector::lightArrivals(ReflectorScratch& s) const {
  s.order.clear();
  for (std::size_t i = 0; i < s.arrivals.size(); ++i) {
    s.order.emplace_back(s.arrivals[i].cell, static_cast<std::uint32_t>(i));
  }
  std::sort(s.order.begin(), s.order.end());
  // The first arrival of a cell stands for all. Evaluated in the order of arrival: neighbours in
  // the picture are neighbours in the reflection.
  s.speaker.resize(s.arrivals.size());
  for (std::size_t i = 0; i < s.order.size(); ++i) {
    const bool same = i > 0 && s.order[i].first == s.order[i - 1].first;
    s.speaker[s.order[i].second] = same ? s.speaker[s.order[i - 1].second] : s.order[i].second;
  }
  s.batch.clear();
  s.light_of.resize(s.arrivals.size());
  for (std::size_t i = 0; i < s.arrivals.size(); ++i) {
    if (s.speaker[i] == i) s.light_of[i] = s.batch.add(s.arrivals[i].point, s.arrivals[i].surface);
  }
  s.batch.run(illumination_);
  for (std::size_t i = 0; i < s.arrivals.size(); ++i) {
    const auto& arrival = s.arrivals[i];
    s.radiance[arrival.target] += arrival.factor * s.batch.total(s.light_of[s.speaker[i]]);
  }
}

}  // namespace soffit::render
