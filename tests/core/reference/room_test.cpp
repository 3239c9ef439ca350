// SPDX-License-Identifier: MIT
#include "rooms.h"

#include "core/math/sampling.h"
#include "core/reference/bsdf.h"

#include <gtest/gtest.h>

#include <cmath>

/// Light that is reflected: rooms with known answers.
namespace soffit::reference {
namespace {

using test::kSigmas;
using test::luminaire;
using test::matte;

/// Points spread evenly over the six inner faces of a box, looking inwards.
std::vector<scene::Sensor> spreadOverWalls(const dvec3& lo, const dvec3& hi, std::uint32_t count) {
  const dvec3 d = hi - lo;
  const double areas[3] = {d.y * d.z, d.z * d.x, d.x * d.y};
  const double total = 2.0 * (areas[0] + areas[1] + areas[2]);
  std::vector<scene::Sensor> sensors;
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = static_cast<std::uint32_t>(std::lround(count * areas[axis] / total));
    for (const bool far : {false, true}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        const dvec2 u = r2Sequence(i);
        scene::Sensor s{lo, dvec3(0)};
        s.position[(axis + 1) % 3] += u.x * d[(axis + 1) % 3];
        s.position[(axis + 2) % 3] += u.y * d[(axis + 2) % 3];
        if (far) s.position[axis] = hi[axis];
        s.normal[axis] = far ? -1.0 : 1.0;
        sensors.push_back(s);
      }
    }
  }
  return sensors;
}

TEST(Room, UniformClosedRoomHasMeanFluxOverSurfaceTimesAbsorption) {
  const dvec3 lo(0, 0, 0);
  const dvec3 hi(4, 4, 4);  // a cube: every face weighs the same
  for (const double rho : {0.0, 0.5, 0.9}) {
    const auto room = test::Builder().box(lo, hi, matte(rho)).scene();
    const ReferenceScene scene =
        test::prepare(room, {luminaire(light::Sphere{0.3}, {1.8, 2.1, 2.3})});
    const auto sensors = spreadOverWalls(lo, hi, 900);
    EstimateOptions options;
    options.relative_error = 1.0;
    options.min_replicates = 3;
    options.paths_per_replicate = 64;
    const Estimate e = estimate(scene, sensors, options);
    double mean = 0.0;
    double variance = 0.0;
    for (const SensorEstimate& s : e.sensors) {
      mean += s.total / double(sensors.size());
      variance += s.standard_error * s.standard_error / double(sensors.size() * sensors.size());
    }
    const double expected = 1000.0 / (96.0 * (1.0 - rho));
    // Statistical, plus the truncation of 150 low-discrepancy points per wall: 0.2 % of the direct
    // part, by the closed form summed over the same points.
    const double truncation = 0.003 * 1000.0 / 96.0;
    EXPECT_NEAR(mean, expected, kSigmas * std::sqrt(variance) + truncation) << rho;
    EXPECT_LT(std::sqrt(variance), 0.008 * expected) << rho;
  }
}

TEST(Room, BehindAShutDoorThereIsNothing) {
  const auto rooms = test::Builder()
                         .box({0, 0, 0}, {4, 3, 2.5}, matte(0.8))
                         .box({4, 0, 0}, {7, 3, 2.5}, matte(0.8))
                         .scene();
  const ReferenceScene scene =
      test::prepare(rooms, {luminaire(light::Rectangle{0.6, 0.6}, {3.6, 1.5, 2.4})});
  std::vector<scene::Sensor> sensors = spreadOverWalls({4, 0, 0}, {7, 3, 2.5}, 200);
  EstimateOptions options;
  options.min_replicates = 4;
  options.paths_per_replicate = 128;
  const Estimate e = estimate(scene, sensors, options);
  for (const SensorEstimate& s : e.sensors) {
    EXPECT_EQ(s.total, 0.0);
    EXPECT_EQ(s.standard_error, 0.0);
  }
}

scene::Material shiny(double specular, double roughness) {
  scene::Material m = matte(0.0);
  m.specular = specular;
  m.roughness = roughness;
  return m;
}

/// A sphere 1 m above a huge mirror, and a sensor 2 m above that looks down.
SensorEstimate overMirror(double roughness) {
  const auto mirror =
      test::Builder().quad({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, shiny(1.0, roughness)).scene();
  const ReferenceScene scene = test::prepare(mirror, {luminaire(light::Sphere{0.2}, {1, 0, 1})});
  EstimateOptions options;
  options.relative_error = 0.004;
  options.paths_per_replicate = 1024;
  return test::measure(scene, {dvec3(0, 0, 2), dvec3(0, 0, -1)}, options);
}

/// Illuminance of the same sphere at another place, wholly in front of the sensor.
double sphereAt(const dvec3& center) {
  const dvec3 to = center - dvec3(0, 0, 2);
  const double d = glm::length(to);
  return 1000.0 / (4 * kPi) / (d * d) * (-to.z / d);
}

TEST(Room, AMirrorShowsTheImageOfTheSource) {
  const SensorEstimate e = overMirror(0.0);
  EXPECT_NEAR(e.direct, sphereAt({1, 0, 1}), kSigmas * e.standard_error);
  EXPECT_NEAR(e.indirect, sphereAt({1, 0, -1}), kSigmas * e.standard_error);
  EXPECT_LT(e.standard_error, 0.005 * e.total);
}

TEST(Room, ASharpGlossyLobeApproachesTheMirrorWithoutFireflies) {
  const SensorEstimate e = overMirror(0.05);
  // Truncation: the lobe's half width of 0.0025 blurs the image by far less than its distance.
  EXPECT_NEAR(e.indirect, sphereAt({1, 0, -1}), kSigmas * e.standard_error + 1e-3 * e.indirect);
  EXPECT_LT(e.standard_error, 0.005 * e.total);
}

/// Reflected light of a glossy floor by brute force: points of the floor in polar rings under the
/// sensor, times the light of a point source there.
double glossyByQuadrature(const Bsdf& floor, const dvec3& source, double candela,
                          const dvec3& sensor) {
  constexpr int kRings = 1500;
  constexpr int kSteps = 360;
  double sum = 0.0;
  for (int i = 0; i < kRings; ++i) {
    const double cosine = (i + 0.5) / kRings;  // of the direction down to the floor
    const double r = sensor.z * std::sqrt(1.0 - cosine * cosine) / cosine;
    for (int j = 0; j < kSteps; ++j) {
      const double phi = 2 * kPi * (j + 0.5) / kSteps;
      const dvec3 p(sensor.x + r * std::cos(phi), sensor.y + r * std::sin(phi), 0.0);
      const dvec3 to = source - p;
      const double d2 = glm::dot(to, to);
      const dvec3 wi = to / std::sqrt(d2);
      const double illuminance = candela * wi.z / d2;
      sum += evaluate(floor, glm::normalize(sensor - p), wi).x * illuminance * cosine;
    }
  }
  return sum * 2 * kPi / (double(kRings) * kSteps);
}

TEST(Room, AGlossyFloorReflectsTheIntegralOfItsLobe) {
  scene::Material m = shiny(0.2, std::sqrt(0.3));
  m.diffuse = dvec3(0.4);
  const auto floor = test::Builder().quad({-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0}, m).scene();
  light::Luminaire point = luminaire(light::PointShape{}, {1.5, 0.5, 1.0}, 4 * kPi * 100.0);
  point.distribution.kind = light::DistributionKind::isotropic;
  EstimateOptions options;
  options.relative_error = 0.003;
  const dvec3 sensor(0, 0, 1);
  const SensorEstimate e =
      test::measure(test::prepare(floor, {point}), {sensor, dvec3(0, 0, -1)}, options);
  const Bsdf bsdf{.normal = dvec3(0, 0, 1), .diffuse = dvec3(0.4), .specular = 0.2, .alpha = 0.3};
  const double expected = glossyByQuadrature(bsdf, point.position, 100.0, sensor);
  // Quadrature: midpoint in 1500 x 360 smooth cells, 1e-5.
  EXPECT_NEAR(e.indirect, expected, kSigmas * e.standard_error + 1e-4 * expected);
}

TEST(Room, LuminairesSuperpose) {
  const auto room = test::Builder()
                        .box({0, 0, 0}, {5, 4, 3}, matte(0.6))
                        .box({1, 1, 0}, {2, 2, 1}, matte(0.4))
                        .scene();
  const light::Luminaire a = luminaire(light::Rectangle{0.6, 0.6}, {1, 1, 2.9}, 2000);
  light::Luminaire b = luminaire(light::Tube{1.2, 0.02}, {3.5, 2, 2.5}, 3000);
  b.colour.cct_k = 2700;
  const light::Luminaire c = luminaire(light::Sphere{0.1}, {4, 3, 1.0}, 500);
  EstimateOptions options;
  options.relative_error = 0.005;
  const scene::Sensor s{{2.5, 2.2, 0.8}, {0, 0, 1}};
  double sum = 0.0;
  double variance = 0.0;
  for (const light::Luminaire& l : {a, b, c}) {
    const SensorEstimate e = test::measure(test::prepare(room, {l}), s, options);
    sum += e.total;
    variance += e.standard_error * e.standard_error;
  }
  const SensorEstimate all = test::measure(test::prepare(room, {a, b, c}), s, options);
  EXPECT_NEAR(all.total, sum,
              kSigmas * std::sqrt(variance + all.standard_error * all.standard_error));
}

TEST(Room, ReflectionTakesTheColourOfTheSurface) {
  scene::Material red = matte(0.5);
  red.diffuse = dvec3(0.8, 0.0, 0.0);
  const auto floor = test::Builder().quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, red).scene();
  const ReferenceScene scene = test::prepare(floor, {luminaire(light::PointShape{}, {0.3, 0, 2})});
  const SensorEstimate e = test::measure(scene, {{0, 0, 1}, {0, 0, -1}}, {});
  EXPECT_GT(e.indirect_rgb.x, 1.0);
  EXPECT_EQ(e.indirect_rgb.y, 0.0);
  EXPECT_NEAR(e.indirect, light::kLuminance.x * e.indirect_rgb.x, 1e-12 * e.indirect);
}

TEST(Room, APanelFlushWithTheCeilingShinesAndOneBehindItDoesNot) {
  const auto room = test::Builder().box({0, 0, 0}, {4, 4, 3}, matte(0.0)).scene();
  const scene::Sensor s{{2, 2, 0}, {0, 0, 1}};
  EstimateOptions options;
  options.paths_per_replicate = 256;
  const auto at = [&](double z) {
    return test::measure(test::prepare(room, {luminaire(light::Rectangle{0.6, 0.6}, {2, 2, z})}), s,
                         options);
  };
  const SensorEstimate below = at(2.99);
  EXPECT_NEAR(at(3.0).total, below.total * (2.99 * 2.99) / 9.0, 1e-3 * below.total);
  EXPECT_EQ(at(3.01).total, 0.0);
}

}  // namespace
}  // namespace soffit::reference
