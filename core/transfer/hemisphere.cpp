// SPDX-License-Identifier: MIT
#include "core/transfer/hemisphere.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <algorithm>
#include <limits>

namespace soffit::transfer {
namespace {

/// Mirrorings after which a ray is given up.
constexpr int kMostSheets = 16;

/// Of all rays: where all others leave the scene, so few that meet it do not count.
constexpr double kStray = 1.0 / 128.0;

/// Sends a ray through the sheets before its hit; where one mirrors it, ray and hit become those of
/// the new way.
void passSheets(const StaticScene& scene, Rng& rng, geometry::Ray& ray, geometry::Hit& hit) {
  daylight::PaneCrossing at;
  geometry::Ray rest = ray;
  rest.t_max = hit.valid() ? hit.t : std::numeric_limits<float>::infinity();
  for (int mirrored = 0; scene.panes->next(rest, at);) {
    const double u = rng.uniformDouble();
    if (u < at.transmitted) {
      rest.t_min = daylight::Panes::beyond(at.t, rest.direction);
      continue;
    }
    hit = {};
    if (u >= at.transmitted + at.reflected || ++mirrored > kMostSheets) return;
    const vec3& up = scene.panes->normal(at.triangle);
    const vec3 n = glm::dot(up, ray.direction) > 0.0F ? -up : up;
    ray.origin = geometry::offsetOrigin(rest.origin + at.t * rest.direction, n);
    ray.direction -= 2.0F * glm::dot(ray.direction, n) * n;
    hit = scene.caster.closest(ray);
    rest = ray;
    rest.t_max = hit.valid() ? hit.t : std::numeric_limits<float>::infinity();
  }
}

}  // namespace

void traceHemisphere(const StaticScene& scene, const Texels& texels, const vec3& p, const vec3& n, int side,
                     std::uint64_t seed, float gap, HemisphereScratch& scratch, HemisphereHits& out) {
  const auto count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  scratch.rays.resize(count);
  scratch.hits.resize(count);
  Rng rng(mixBits(seed));
  vec3 t;
  vec3 b;
  orthonormalBasis(n, t, b);
  const float turn = 6.2831853F * rng.uniform();
  const vec3 t2 = std::cos(turn) * t + std::sin(turn) * b;
  const vec3 b2 = std::cos(turn) * b - std::sin(turn) * t;
  const vec3 origin = geometry::offsetOrigin(p, n);
  const float step = 1.0F / static_cast<float>(side);
  // Blocks of 4 x 4 strata make packets of 16 neighbouring directions.
  const int block = side % 4 == 0 ? 4 : 1;
  std::size_t k = 0;
  for (int bj = 0; bj < side; bj += block) {
    for (int bi = 0; bi < side; bi += block) {
      for (int j = bj; j < bj + block; ++j) {
        for (int i = bi; i < bi + block; ++i) {
          const vec3 d = cosineHemisphere((static_cast<float>(i) + rng.uniform()) * step,
                                          (static_cast<float>(j) + rng.uniform()) * step);
          geometry::Ray& ray = scratch.rays[k++];
          ray.origin = origin;
          ray.direction = d.x * t2 + d.y * b2 + d.z * n;
          ray.t_min = 0.0F;
          ray.t_max = std::numeric_limits<float>::infinity();
        }
      }
    }
  }
  scene.caster.closest(scratch.rays, scratch.hits);
  if (scene.panes != nullptr) {
    for (std::size_t i = 0; i < count; ++i) passSheets(scene, rng, scratch.rays[i], scratch.hits[i]);
  }
  out.slots.resize(count);
  out.missed = 0;
  out.inside = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const geometry::Hit& hit = scratch.hits[i];
    out.slots[i] = kNoTexel;
    if (!hit.valid()) {
      ++out.missed;
      continue;
    }
    const geometry::Ray& ray = scratch.rays[i];
    out.slots[i] = texels.at(hit.triangle, scene.hitsFront(hit.triangle, ray.direction), ray.origin + hit.t * ray.direction);
    if (out.slots[i] == kNoTexel) {
      ++out.inside;
    } else if (hit.t < gap && texels.openness[out.slots[i]] != 0) {
      out.slots[i] = kNoTexel;
    }
  }
  // The far side of a floor that furniture sinks into by 2 mm: a ray that ends there would bring
  // the light of the room, for the furniture's texel lies above the floor.
  const double met = static_cast<double>(count) - static_cast<double>(out.missed);
  if (met <= kStray * static_cast<double>(count)) {
    std::fill(out.slots.begin(), out.slots.end(), kNoTexel);
  }
}

}  // namespace soffit::transfer
