// SPDX-License-Identifier: MIT
#include "core/relight/reflectance.h"

#include "core/math/sampling.h"
#include "core/scene/roughness.h"

#include <algorithm>
#include <cmath>

namespace soffit::relight {
namespace {

/// Mean of an image's texels over a square of `width` (in uv units) about a place, repeating.
dvec3 averageTexture(const scene::Image& image, const vec2& uv, float width) {
  constexpr int kTaps = 4;
  dvec3 sum(0.0);
  for (int j = 0; j < kTaps; ++j) {
    for (int i = 0; i < kTaps; ++i) {
      const float u = uv.x + width * ((static_cast<float>(i) + 0.5F) / kTaps - 0.5F);
      const float v = uv.y + width * ((static_cast<float>(j) + 0.5F) / kTaps - 0.5F);
      const float fu = u - std::floor(u);
      const float fv = v - std::floor(v);
      const int x =
          std::min(static_cast<int>(fu * static_cast<float>(image.width)), image.width - 1);
      // Row 0 is the top, v runs up.
      const int y = std::min(static_cast<int>((1.0F - fv) * static_cast<float>(image.height)),
                             image.height - 1);
      const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(x)) *
                             static_cast<std::size_t>(image.channels);
      for (int c = 0; c < 3; ++c) {
        sum[c] += static_cast<double>(
            image.pixels[at + static_cast<std::size_t>(std::min(c, image.channels - 1))]);
      }
    }
  }
  return sum / static_cast<double>(kTaps * kTaps);
}

}  // namespace

double lobeAlbedo(double specular, double roughness) {
  if (specular <= 0.0) return 0.0;
  const auto schlick = [&](double c) {
    const double m = 1.0 - c;
    return specular + (1.0 - specular) * m * m * m * m * m;
  };
  const double alpha = std::max(roughness * roughness, 1e-4);
  const auto lambda = [&](double mu) {
    const double tan2 = std::max(0.0, 1.0 - mu * mu) / std::max(mu * mu, 1e-12);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
  };
  constexpr std::uint32_t kSamples = 4096;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const dvec2 u = r2Sequence(i);
    const double u3 = radicalInverse2(i);
    // mu with density 2 mu, then a visible normal of the GGX distribution (Heitz 2018).
    const double mu = std::sqrt(u.x);
    const dvec3 v(std::sqrt(std::max(0.0, 1.0 - mu * mu)), 0.0, mu);
    const dvec3 vh = glm::normalize(dvec3(alpha * v.x, alpha * v.y, v.z));
    const double r = std::sqrt(u.y);
    const double phi = 2.0 * kPi * u3;
    const double t1 = r * std::cos(phi);
    double t2 = r * std::sin(phi);
    const double s = 0.5 * (1.0 + vh.z);
    t2 = (1.0 - s) * std::sqrt(std::max(0.0, 1.0 - t1 * t1)) + s * t2;
    const double len2 = vh.x * vh.x + vh.y * vh.y;
    const dvec3 axis1 = len2 > 0.0 ? dvec3(-vh.y, vh.x, 0.0) / std::sqrt(len2) : dvec3(1, 0, 0);
    const dvec3 axis2 = glm::cross(vh, axis1);
    const dvec3 nh =
        t1 * axis1 + t2 * axis2 + std::sqrt(std::max(0.0, 1.0 - t1 * t1 - t2 * t2)) * vh;
    const dvec3 h = glm::normalize(dvec3(alpha * nh.x, alpha * nh.y, std::max(0.0, nh.z)));
    const dvec3 l = 2.0 * glm::dot(v, h) * h - v;
    if (l.z <= 0.0) continue;
    // Weight F G2/G1 with height-correlated G2.
    const double lv = lambda(mu);
    sum += schlick(std::max(0.0, glm::dot(v, h))) * (1.0 + lv) / (1.0 + lv + lambda(l.z));
  }
  return sum / kSamples;
}

Reflectances makeReflectances(const transfer::Texels& texels,
                              std::span<const scene::Material> materials) {
  Reflectances out;
  const std::size_t slots = texels.slotCount();
  for (auto& channel : out.rho) channel.assign(slots, 0.0F);
  std::vector<double> lobe(materials.size(), 0.0);
  for (std::size_t m = 0; m < materials.size(); ++m)
    lobe[m] = lobeAlbedo(materials[m].specular, scene::roughnessRange(materials[m]).mean);
  for (std::size_t s = 0; s < slots; ++s) {
    if (texels.material[s] >= materials.size()) continue;
    const scene::Material& m = materials[texels.material[s]];
    if (m.glass) continue;
    dvec3 diffuse = m.diffuse;
    if (m.diffuse_image != nullptr)
      diffuse *= averageTexture(*m.diffuse_image, texels.uv[s], texels.uv_width[s]);
    for (int c = 0; c < 3; ++c) {
      out.rho[static_cast<std::size_t>(c)][s] =
          static_cast<float>(std::clamp(diffuse[c] + lobe[texels.material[s]], 0.0, 1.0));
    }
    out.grey = out.grey && out.rho[0][s] == out.rho[1][s] && out.rho[1][s] == out.rho[2][s];
  }
  return out;
}

}  // namespace soffit::relight
