// SPDX-License-Identifier: MIT
#include "core/glossy/probe_sight.h"

#include "core/math/sampling.h"
#include "core/sh/cube_map.h"

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

constexpr int kWide = ProbeSight::kSide + 2;
constexpr std::uint32_t kSamples = 64;

/// Evenly over a disc of radius 1.
std::vector<vec2> discPoints() {
  std::vector<vec2> points;
  points.reserve(kSamples);
  for (std::uint32_t k = 0; k < kSamples; ++k) {
    const dvec2 u = r2Sequence(k);
    const double radius = std::sqrt(u.x);
    const double angle = 2.0 * kPi * u.y;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

vec2 momentsAbout(const ProbeDepth& depth, const vec3& d, std::span<const vec2> disc) {
  vec3 t(0.0F);
  vec3 b(0.0F);
  orthonormalBasis(d, t, b);
  dvec2 sum(0.0);
  for (const vec2& p : disc) {
    const double distance = static_cast<double>(
        std::min(depth.toward(d + ProbeSight::kCone * (p.x * t + p.y * b)), ProbeSight::kFarthest));
    sum += dvec2(distance, distance * distance);
  }
  return vec2(sum / static_cast<double>(disc.size()));
}

}  // namespace

ProbeSight::ProbeSight(const ProbeDepth& depth) {
  const std::vector<vec2> disc = discPoints();
  moments_.reserve(static_cast<std::size_t>(6 * kWide * kWide));
  for (int face = 0; face < 6; ++face) {
    const auto& axes = sh::kCubeFaces[static_cast<std::size_t>(face)];
    for (int row = -1; row <= kSide; ++row) {
      for (int column = -1; column <= kSide; ++column) {
        const sh::CubePoint p = sh::texelCenter(face, column, row, kSide);
        const dvec3 d = axes.forward + p.u * axes.right - p.v * axes.up;
        moments_.push_back(momentsAbout(depth, vec3(glm::normalize(d)), disc));
      }
    }
  }
}

float ProbeSight::of(const vec3& from_probe) const {
  const float away = glm::length(from_probe);
  if (!(away > 0.0F)) return 1.0F;
  const sh::CubePoint p = sh::cubePoint(dvec3(from_probe));
  constexpr double kLast = kSide - 0.5;
  const double x = std::clamp(0.5 * (p.u + 1.0) * kSide - 0.5, -0.5, kLast);
  const double y = std::clamp(0.5 * (p.v + 1.0) * kSide - 0.5, -0.5, kLast);
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const auto s = static_cast<float>(x - i);
  const auto t = static_cast<float>(y - j);
  const vec2* first =
      moments_.data() + static_cast<std::size_t>((p.face * kWide + j + 1) * kWide + i + 1);
  const vec2 m =
      glm::mix(glm::mix(first[0], first[1], s), glm::mix(first[kWide], first[kWide + 1], s), t);
  const float excess = kShare * away - m.x;
  if (excess <= 0.0F) return 1.0F;
  const float least = kLeastDeviation * away;
  const float variance = std::max(m.y - m.x * m.x, least * least);
  return glm::smoothstep(kHidden, 1.0F, variance / (variance + excess * excess));
}

}  // namespace soffit::glossy
