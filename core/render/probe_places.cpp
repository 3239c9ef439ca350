// SPDX-License-Identifier: MIT
#include "core/render/probe_places.h"

#include "core/base/parallel.h"
#include "core/sh/sphere_samples.h"

#include <algorithm>
#include <cstdint>

namespace soffit::render {
namespace {

constexpr std::size_t kDeciding = 384;
constexpr float kBefore = 1.2F;     // m
constexpr float kReach = 4.0F;      // m
constexpr float kClearance = 0.1F;  // m: nearer to what it reflects a probe sees little else
constexpr double kLeft = 0.01;
/// How often every piece is to be seen: from one side alone much that it reflects is hidden.
constexpr int kTimes = 2;

/// Pieces at even steps of the area.
std::vector<ReflectingPiece> drawn(std::span<const ReflectingPiece> pieces) {
  double total = 0.0;
  for (const ReflectingPiece& piece : pieces) total += static_cast<double>(piece.area);
  if (!(total > 0.0)) return {};
  const std::size_t count = std::min(kDeciding, pieces.size());
  std::vector<ReflectingPiece> out;
  double sum = 0.0;
  for (const ReflectingPiece& piece : pieces) {
    sum += static_cast<double>(piece.area);
    const double due = (static_cast<double>(out.size()) + 0.5) / static_cast<double>(count);
    if (sum >= due * total) out.push_back(piece);
  }
  const float each =
      static_cast<float>(total / static_cast<double>(std::max<std::size_t>(out.size(), 1)));
  for (ReflectingPiece& piece : out) piece.area = each;
  return out;
}

/// Whether more than a tenth of what lies on the side of the piece that reflects is not void.
bool seesAnything(const geometry::RayCaster& caster, const vec3& from, const vec3& normal) {
  static const sh::SphereSamples around = sh::hammersleySamples(64);
  const auto met = std::ranges::count_if(around.directions, [&](const dvec3& d) {
    return glm::dot(vec3(d), normal) > 0.0F && caster.occluded({from, 0.0F, vec3(d)});
  });
  return met > 3;
}

std::vector<vec3> candidatesOf(const geometry::RayCaster& caster,
                               std::span<const ReflectingPiece> pieces, bool sky) {
  std::vector<vec3> places;
  for (const ReflectingPiece& piece : pieces) {
    const vec3 from = geometry::offsetOrigin(piece.position, piece.normal);
    const geometry::Hit hit = caster.closest({from, 0.0F, piece.normal, 2.0F * kBefore});
    const float before = hit.valid() ? 0.5F * hit.t : kBefore;
    if (!sky && !seesAnything(caster, from, piece.normal)) continue;
    if (before > kClearance) places.push_back(from + before * piece.normal);
  }
  return places;
}

bool sees(const geometry::RayCaster& caster, const vec3& place, const ReflectingPiece& piece) {
  const vec3 to = geometry::offsetOrigin(piece.position, piece.normal) - place;
  const float distance = glm::length(to);
  if (distance > kReach || glm::dot(to, piece.normal) >= 0.0F) return false;
  return !caster.occluded({place, 0.0F, to, 1.0F});
}

}  // namespace

std::vector<vec3> probePlaces(const geometry::RayCaster& caster,
                              std::span<const ReflectingPiece> pieces, std::size_t most, bool sky) {
  const std::vector<ReflectingPiece> deciding = drawn(pieces);
  const std::vector<vec3> candidates = candidatesOf(caster, deciding, sky);
  const std::size_t n = deciding.size();
  std::vector<std::uint8_t> seen(candidates.size() * n);
  parallelFor(candidates.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      for (std::size_t k = 0; k < n; ++k)
        seen[c * n + k] = sees(caster, candidates[c], deciding[k]);
    }
  });
  std::vector<vec3> chosen;
  std::vector<int> times(n, 0);  // that a piece is seen
  for (int round = 1; round <= kTimes; ++round) {
    const auto lacking = [&](std::size_t k) { return times[k] < round; };
    auto left =
        static_cast<std::size_t>(std::ranges::count_if(times, [&](int t) { return t < round; }));
    while (chosen.size() < most && static_cast<double>(left) > kLeft * static_cast<double>(n)) {
      std::size_t best = 0;
      std::size_t gain = 0;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        std::size_t fresh = 0;
        for (std::size_t k = 0; k < n; ++k) fresh += (seen[c * n + k] != 0 && lacking(k)) ? 1 : 0;
        if (fresh > gain) {
          gain = fresh;
          best = c;
        }
      }
      if (gain == 0) break;
      chosen.push_back(candidates[best]);
      for (std::size_t k = 0; k < n; ++k) {
        times[k] += seen[best * n + k];
        seen[best * n + k] = 0;  // once is enough
      }
      left -= gain;
    }
  }
  return chosen;
}

}  // namespace soffit::render
