// SPDX-License-Identifier: MIT
#include "core/geometry/ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/math/rng.h"
#include "core/math/sampling.h"

namespace soffit::geometry {
namespace {

struct Soup {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
};

// A closed sphere of latitude-longitude triangles, turned so that nothing is axis-parallel.
Soup turnedSphere(float radius, int bands) {
  const dmat3 turn = rotationXyz({31.0, -17.0, 73.0});
  const auto columns = static_cast<std::uint32_t>(2 * bands);
  Soup soup;
  for (int i = 0; i <= bands; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const double theta = kPi * i / bands;
      const double phi = 2.0 * kPi * j / columns;
      const dvec3 p(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                    std::cos(theta));
      soup.positions.push_back(vec3(turn * p) * radius);
    }
  }
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(bands); ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) {
      const std::uint32_t next = (j + 1) % columns;
      const std::uint32_t a = i * columns + j;
      const std::uint32_t b = a + columns;
      const std::uint32_t c = b - j + next;
      const std::uint32_t d = a - j + next;
      if (i + 1 < static_cast<std::uint32_t>(bands)) soup.triangles.emplace_back(a, b, c);
      if (i > 0) soup.triangles.emplace_back(a, c, d);
    }
  }
  // The columns of either pole are one point, so the caps close.
  for (std::uint32_t j = 0; j < columns; ++j) {
    soup.positions[j] = soup.positions[0];
    soup.positions[soup.positions.size() - 1 - j] = soup.positions.back();
  }
  return soup;
}

Soup oneTriangle(float scale) {
  return {{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}}, {{0, 1, 2}}};
}

vec3 pointAt(const Soup& soup, const Hit& hit) {
  const uvec3 t = soup.triangles[hit.triangle];
  const vec3 a = soup.positions[t.x];
  return a + hit.u * (soup.positions[t.y] - a) + hit.v * (soup.positions[t.z] - a);
}

vec3 normalOf(const Soup& soup, std::uint32_t triangle) {
  const uvec3 t = soup.triangles[triangle];
  return glm::normalize(glm::cross(soup.positions[t.y] - soup.positions[t.x],
                                   soup.positions[t.z] - soup.positions[t.x]));
}

class AtScale : public ::testing::TestWithParam<float> {};

TEST_P(AtScale, ClosedSphereLetsNoRayOut) {
  const float radius = GetParam();
  const Soup soup = turnedSphere(radius, 24);
  const RayCaster caster(soup.positions, soup.triangles);
  Rng rng(1);
  for (int i = 0; i < 20000; ++i) {
    const vec3 origin = 0.5F * radius * uniformSphere(rng.uniform(), rng.uniform());
    vec3 direction = uniformSphere(rng.uniform(), rng.uniform());
    if (i % 2 == 0) {  // half of them at an edge, where a ray could slip between two triangles
      const uvec3 t = soup.triangles[rng.below(static_cast<unsigned>(soup.triangles.size()))];
      const float f = rng.uniform();
      direction = glm::mix(soup.positions[t.x], soup.positions[t.y], f) - origin;
    }
    const Ray ray{.origin = origin, .direction = direction};
    const Hit hit = caster.closest(ray);
    ASSERT_TRUE(hit.valid()) << i;
    ASSERT_TRUE(caster.occluded(ray));
    // Round-off: the two ways to the point differ by some tens of roundings of the radius.
    const vec3 along = origin + hit.t * direction;
    ASSERT_LT(glm::length(along - pointAt(soup, hit)), radius * 64 * 0x1p-24F) << i;
  }
}

TEST_P(AtScale, OffsetOriginsDoNotSeeTheirOwnTriangle) {
  const float radius = GetParam();
  const Soup soup = turnedSphere(radius, 12);
  const RayCaster caster(soup.positions, soup.triangles);
  Rng rng(2);
  for (int i = 0; i < 20000; ++i) {
    const Hit seed{.triangle = rng.below(static_cast<unsigned>(soup.triangles.size())),
                   .u = 0.5F * rng.uniform(),
                   .v = 0.5F * rng.uniform()};
    const vec3 n = normalOf(soup, seed.triangle);
    const vec3 p = pointAt(soup, seed);
    vec3 t;
    vec3 b;
    orthonormalBasis(n, t, b);
    const vec3 w = cosineHemisphere(rng.uniform(), rng.uniform());
    const vec3 direction = w.x * t + w.y * b + w.z * n;
    // The sphere is convex: from its outside nothing is in the way, inside always something else.
    ASSERT_FALSE(caster.occluded({.origin = offsetOrigin(p, n), .direction = direction}));
    const Hit hit = caster.closest({.origin = offsetOrigin(p, -n), .direction = -direction});
    ASSERT_TRUE(hit.valid());
    ASSERT_NE(hit.triangle, seed.triangle);
  }
}

TEST_P(AtScale, DistanceAndBarycentricsAreThePoint) {
  const float s = GetParam();
  const Soup soup = oneTriangle(s);
  const RayCaster caster(soup.positions, soup.triangles);
  const Hit hit = caster.closest({.origin = {0.25F * s, 0.5F * s, 2 * s}, .direction = {0, 0, -2}});
  ASSERT_EQ(hit.triangle, 0U);
  constexpr float kRoundoff = 16 * 0x1p-24F;
  EXPECT_NEAR(hit.t / s, 1.0F, kRoundoff);  // two units of length per unit of t
  EXPECT_NEAR(hit.u, 0.25F, kRoundoff);
  EXPECT_NEAR(hit.v, 0.5F, kRoundoff);
}

INSTANTIATE_TEST_SUITE_P(MillimetreToMegametre, AtScale,
                         ::testing::Values(1e-3F, 1.0F, 50.0F, 1e3F, 1e6F));

TEST(RayCaster, BothSidesAreHit) {
  const Soup soup = oneTriangle(1.0F);
  const RayCaster caster(soup.positions, soup.triangles);
  EXPECT_TRUE(caster.closest({.origin = {0.2F, 0.2F, 1}, .direction = {0, 0, -1}}).valid());
  EXPECT_TRUE(caster.closest({.origin = {0.2F, 0.2F, -1}, .direction = {0, 0, 1}}).valid());
}

TEST(RayCaster, IntervalIsRespected) {
  const Soup soup = oneTriangle(1.0F);
  const RayCaster caster(soup.positions, soup.triangles);
  Ray ray{.origin = {0.2F, 0.2F, 1}, .direction = {0, 0, -1}};
  const auto seen = [&] {
    EXPECT_EQ(caster.closest(ray).valid(), caster.occluded(ray));
    return caster.occluded(ray);
  };
  ray.t_max = 0.999F;
  EXPECT_FALSE(seen());
  ray.t_max = 1.001F;
  EXPECT_TRUE(seen());
  ray.t_min = 1.0005F;
  EXPECT_FALSE(seen());
  ray.t_min = 0.9995F;
  EXPECT_TRUE(seen());
  ray.t_min = 2.0F;  // empty interval
  EXPECT_FALSE(seen());
}

TEST(RayCaster, RaysThatAreNoNumbersMeetNothing) {
  const Soup soup = oneTriangle(1.0F);
  const RayCaster caster(soup.positions, soup.triangles);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Ray> rays{{.origin = {nan, 0, 1}, .direction = {0, 0, -1}},
                              {.origin = {0.2F, 0.2F, 1}, .direction = {0, nan, -1}},
                              {.origin = {0.2F, 0.2F, 1}, .direction = {0, 0, -1}, .t_max = nan}};
  std::vector<Hit> hits(rays.size());
  std::vector<std::uint8_t> blocked(rays.size(), 7);
  caster.closest(rays, hits);
  caster.occluded(rays, blocked);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_FALSE(caster.closest(rays[i]).valid());
    EXPECT_FALSE(caster.occluded(rays[i]));
    EXPECT_FALSE(hits[i].valid());
    EXPECT_EQ(blocked[i], 0);
  }
}

TEST(RayCaster, WithoutTrianglesNothingIsHit) {
  const RayCaster caster({}, {});
  const std::array<Ray, 3> rays{};
  std::array<Hit, 3> hits{{{.triangle = 1}, {.triangle = 1}, {.triangle = 1}}};
  std::array<std::uint8_t, 3> blocked{1, 1, 1};
  caster.closest(rays, hits);
  caster.occluded(rays, blocked);
  EXPECT_FALSE(caster.closest(rays[0]).valid());
  EXPECT_FALSE(caster.occluded(rays[0]));
  for (const Hit& hit : hits) EXPECT_FALSE(hit.valid());
  for (const std::uint8_t b : blocked) EXPECT_EQ(b, 0);
}

TEST(RayCaster, BatchEqualsSingleRays) {
  const Soup soup = turnedSphere(3.0F, 16);
  const RayCaster caster(soup.positions, soup.triangles);
  Rng rng(3);
  for (const std::size_t count : {0U, 1U, 15U, 16U, 17U, 1000U}) {
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {  // from outside: some hit, some miss
      ray.origin = 6.0F * uniformSphere(rng.uniform(), rng.uniform());
      ray.direction = uniformSphere(rng.uniform(), rng.uniform()) - 0.2F * ray.origin;
      ray.t_max = 12.0F * rng.uniform();
    }
    std::vector<Hit> hits(count);
    std::vector<std::uint8_t> blocked(count);
    caster.closest(rays, hits);
    caster.occluded(rays, blocked);
    for (std::size_t i = 0; i < count; ++i) {
      const Hit single = caster.closest(rays[i]);
      ASSERT_EQ(hits[i].triangle, single.triangle);
      ASSERT_EQ(blocked[i] != 0, single.valid());
      ASSERT_EQ(caster.occluded(rays[i]), single.valid());
      if (!single.valid()) continue;
      // Round-off: the packet kernel orders its operations differently.
      ASSERT_NEAR(hits[i].t, single.t, single.t * 64 * 0x1p-24F);
      ASSERT_NEAR(hits[i].u, single.u, 1024 * 0x1p-24F);
      ASSERT_NEAR(hits[i].v, single.v, 1024 * 0x1p-24F);
    }
  }
}

TEST(RayCaster, CoherentRaysMeetTheSame) {
  const Soup soup = turnedSphere(1.0F, 40);
  const RayCaster caster(soup.positions, soup.triangles);
  std::vector<Ray> rays;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 50; ++x) {
      const vec3 aim(0.05F * static_cast<float>(x) - 1.2F, 0.05F * static_cast<float>(y) - 1.2F,
                     -2.0F);
      rays.push_back({.origin = {0.01F, 0.02F, 2.0F}, .direction = glm::normalize(aim)});
    }
  }
  std::vector<Hit> plain(rays.size());
  std::vector<Hit> coherent(rays.size());
  caster.closest(rays, plain);
  caster.closest(rays, coherent, true);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    // On an edge either neighbour may be named; the distance is the same to rounding.
    ASSERT_EQ(plain[i].valid(), coherent[i].valid());
    if (plain[i].valid()) {
      ASSERT_NEAR(plain[i].t, coherent[i].t, 1e-5F);
    }
  }
}

TEST(RayCaster, OutlivesAMove) {
  const Soup soup = oneTriangle(1.0F);
  RayCaster first(soup.positions, soup.triangles);
  RayCaster second(std::move(first));
  RayCaster third({}, {});
  third = std::move(second);
  EXPECT_TRUE(third.occluded({.origin = {0.2F, 0.2F, 1}, .direction = {0, 0, -1}}));
}

TEST(OffsetOrigin, StepsToTheSideOfTheNormalAlongIt) {
  const vec3 n = glm::normalize(vec3(1, -2, 3));
  for (const float scale : {0.0F, 1e-3F, 1.0F, 1e6F}) {
    const vec3 p = scale * vec3(0.3F, -0.7F, 0.5F);
    const vec3 step = offsetOrigin(p, n) - p;
    EXPECT_GT(glm::dot(step, n), 0.0F);
    // Round-off of the sum: half an ulp of p in each component, an ulp is 2^-23.
    EXPECT_LT(glm::length(glm::cross(step, n)), scale * 0x1p-22F + 1e-11F);
    EXPECT_LT(glm::length(step), std::max(1e-5F, scale * 2e-5F));
  }
}

}  // namespace
}  // namespace soffit::geometry
