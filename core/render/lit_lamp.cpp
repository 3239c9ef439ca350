// SPDX-License-Identifier: MIT
#include "core/render/lit_lamp.h"

#include "core/base/parallel.h"
#include "core/math/sampling.h"
#include "core/render/microfacet.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

using light::EmitterKind;

constexpr int kMostPieces = 4;
/// m: light starts so far before a flat luminaire, which may lie in a ceiling.
constexpr double kBefore = 0.005;
constexpr float kShortTube = 0.3F;  // m: no shorter pieces of tubes

const sh::SphereSamples& directions() {
  static const sh::SphereSamples made = sh::cubeSamples(LampMap::kSide);
  return made;
}

/// Far-field candela of the whole luminaire.
double candela(const light::Emitter& e, const dvec3& d) {
  if (e.table != nullptr || !e.lambertian || e.kind == EmitterKind::point) {
    return e.pointIntensity(d);
  }
  switch (e.kind) {
    case EmitterKind::sphere:
      return e.luminance * kPi * e.radius * e.radius;
    case EmitterKind::tube: {
      const double cosine = glm::dot(e.axis, d);
      const double sine = std::sqrt(std::max(0.0, (1.0 - cosine) * (1.0 + cosine)));
      return e.luminance * 4.0 * e.radius * e.half_length * sine;
    }
    case EmitterKind::mesh: {
      // Front faces; what they hide of one another is not looked for.
      double area = 0.0;
      for (std::size_t i = 0; i < e.triangle_normals.size(); ++i) {
        area += e.triangle_areas[i] * std::max(0.0, glm::dot(e.triangle_normals[i], d));
      }
      return e.luminance * area;
    }
    default:
      return e.luminance * e.area * std::max(0.0, glm::dot(e.normal, d));
  }
}

/// Where the pieces lie, and how large each looks.
struct Pieces {
  dvec3 first{0.0};
  dvec3 step{0.0};
  int count = 1;
  double radius = 0.0;
};

Pieces piecesOf(const light::Emitter& e, int most) {
  const auto inRow = [](const dvec3& middle, const dvec3& along, double length, int count,
                        double radius) {
    const dvec3 step = along * (length / count);
    return Pieces{middle - 0.5 * (count - 1) * step, step, count, radius};
  };
  if (e.kind == EmitterKind::point) return {e.position, {}, 1, 0.0};
  if (e.kind == EmitterKind::sphere) return {e.position, {}, 1, e.radius};
  if (e.kind == EmitterKind::tube) {
    const double length = 2.0 * e.half_length;
    const double shortest = std::max(2.0 * e.radius, static_cast<double>(kShortTube));
    const int count = std::clamp(static_cast<int>(std::lround(length / shortest)), 1, most);
    return inRow(e.position, e.axis, length, count,
                 std::sqrt(2.0 * e.radius * length / count / kPi));
  }
  const dvec3 middle(e.bounds.center());
  if (e.kind == EmitterKind::mesh) {
    return {middle, {}, 1, std::sqrt(e.area / (4.0 * kPi))};
  }
  const dvec3 before = middle + kBefore * e.normal;
  dvec2 low(0.0);
  dvec2 high(0.0);
  for (const dvec3& p : e.outline) {
    const dvec3 local = glm::transpose(e.world_from_light) * (p - middle);
    low = glm::min(low, dvec2(local));
    high = glm::max(high, dvec2(local));
  }
  const dvec2 size = high - low;
  const double longer = std::max(size.x, size.y);
  const double shorter = std::max(std::min(size.x, size.y), 1.0e-6);
  const int count =
      e.disk ? 1 : std::clamp(static_cast<int>(std::lround(longer / shorter)), 1, most);
  return inRow(before, e.world_from_light[size.x >= size.y ? 0 : 1], longer, count,
               std::sqrt(e.area / count / kPi));
}

/// Which luminaires are made lamps of, in their order.
std::vector<std::size_t> strongest(std::span<const light::Emitter> emitters,
                                   std::span<const vec3> before) {
  std::vector<std::pair<double, std::size_t>> by_gift;
  for (std::size_t i = 0; i < emitters.size(); ++i) {
    const light::Emitter& e = emitters[i];
    if (e.gain <= 0.0) continue;
    float nearest = before.empty() ? 0.0F : 1.0e30F;
    for (const vec3& p : before) nearest = std::min(nearest, e.bounds.distanceSquared(p));
    by_gift.emplace_back(-e.gain * e.flux / (1.0 + static_cast<double>(nearest)), i);
  }
  std::ranges::sort(by_gift);
  if (by_gift.size() > LampMaker::kMostLamps) by_gift.resize(LampMaker::kMostLamps);
  std::vector<std::size_t> chosen;
  chosen.reserve(by_gift.size());
  for (const auto& [gift, i] : by_gift) chosen.push_back(i);
  std::ranges::sort(chosen);
  return chosen;
}

/// Whether two emitters send the same light from the same place, dimming and colour left out.
bool sameLight(const light::Emitter& a, const light::Emitter& b) {
  return a.kind == b.kind && a.position == b.position && a.world_from_light == b.world_from_light &&
         a.radius == b.radius && a.half_length == b.half_length && a.area == b.area &&
         a.flux == b.flux && a.lambertian == b.lambertian && a.table == b.table &&
         a.table_scale == b.table_scale && a.outline == b.outline && a.corners == b.corners;
}

}  // namespace

LampMap::LampMap(const geometry::RayCaster& caster, const light::Emitter& emitter,
                 const vec3& from) {
  std::vector<geometry::Ray> rays;
  rays.reserve(directions().size());
  for (const dvec3& d : directions().directions) rays.push_back({from, 0.0F, vec3(d)});
  std::vector<geometry::Hit> hits(rays.size());
  caster.closest(rays, hits, true);
  std::vector<float> distances;
  distances.reserve(hits.size());
  for (const geometry::Hit& hit : hits) distances.push_back(hit.t);
  const glossy::ProbeDepth depth(kSide, distances);
  texels_.reserve(depth.rimmed().size());
  for (int face = 0; face < 6; ++face) {
    for (int row = -1; row <= kSide; ++row) {
      for (int column = -1; column <= kSide; ++column) {
        const dvec3 d = sh::cubeDirection(sh::texelCenter(face, column, row, kSide));
        texels_.emplace_back(depth.rimmed()[texels_.size()],
                             static_cast<float>(candela(emitter, d)));
      }
    }
  }
}

LampMap::Seen LampMap::toward(const vec3& direction) const {
  const sh::CubePoint p = sh::cubePoint(dvec3(direction));
  const auto place = [](double u) {
    return std::clamp(0.5 * (u + 1.0) * kSide + 0.5, 0.5, kSide + 0.5);
  };
  const double x = place(p.u);
  const double y = place(p.v);
  const auto i = std::min(static_cast<std::size_t>(x), std::size_t{kSide});
  const auto j = std::min(static_cast<std::size_t>(y), std::size_t{kSide});
  constexpr std::size_t kWide = kSide + 2;
  const vec2* first = texels_.data() + (static_cast<std::size_t>(p.face) * kWide + j) * kWide + i;
  const auto s = static_cast<float>(x - static_cast<double>(i));
  const auto t = static_cast<float>(y - static_cast<double>(j));
  const vec2 seen =
      glm::mix(glm::mix(first[0], first[1], s), glm::mix(first[kWide], first[kWide + 1], s), t);
  return {static_cast<float>(std::sqrt(1.0 + p.u * p.u + p.v * p.v)) / seen.x, seen.y};
}

vec3 lampHighlight(const LitLamp& lamp, const vec3& position, const vec3& normal,
                   const vec3& to_eye, float f0, float alpha) {
  const vec3 away = position - lamp.position;
  const float r = std::max(glm::length(away), 1.0e-4F);
  const vec3 wi = -away / r;
  if (glm::dot(wi, normal) <= 0.0F) return vec3(0.0F);
  const LampMap::Seen seen = lamp.map->toward(away);
  // How far behind what the lamp sees the point is: a texel of the map is 2.5 % of r wide.
  const float behind = r - seen.distance;
  const float lit =
      1.0F - glm::smoothstep(LitLamp::kSeen * (r + 1.0F), LitLamp::kHidden * (r + 1.0F), behind);
  if (lit * seen.candela <= 0.0F) return vec3(0.0F);
  vec3 t;
  vec3 b;
  orthonormalBasis(normal, t, b);
  const auto local = [&](const vec3& v) {
    return vec3(glm::dot(v, t), glm::dot(v, b), glm::dot(v, normal));
  };
  const float spread = lamp.radius / r;
  const float wide =
      std::clamp(std::sqrt(alpha * alpha + LitLamp::kSpread * spread * spread), kMirrorAlpha, 1.0F);
  const float nearest = std::max(r, lamp.radius);
  return lit * seen.candela / (nearest * nearest) *
         ggxReflection(local(to_eye), local(wi), f0, wide) * lamp.color;
}

std::vector<LitLamp> LampMaker::lampsOf(std::span<const light::Emitter> emitters,
                                        const geometry::RayCaster& caster,
                                        std::span<const vec3> before) {
  const std::vector<std::size_t> chosen = strongest(emitters, before);
  const int most_pieces = chosen.size() > kFewLuminaires ? 1 : kMostPieces;
  std::vector<Known> now(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    now[i].emitter = emitters[chosen[i]];
    now[i].pieces = most_pieces;
    const auto same = std::ranges::find_if(known_, [&](const Known& k) {
      return k.pieces == most_pieces && sameLight(k.emitter, now[i].emitter);
    });
    if (same != known_.end()) now[i].lamps = same->lamps;
  }
  parallelFor(now.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const light::Emitter& e = now[i].emitter;
      if (!now[i].lamps.empty()) continue;
      const Pieces pieces = piecesOf(e, most_pieces);
      for (int k = 0; k < pieces.count; ++k) {
        const vec3 at(pieces.first + static_cast<double>(k) * pieces.step);
        now[i].lamps.push_back({at, static_cast<float>(pieces.radius),
                                vec3(1.0F / static_cast<float>(pieces.count)),
                                std::make_shared<const LampMap>(caster, e, at)});
      }
    }
  });
  known_ = std::move(now);
  std::vector<LitLamp> lamps;
  for (const Known& known : known_) {
    for (LitLamp lamp : known.lamps) {
      lamp.color *= vec3(known.emitter.gain * known.emitter.color);
      lamps.push_back(std::move(lamp));
    }
  }
  return lamps;
}

}  // namespace soffit::render
