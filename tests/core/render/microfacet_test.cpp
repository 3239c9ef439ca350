// SPDX-License-Identifier: MIT
#include "core/render/microfacet.h"

#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

vec3 direction(double theta, double phi = 0.0) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// Midpoint rule over the hemisphere, fine enough for lobes of alpha >= 0.1.
template <class F>
double overHemisphere(const F& f) {
  constexpr int kRows = 400;
  constexpr int kColumns = 400;
  double sum = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const double theta = 0.5 * kPi * (i + 0.5) / kRows;
    for (int j = 0; j < kColumns; ++j) {
      sum += static_cast<double>(f(direction(theta, 2 * kPi * (j + 0.5) / kColumns))) *
             std::sin(theta);
    }
  }
  return sum * 0.5 * kPi / kRows * 2 * kPi / kColumns;
}

TEST(Schlick, EndsAtF0AndAtOne) {
  EXPECT_FLOAT_EQ(schlick(0.04F, 1.0F), 0.04F);
  EXPECT_FLOAT_EQ(schlick(0.04F, 0.0F), 1.0F);
}

TEST(GgxDensity, ProjectsToUnitArea) {
  for (const float alpha : {0.1F, 0.25F, 0.5F, 1.0F}) {
    const double area = overHemisphere([&](const vec3& h) { return ggxDensity(h.z, alpha) * h.z; });
    EXPECT_NEAR(area, 1.0, 1e-3) << alpha;  // truncation of the midpoint rule
  }
}

TEST(GgxReflection, IsReciprocal) {
  for (const float alpha : {0.05F, 0.3F, 0.9F}) {
    const vec3 a = direction(0.3, 0.2);
    const vec3 b = direction(1.2, 2.0);
    // f(a, b) = f(b, a); the function holds the cosine of its second direction.
    EXPECT_NEAR(ggxReflection(a, b, 0.04F, alpha) / b.z, ggxReflection(b, a, 0.04F, alpha) / a.z,
                1e-5F * ggxReflection(a, b, 0.04F, alpha) / b.z);
  }
}

TEST(GgxPdf, IntegratesToTheShareOfRaysThatLeaveTheSurface) {
  for (const double theta : {0.1, 0.8, 1.3}) {
    for (const float alpha : {0.15F, 0.4F}) {
      const vec3 wo = direction(theta);
      const double integral = overHemisphere([&](const vec3& wi) { return ggxPdf(wo, wi, alpha); });
      int above = 0;
      constexpr int kSamples = 20000;
      for (std::uint32_t i = 0; i < kSamples; ++i) {
        if (sampleGgx(wo, 0.04F, alpha, vec2(r2Sequence(i))).wi.z > 0.0F) ++above;
      }
      // Truncation of both: the midpoint rule and a low-discrepancy count.
      EXPECT_NEAR(integral, static_cast<double>(above) / kSamples, 3e-3) << theta << " " << alpha;
    }
  }
}

TEST(SampleGgx, CarriesTheEnergyOfTheLobe) {
  for (const double theta : {0.0, 0.9, 1.4}) {
    for (const float alpha : {0.1F, 0.35F, 1.0F}) {
      const vec3 wo = direction(theta);
      const double exact =
          overHemisphere([&](const vec3& wi) { return ggxReflection(wo, wi, 0.3F, alpha); });
      double mean = 0.0;
      constexpr std::uint32_t kSamples = 20000;
      for (std::uint32_t i = 0; i < kSamples; ++i) {
        const LobeSample s = sampleGgx(wo, 0.3F, alpha, vec2(r2Sequence(i)));
        EXPECT_LE(s.weight, 1.0F + 1e-5F);
        if (s.weight > 0.0F) {
          // The weight is the reflection over its own density.
          EXPECT_NEAR(s.weight * s.pdf, ggxReflection(wo, s.wi, 0.3F, alpha),
                      2e-3F * s.weight * s.pdf);
        }
        mean += static_cast<double>(s.weight) / kSamples;
      }
      EXPECT_NEAR(mean, exact, 4e-3) << theta << " " << alpha;  // truncation of both
    }
  }
}

TEST(SampleGgx, FullyReflectingSmoothLobesLoseNothing) {
  double mean = 0.0;
  for (std::uint32_t i = 0; i < 1000; ++i)
    mean +=
        static_cast<double>(sampleGgx(direction(0.5), 1.0F, 0.05F, vec2(r2Sequence(i))).weight) /
        1000;
  EXPECT_NEAR(mean, 1.0, 5e-3);  // single scattering loses about 2 alpha^2
}

TEST(SampleGgx, ZeroRoughnessIsAMirror) {
  const vec3 wo = direction(0.7, 1.0);
  const LobeSample s = sampleGgx(wo, 0.04F, 0.0F, {0.3F, 0.9F});
  EXPECT_EQ(s.wi, vec3(-wo.x, -wo.y, wo.z));
  EXPECT_FLOAT_EQ(s.weight, schlick(0.04F, wo.z));
  EXPECT_EQ(s.pdf, 0.0F);
  EXPECT_EQ(ggxReflection(wo, s.wi, 0.04F, 0.0F), 0.0F);
}

}  // namespace
}  // namespace soffit::render
