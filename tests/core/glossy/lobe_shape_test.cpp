// SPDX-License-Identifier: MIT
#include "core/glossy/lobe_shape.h"

#include "core/glossy/ggx.h"
#include "core/math/rng.h"
#include "core/render/microfacet.h"
#include "core/sh/zonal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::glossy {
namespace {

TEST(LobeShape, ReflectanceIsThatOfThePicturesSamples) {
  // The mean weight of core/render's importance sampling, 256 x 256 points of the square.
  for (const float cosine : {0.1F, 0.5F, 1.0F}) {
    for (const float alpha : {0.0625F, 0.25F, 1.0F}) {
      for (const float f0 : {0.04F, 0.7F}) {
        const vec3 wo(std::sqrt(1.0F - cosine * cosine), 0.0F, cosine);
        constexpr int kSide = 256;
        double sum = 0.0;
        for (int i = 0; i < kSide; ++i) {
          for (int j = 0; j < kSide; ++j) {
            const vec2 u((static_cast<float>(i) + 0.5F) / kSide,
                         (static_cast<float>(j) + 0.5F) / kSide);
            sum += static_cast<double>(render::sampleGgx(wo, f0, alpha, u).weight);
          }
        }
        const LobeShape shape =
            integrateLobe(static_cast<double>(cosine), static_cast<double>(alpha));
        EXPECT_NEAR(shape.reflectance(static_cast<double>(f0)), sum / (kSide * kSide),
                    2e-4);  // of its rule
      }
    }
  }
}

TEST(LobeShape, AtTheNormalTheLobeIsRoundAboutIt) {
  for (const double alpha : {0.05, 0.2, 0.5}) {
    const LobeShape shape = integrateLobe(1.0, alpha);
    EXPECT_NEAR(shape.base.axis_sine, 0.0, 1e-12);
    // Masking alone makes the true lobe narrower than the one without it.
    EXPECT_LE(shape.base.alpha, alpha * (1.0 + 1e-6));
    EXPECT_GT(shape.base.alpha, 0.75 * alpha);
  }
}

TEST(LobeShape, SharpLobesAreAboutTheMirrorDirection) {
  const LobeShape sharp = integrateLobe(0.6, 0.01);
  EXPECT_NEAR(sharp.base.axis_sine, 0.8, 2e-3);
  EXPECT_NEAR(sharp.base.above, 1.0, 1e-3);
  const LobeShape mirror = lobeShape(0.6, 1e-4);
  EXPECT_DOUBLE_EQ(mirror.base.axis_sine, 0.8);
  EXPECT_NEAR(mirror.reflectance(0.04), 0.04 + 0.96 * std::pow(0.4, 5), 1e-12);
}

TEST(LobeShape, ShareAboveAtTheNormalIsThatOfTheDistribution) {
  // Reflections rise above the surface where the half vector is within 45 degrees of the normal:
  // D cos up to mu^2 = 1/2 holds 1 / (1 + alpha^2). By 256 rings, of which one may lie across.
  for (const double alpha : {0.05, 0.2, 0.5}) {
    const LobeShape shape = integrateLobe(1.0, alpha);
    EXPECT_NEAR(shape.base.above, 1.0 / (1.0 + shape.base.alpha * shape.base.alpha), 1.0 / 256.0);
  }
}

TEST(LobeShape, LightThatVariesLinearlyIsReflectedExactly) {
  // Both lobes cut at the surface, by sums over directions: the true one by its own draws, the
  // round one over a fine grid of the upper half.
  for (const double cosine : {0.3, 0.8}) {
    const double alpha = 0.3;
    const LobeShape shape = integrateLobe(cosine, alpha);
    const dvec3 wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    const dvec3 axis(-shape.base.axis_sine, 0.0,
                     std::sqrt(1.0 - shape.base.axis_sine * shape.base.axis_sine));
    dvec3 true_mean(0.0), round_mean(0.0);
    double true_whole = 0.0, round_whole = 0.0;
    constexpr int kSide = 500;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const GgxDraw d = drawGgx(wo, alpha, {(i + 0.5) / kSide, (j + 0.5) / kSide});
        const double base = d.weight * (1.0 - schlickRise(d.cos_h));
        true_mean += base * d.wi;
        true_whole += base;
        const double z = (i + 0.5) / kSide;
        const double s = std::sqrt(1.0 - z * z);
        const double phi = 2.0 * kPi * (j + 0.5) / kSide;
        const dvec3 w(s * std::cos(phi), s * std::sin(phi), z);
        const double lobe =
            ggxDensity(std::sqrt(0.5 * (1.0 + glm::dot(w, axis))), shape.base.alpha);
        round_mean += lobe * w;
        round_whole += lobe;
      }
    }
    true_mean /= true_whole;
    round_mean /= round_whole;
    EXPECT_NEAR(round_mean.x, true_mean.x, 2e-3);  // rings of the fit: 1 / 256
    EXPECT_NEAR(round_mean.z, true_mean.z, 2e-3);
  }
}

TEST(LobeShape, GrazingLightIsReflectedByTheRise) {
  // A wall up to 39 degrees seen over a rough floor of f0 = 0.04: the true lobe's light from it,
  // against both round lobes, and against the base alone in the place of both.
  const auto wall = [](const dvec3& w) {
    const bool ahead = std::abs(std::atan2(w.y, -w.x)) < 1.0;
    return ahead && w.z > 0.0 && w.z < 0.8 * std::hypot(w.x, w.y) ? 1.0 : 0.0;
  };
  constexpr int kSide = 300;
  const double f0 = 0.04;
  for (const double alpha : {0.16, 0.3}) {
    for (const double cosine : {0.2, 0.5}) {
      const LobeShape shape = integrateLobe(cosine, alpha);
      const dvec3 wo(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
      double exact = 0.0, base = 0.0, rise = 0.0;
      const auto round = [](const RoundLobe& lobe, const dvec3& w) {
        const dvec3 axis(-lobe.axis_sine, 0.0, std::sqrt(1.0 - lobe.axis_sine * lobe.axis_sine));
        return 0.25 / lobe.above *
               ggxDensity(std::sqrt(std::max(0.0, 0.5 * (1.0 + glm::dot(w, axis)))), lobe.alpha);
      };
      for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
          const dvec2 u((i + 0.5) / kSide, (j + 0.5) / kSide);
          const GgxDraw d = drawGgx(wo, alpha, u);
          exact += d.weight * (f0 + (1.0 - f0) * schlickRise(d.cos_h)) * wall(d.wi);
          const double s = std::sqrt(1.0 - u.x * u.x);
          const dvec3 w(s * std::cos(2.0 * kPi * u.y), s * std::sin(2.0 * kPi * u.y), u.x);
          base += 2.0 * kPi * wall(w) * round(shape.base, w);
          rise += 2.0 * kPi * wall(w) * round(shape.rise, w);
        }
      }
      const double whole = shape.reflectance(f0) * kSide * kSide;
      const double found = f0 * shape.scale * base + shape.bias * rise;
      EXPECT_NEAR(found / whole, exact / whole, 0.06) << alpha << ' ' << cosine;
      EXPECT_GT(std::abs(base / (kSide * kSide) - exact / whole), 0.1) << alpha << ' ' << cosine;
    }
  }
}

TEST(LobeShape, TableIsWithinTheErrorItStates) {
  Rng rng(11);
  double reflectance = 0.0, direction = 0.0, width = 0.0, above = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double cosine = 0.02 + 0.98 * rng.uniformDouble();
    const double roughness = 0.035 + 0.965 * rng.uniformDouble();
    const LobeShape exact = integrateLobe(cosine, roughness * roughness);
    const LobeShape table = lobeShape(cosine, roughness * roughness);
    reflectance = std::max(
        {reflectance, std::abs(table.scale - exact.scale), std::abs(table.bias - exact.bias)});
    for (const auto part : {&LobeShape::base, &LobeShape::rise}) {
      const RoundLobe& a = table.*part;
      const RoundLobe& b = exact.*part;
      // The rise weighs little near the normal, where it is a ring and no lobe.
      const double weighs = part == &LobeShape::rise ? exact.bias / exact.reflectance(0.04) : 1.0;
      direction = std::max(direction, weighs * std::abs(a.axis_sine - b.axis_sine));
      width = std::max(width, weighs * std::abs(a.alpha / b.alpha - 1.0));
      above = std::max(above, weighs * std::abs(a.above - b.above));
    }
  }
  EXPECT_LT(reflectance, 0.005);
  EXPECT_LT(direction, 0.02);
  EXPECT_LT(width, 0.06);
  EXPECT_LT(above, 0.05);
}

TEST(LobeShape, AxisLiesInThePlaneOfReflection) {
  const vec3 n(0.0F, 0.0F, 1.0F);
  const vec3 eye = glm::normalize(vec3(0.3F, -0.4F, 0.5F));
  const LobeShape shape = lobeShape(static_cast<double>(eye.z), 0.09);
  const vec3 mean = lobeAxis(shape.base, n, eye);
  EXPECT_NEAR(glm::length(mean), 1.0F, 1e-6F);
  EXPECT_NEAR(mean.x * eye.y - mean.y * eye.x, 0.0F, 1e-6F);
  EXPECT_LT(glm::dot(vec2(mean.x, mean.y), vec2(eye.x, eye.y)), 0.0F);
  EXPECT_EQ(lobeAxis(shape.base, n, n), n);
}

TEST(LobeShape, KernelTableIsTheKernel) {
  for (const double alpha : {0.02, 0.0625, 0.25, 0.6, 1.0}) {
    const sh::Kernel exact = sh::ggxReflectedKernel(alpha, 10);
    for (std::size_t l = 0; l < 10; ++l) {
      EXPECT_NEAR(static_cast<double>(lobeKernel(alpha)[l]), exact[l], 0.01) << alpha << ' ' << l;
    }
  }
}

}  // namespace
}  // namespace soffit::glossy
