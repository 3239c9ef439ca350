// SPDX-License-Identifier: MIT
#include "core/reference/light_sampling.h"

#include "rooms.h"

#include "core/math/sampling.h"
#include "core/reference/light_choice.h"
#include "core/reference/spherical_rectangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::reference {
namespace {

const dvec3 kPlaces[] = {{0.1, 0.2, -0.3}, {0.4, -0.1, -0.02}, {1.0, 2.0, -3.0}, {-2.0, 0.1, -0.5}};

std::vector<light::Emitter> shapes() {
  std::vector<light::Emitter> out;
  const auto mesh =
      test::Builder().box({-0.21, -0.21, 0.0}, {0.21, 0.21, 0.1}, test::matte(0)).scene().mesh;
  for (const light::Shape& shape :
       {light::Shape(light::Rectangle{1.0, 0.5}), light::Shape(light::Disk{0.4}),
        light::Shape(light::Sphere{0.015}), light::Shape(light::Tube{1.0, 0.01}),
        light::Shape(light::Polygon{{{0, 0}, {0.5, 0}, {0.1, 0.1}, {0, 0.5}}}),
        light::Shape(light::MeshShape{"m.obj", 1.0, 'z', mesh})}) {
    out.push_back(light::makeEmitter(test::luminaire(shape, dvec3(0.0))).value());
  }
  return out;
}

TEST(SampleLight, LiesOnTheSurfaceWithTheDensityThatIsAskedForThere) {
  for (const light::Emitter& e : shapes()) {
    const LightShape light(e);
    for (const dvec3& y : kPlaces) {
      for (std::uint32_t i = 0; i < 64; ++i) {
        const LightPoint s = sampleLight(light, y, r2Sequence(i));
        ASSERT_GT(s.density, 0.0);
        EXPECT_NEAR(lightDensity(light, y, s.point, s.normal) / s.density, 1.0, 1e-6);
        const double distance = glm::length(s.point - y);
        std::vector<Crossing> crossings;
        light.cross({y, (s.point - y) / distance}, kInfinity, crossings);
        double nearest = 1.0;
        for (const Crossing& c : crossings) nearest = std::min(nearest, std::abs(c.t - distance));
        // Round-off; sphere and tube at grazing angles lose half the digits, meshes are floats.
        EXPECT_LT(nearest, 2e-5) << int(e.kind) << ' ' << i;
      }
    }
  }
}

/// The mean of cos / (d^2 density) over the samples is the solid angle of what shines toward y.
double solidAngleBySampling(const LightShape& light, const dvec3& y, std::uint32_t count) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const LightPoint s = sampleLight(light, y, r2Sequence(i));
    if (!(s.density > 0.0)) continue;
    const dvec3 to = s.point - y;
    const double d2 = glm::dot(to, to);
    sum += std::max(0.0, -glm::dot(s.normal, to)) / (d2 * std::sqrt(d2) * s.density);
  }
  return sum / count;
}

/// Van Oosterom & Strackee 1983.
double triangleSolidAngle(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double la = glm::length(a);
  const double lb = glm::length(b);
  const double lc = glm::length(c);
  const double numerator = std::abs(glm::dot(a, glm::cross(b, c)));
  return 2.0 * std::atan2(numerator, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la +
                                         glm::dot(c, a) * lb);
}

TEST(SampleLight, GivesSolidAnglesInClosedForm) {
  const auto emitters = shapes();
  for (const dvec3& y : kPlaces) {
    const auto& p = emitters[0].outline;
    const double rectangle = triangleSolidAngle(p[0] - y, p[1] - y, p[2] - y) +
                             triangleSolidAngle(p[0] - y, p[2] - y, p[3] - y);
    // Truncation of a low-discrepancy sum, worst where sampling is by area.
    EXPECT_NEAR(solidAngleBySampling(LightShape(emitters[0]), y, 1U << 16U) / rectangle, 1.0, 2e-3);
    const double sine = 0.015 / glm::length(y);
    const double sphere = 2.0 * kPi * (1.0 - std::sqrt(1.0 - sine * sine));
    // The cone is sampled by solid angle: every term is the same.
    EXPECT_NEAR(solidAngleBySampling(LightShape(emitters[2]), y, 16) / sphere, 1.0, 1e-6);
  }
}

TEST(SampleLight, FindsNothingBehindOneSidedLights) {
  const auto emitters = shapes();
  for (const std::size_t planar : {0U, 1U, 4U}) {
    EXPECT_EQ(sampleLight(LightShape(emitters[planar]), {0.1, 0.1, 1.0}, {0.5, 0.5}).density, 0.0);
  }
}

TEST(SphericalRectangle, HasItsSolidAngleAndUniformSamples) {
  const dvec3 corner(-0.5, -0.3, 0.0);
  const dvec3 ex(1.0, 0.0, 0.0);
  const dvec3 ey(0.0, 0.6, 0.0);
  for (const dvec3& y : {dvec3(0, 0, -0.01), dvec3(0.2, 0.1, 0.5), dvec3(2, -1, -0.3)}) {
    const SphericalRectangle r(corner, ex, ey, y);
    const double expected = triangleSolidAngle(corner - y, corner + ex - y, corner + ex + ey - y) +
                            triangleSolidAngle(corner - y, corner + ex + ey - y, corner + ey - y);
    EXPECT_NEAR(r.solidAngle(), expected, 1e-12);  // round-off of the angles' cancelling sum
    // A quarter of the samples must see the quarter of the rectangle by its own solid angle.
    const double quarter =
        triangleSolidAngle(corner - y, corner + 0.5 * ex - y, corner + 0.5 * (ex + ey) - y) +
        triangleSolidAngle(corner - y, corner + 0.5 * (ex + ey) - y, corner + 0.5 * ey - y);
    int inside = 0;
    constexpr int kCount = 1 << 14;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const dvec3 p = r.sample(r2Sequence(i));
      EXPECT_NEAR(p.z, 0.0, 1e-12);
      if (p.x < 0.0 && p.y < 0.0) ++inside;
    }
    EXPECT_NEAR(double(inside) / kCount, quarter / expected,
                2e-3);  // truncation, N^-1/2 at an edge
  }
}

TEST(LightChoice, PicksInProportionAndNeverWhatCannotLight) {
  std::vector<light::Emitter> emitters;
  for (const double x : {0.0, 1.0, 2.0, 3.0}) {
    light::Luminaire l = test::luminaire(light::Rectangle{0.1, 0.1}, {x, 0, 1});
    l.on = x != 1.0;
    if (x == 3.0) l.rotation_deg = {180, 0, 0};  // shines upwards
    emitters.push_back(light::makeEmitter(l).value());
  }
  std::vector<LightShape> lights(emitters.begin(), emitters.end());
  LightChoice choice;
  choice.prepare(lights, {0, 0, 0}, {0, 0, 1});
  EXPECT_GT(choice.probability(0), choice.probability(2));
  EXPECT_GT(choice.probability(2), 0.0);
  EXPECT_EQ(choice.probability(1), 0.0);
  EXPECT_EQ(choice.probability(3), 0.0);
  EXPECT_NEAR(choice.probability(0) + choice.probability(2), 1.0, 1e-15);
  EXPECT_EQ(choice.pick(0.0).light, 0U);
  EXPECT_EQ(choice.pick(0.5 * choice.probability(0)).light, 0U);
  EXPECT_EQ(choice.pick(std::nextafter(1.0, 0.0)).light, 2U);
  choice.prepare(lights, {0, 0, 0}, {0, 0, -1});
  EXPECT_EQ(choice.pick(0.5).probability, 0.0);  // all are below the horizon
}

}  // namespace
}  // namespace soffit::reference
