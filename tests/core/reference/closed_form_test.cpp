// SPDX-License-Identifier: MIT
#include "rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

/// Direct light of one emitter in free space against closed forms.
namespace soffit::reference {
namespace {

using test::kSigmas;
using test::luminaire;

const dvec3 kUp(0, 0, 1);

EstimateOptions options() {
  EstimateOptions o;
  o.relative_error = 0.004;
  o.paths_per_replicate = 256;
  return o;
}

void expectDirect(const light::Luminaire& l, const scene::Sensor& sensor, double expected) {
  const ReferenceScene scene = test::prepare(test::Builder().scene(), {l});
  const SensorEstimate e = test::measure(scene, sensor, options());
  EXPECT_LT(e.standard_error, 0.0041 * expected);
  // Statistical; the last term is round-off where the estimator has no variance.
  EXPECT_NEAR(e.total, expected, kSigmas * e.standard_error + 1e-9 * expected);
  EXPECT_EQ(e.indirect, 0.0);
}

/// Lambert's formula for a polygon wholly above the sensor's horizon.
double polygonIlluminance(const std::vector<dvec3>& corners, const scene::Sensor& s,
                          double luminance) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const dvec3 a = corners[i] - s.position;
    const dvec3 b = corners[(i + 1) % corners.size()] - s.position;
    const dvec3 c = glm::cross(a, b);
    const double angle = std::atan2(glm::length(c), glm::dot(a, b));
    sum += angle * glm::dot(s.normal, c) / glm::length(c);
  }
  return 0.5 * luminance * std::abs(sum);
}

/// Midpoint sum over a parametrised surface of area A: E = sum I(p, n, w) cos / d^2 dA.
double surfaceSum(double area, int n, const scene::Sensor& s,
                  const std::function<void(double, double, dvec3&, dvec3&)>& surface,
                  const std::function<double(const dvec3&, const dvec3&)>& per_area) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      dvec3 p(0.0);
      dvec3 normal(0.0);
      surface((i + 0.5) / n, (j + 0.5) / n, p, normal);
      const dvec3 to = p - s.position;
      const double d2 = glm::dot(to, to);
      const dvec3 w = to / std::sqrt(d2);
      sum += per_area(normal, -w) * std::max(0.0, glm::dot(w, s.normal)) / d2;
    }
  }
  return sum * area / (double(n) * n);
}

TEST(ClosedForm, PointsFollowTheInverseSquareExactly) {
  for (const double distance : {0.05, 1.0, 100.0}) {
    light::Luminaire l = luminaire(light::PointShape{}, {0, 0, distance});
    expectDirect(l, {dvec3(0), kUp}, 1000.0 / kPi / (distance * distance));
    l.distribution.kind = light::DistributionKind::isotropic;
    expectDirect(l, {dvec3(0), glm::normalize(dvec3(1, 0, 1))},
                 1000.0 / (4 * kPi) / (distance * distance) / std::sqrt(2.0));
  }
}

TEST(ClosedForm, ParallelRectangle) {
  // Howell C-11 (element below a corner): four of them make a centred panel.
  for (const double h : {0.05, 0.5, 3.0}) {
    const double x = 0.6 / h;
    const double y = 0.3 / h;
    const double factor = (x / std::hypot(1, x) * std::atan(y / std::hypot(1, x)) +
                           y / std::hypot(1, y) * std::atan(x / std::hypot(1, y))) /
                          (2 * kPi);
    const double luminance = 1000.0 / (kPi * 1.2 * 0.6);
    expectDirect(luminaire(light::Rectangle{1.2, 0.6}, {0, 0, h}), {dvec3(0), kUp},
                 4 * kPi * luminance * factor);
  }
}

TEST(ClosedForm, RectangleAtAnyAngle) {
  light::Luminaire l = luminaire(light::Rectangle{1.2, 0.6}, {0.5, 0.2, 0.9});
  l.rotation_deg = {20, -30, 50};
  const light::Emitter e = light::makeEmitter(l).value();
  const scene::Sensor s{dvec3(0.1, 0.1, 0.0), glm::normalize(dvec3(0.2, -0.1, 1.0))};
  expectDirect(l, s, polygonIlluminance(e.outline, s, e.luminance));
}

TEST(ClosedForm, PerpendicularRectangle) {
  // A panel that stands on the sensor's plane and looks along it (Howell, perpendicular element).
  light::Luminaire l = luminaire(light::Rectangle{0.8, 1.0}, {-0.5, 0.0, 0.4});
  l.rotation_deg = {0, -90, 0};  // local x along z, emits toward +x
  const double c = 0.5;          // distance, then height and half width
  const double a = 0.8;
  const double b = 0.5;
  const double r = std::hypot(a, c);
  const double factor = (std::atan(b / c) - c / r * std::atan(b / r)) / (2 * kPi);
  expectDirect(l, {dvec3(0), kUp}, 2 * kPi * (1000.0 / (kPi * 0.8)) * factor);
}

TEST(ClosedForm, DiskOnItsAxis) {
  for (const double d : {0.02, 0.3, 2.0}) {
    const double luminance = 1000.0 / (kPi * kPi * 0.09);
    expectDirect(luminaire(light::Disk{0.3}, {0, 0, d}), {dvec3(0), kUp},
                 kPi * luminance * 0.09 / (0.09 + d * d));
  }
}

TEST(ClosedForm, SphereAboveTheHorizon) {
  const double luminance = 1000.0 / (kPi * 4 * kPi * 0.01);
  for (const double d : {0.11, 0.5, 5.0}) {
    expectDirect(luminaire(light::Sphere{0.1}, {0, 0, d}), {dvec3(0), kUp},
                 kPi * luminance * 0.01 / (d * d));
  }
  expectDirect(luminaire(light::Sphere{0.1}, {3, 0, 4}), {dvec3(0), kUp},
               kPi * luminance * 0.01 / 25.0 * 0.8);
}

TEST(ClosedForm, Tube) {
  const light::Luminaire l = luminaire(light::Tube{1.2, 0.05}, {0.3, 0.2, 0.4});
  const light::Emitter e = light::makeEmitter(l).value();
  const scene::Sensor s{dvec3(0), glm::normalize(dvec3(0.1, 0.3, 1.0))};
  const auto surface = [](double u, double v, dvec3& p, dvec3& n) {
    n = dvec3(0, std::cos(2 * kPi * v), std::sin(2 * kPi * v));
    p = dvec3(0.3 + 1.2 * (u - 0.5), 0.2, 0.4) + 0.05 * n;
  };
  // Quadrature to 1e-6: the integrand has a bend where the surface turns away.
  expectDirect(l, s, surfaceSum(e.area, 1500, s, surface, [&](const dvec3& n, const dvec3& w) {
                 return e.luminance * std::max(0.0, glm::dot(n, w));
               }));
}

TEST(ClosedForm, NonConvexPolygonIsTheSumOfItsParts) {
  const light::Luminaire l =
      luminaire(light::Polygon{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}, {0, 0, 1});
  const scene::Sensor s{dvec3(0.5, 0.3, 0), kUp};
  const double luminance = 1000.0 / (kPi * 3);
  const double expected =
      polygonIlluminance({{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}}, s, luminance) +
      polygonIlluminance({{0, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}}, s, luminance);
  expectDirect(l, s, expected);
}

TEST(ClosedForm, MeshShinesOnTheSideOfItsWinding) {
  // A sheet whose front looks down, and one that looks up, which sends nothing.
  const auto mesh = test::Builder()
                        .quad({-0.5, -0.5, 0}, {0, 1, 0}, {1, 0, 0}, test::matte(0))
                        .quad({0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}, test::matte(0))
                        .scene()
                        .mesh;
  const light::Luminaire l = luminaire(light::MeshShape{"m.obj", 1.0, 'z', mesh}, {0, 0, 0.7});
  const scene::Sensor s{dvec3(0.1, 0.1, 0), kUp};
  const double expected =
      polygonIlluminance({{-0.5, -0.5, 0.7}, {0.5, -0.5, 0.7}, {0.5, 0.5, 0.7}, {-0.5, 0.5, 0.7}},
                         s, 1000.0 / (kPi * 2));
  expectDirect(l, s, expected);
}

/// Cosine to the fourth downwards, something upwards.
std::shared_ptr<const photometry::IntensityDistribution> table() {
  auto t = std::make_shared<photometry::IntensityDistribution>();
  t->c_deg = {0.0};
  for (int gamma = 0; gamma <= 180; gamma += 5) {
    t->gamma_deg.push_back(gamma);
    t->candela.push_back(gamma <= 90 ? 300.0 * std::pow(std::cos(radians(gamma)), 4) : 20.0);
  }
  return t;
}

TEST(ClosedForm, MeasuredLightOnARectangleShinesFromBothSides) {
  light::Luminaire l = luminaire(light::Rectangle{1.2, 0.6}, {0, 0, 0});
  l.distribution = {light::DistributionKind::ies, "t.ies", table()};
  l.flux.reset();
  const light::Emitter e = light::makeEmitter(l).value();
  const auto surface = [](double u, double v, dvec3& p, dvec3& n) {
    p = dvec3(1.2 * (u - 0.5), 0.6 * (v - 0.5), 0.0);
    n = dvec3(0, 0, -1);
  };
  const auto per_area = [&](const dvec3&, const dvec3& w) { return e.pointIntensity(w) / e.area; };
  for (const double z : {-0.5, 0.8}) {
    const scene::Sensor s{dvec3(0.2, 0.1, z), dvec3(0, 0, z < 0 ? 1 : -1)};
    expectDirect(l, s, surfaceSum(e.area, 600, s, surface, per_area));
  }
}

TEST(ClosedForm, MeasuredLightOnASphereComesFromItsFarSideToo) {
  light::Luminaire l = luminaire(light::Sphere{0.2}, {0, 0, 0});
  l.distribution = {light::DistributionKind::ies, "t.ies", table()};
  const light::Emitter e = light::makeEmitter(l).value();
  const auto surface = [](double u, double v, dvec3& p, dvec3& n) {
    const double z = 1 - 2 * u;
    const double r = std::sqrt(1 - z * z);
    n = dvec3(r * std::cos(2 * kPi * v), r * std::sin(2 * kPi * v), z);
    p = 0.2 * n;
  };
  const scene::Sensor s{dvec3(0.1, 0.3, -0.6), glm::normalize(dvec3(0, -0.4, 1))};
  const double expected = surfaceSum(e.area, 800, s, surface, [&](const dvec3&, const dvec3& w) {
    return e.pointIntensity(w) / e.area;
  });
  expectDirect(l, s, expected);
  l.casts_shadow = true;  // a body does not hide its own light
  expectDirect(l, s, expected);
}

TEST(ClosedForm, MeasuredShapesHaveTheirFarField) {
  light::Luminaire l = luminaire(light::Disk{0.1}, {0, 0, 50});
  l.distribution = {light::DistributionKind::ies, "t.ies", table()};
  l.flux.reset();
  const ReferenceScene scene = test::prepare(test::Builder().scene(), {l});
  const double expected = 300.0 / 2500.0;
  // Truncation: over the disk's 0.11 degrees the table falls by 0.3 per cent in 5 degrees.
  EXPECT_NEAR(test::measure(scene, {dvec3(0), kUp}, options()).total, expected, 4e-4 * expected);
}

TEST(ClosedForm, DimmingSwitchAndColourScaleTheLight) {
  light::Luminaire l = luminaire(light::PointShape{}, {0, 0, 1});
  l.dimming = 0.25;
  l.colour.rgb = dvec3(1, 0, 0);
  const ReferenceScene scene = test::prepare(test::Builder().scene(), {l});
  const SensorEstimate e = test::measure(scene, {dvec3(0), kUp}, options());
  EXPECT_NEAR(e.total, 250.0 / kPi, 1e-9);
  EXPECT_NEAR(e.direct_rgb.x, 250.0 / kPi / light::kLuminance.x, 1e-9);
  EXPECT_EQ(e.direct_rgb.y, 0.0);
  l.on = false;
  EXPECT_EQ(
      test::measure(test::prepare(test::Builder().scene(), {l}), {dvec3(0), kUp}, options()).total,
      0.0);
}

}  // namespace
}  // namespace soffit::reference
