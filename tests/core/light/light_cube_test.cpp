// SPDX-License-Identifier: MIT
#include "core/light/light_cube.h"

#include "core/light/polygon_irradiance.h"
#include "core/sh/convolution.h"
#include "core/sh/cube_map.h"
#include "core/sh/polygon_light.h"
#include "core/sh/sphere_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace soffit::light {
namespace {

constexpr int kSide = 64;
constexpr int kBands = 5;

/// A scene of rectangles, each by a corner and two edges.
struct Walls {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;

  Walls& add(const vec3& corner, const vec3& u, const vec3& v) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const vec3& p : {corner, corner + u, corner + u + v, corner + v}) positions.push_back(p);
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
    return *this;
  }
  [[nodiscard]] DepthCube depthFrom(const dvec3& probe, int side = kSide) const {
    return makeDepthCube(geometry::RayCaster(positions, triangles), probe, side);
  }
};

Emitter emitterOf(Shape shape, const dvec3& position, const dvec3& rotation = dvec3(0.0)) {
  Luminaire l;
  l.name = "lamp";
  l.shape = std::move(shape);
  l.position = position;
  l.rotation_deg = rotation;
  l.flux = 1000.0;
  auto emitter = makeEmitter(l);
  EXPECT_TRUE(emitter);
  return *emitter;
}

/// RMS of the difference over RMS of the expected.
double relative(const sh::Coefficients& c, const sh::Coefficients& expected) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    error += std::pow(c[i] - expected[i], 2);
    size += std::pow(expected[i], 2);
  }
  return std::sqrt(error / size);
}

double largest(const sh::Coefficients& c) {
  double m = 0.0;
  for (const double v : c) m = std::max(m, std::abs(v));
  return m;
}

sh::Coefficients polygon(const Emitter& e, const dvec3& p, int bands = kBands) {
  sh::Coefficients c = sh::polygonCoefficients(e.outline, p, bands);
  for (double& v : c) v *= e.luminance;
  return c;
}

sh::Coefficients greenAt(const LightCube& cube, const Emitter& e, const dvec3& p,
                         int bands = kBands) {
  return coefficientsAt(cube, std::span(&e, 1), p, bands)[1];
}

// The whole is exact; a border that is drawn half a line of sight beside its place (1/2 of 1/64 of
// the light's width) moves the middle of the light by 1/4 of that share: a fraction of a percent of
// what changes with direction.
constexpr double kCoverage = 4e-3;

TEST(LightCube, PanelMatchesItsClosedFormAtTheProbeAndBesideIt) {
  const Emitter panel = emitterOf(Rectangle{1.2, 0.6}, {0.3, -0.2, 2.0}, {10, 20, 30});
  const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&panel, 1});
  for (const dvec3& p : {dvec3(0), dvec3(0.5, 0.2, -0.1), dvec3(-0.4, 0.3, 0.3)}) {
    EXPECT_LT(relative(greenAt(cube, panel, p), polygon(panel, p)), kCoverage);
  }
  // By the cube map alone, light comes from the texels' centres: (4 / 64)^2 / 2 and the coverage.
  const sh::ProjectionTable table(sh::cubeSamples(kSide), kBands);
  const auto rgb = coefficientsAtProbe(cube, {&panel, 1}, table);
  for (const auto& channel : rgb)
    EXPECT_LT(relative(channel, polygon(panel, dvec3(0))), 2 * kCoverage);
}

TEST(LightCube, EveryTurnOfThePanelRoundTheProbeIsSeenOnAllFaces) {
  for (const dvec3& d : sh::randomSamples(30, 5).directions) {
    // Far enough round for edges and corners of the cube to be met.
    Emitter panel = emitterOf(Rectangle{1.0, 1.0}, 1.5 * d);
    const dvec3 side = glm::normalize(glm::cross(d, dvec3(0.3, 0.5, 0.81)));
    const dvec3 up = glm::cross(d, side);
    panel.outline = {1.5 * d + 0.5 * (side + up), 1.5 * d + 0.5 * (side - up),
                     1.5 * d - 0.5 * (side + up), 1.5 * d - 0.5 * (side - up)};
    panel.normal = -d;
    if (sh::polygonSolidAngle(panel.outline, dvec3(0)) < 0.0) {
      std::reverse(panel.outline.begin(), panel.outline.end());
    }
    const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&panel, 1});
    EXPECT_LT(relative(greenAt(cube, panel, dvec3(0)), polygon(panel, dvec3(0))), kCoverage);
  }
}

TEST(LightCube, LampSmallerThanATexelKeepsItsLight) {
  const Emitter spot = emitterOf(Rectangle{0.05, 0.05}, {3.0, 2.0, 4.0});
  const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&spot, 1});
  EXPECT_LT(relative(greenAt(cube, spot, dvec3(0)), polygon(spot, dvec3(0))), 2 * kCoverage);
}

TEST(LightCube, SphereMatchesItsCap) {
  const Emitter ball = emitterOf(Sphere{0.2}, {0.5, 1.0, 1.2});
  const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&ball, 1});
  sh::Coefficients expected = sh::sphereCoefficients(ball.position, 0.2, dvec3(0), kBands);
  for (double& v : expected) v *= ball.luminance;
  EXPECT_LT(relative(greenAt(cube, ball, dvec3(0)), expected), kCoverage);
}

TEST(LightCube, DiskAndTubeHaveTheIrradianceOfTheirClosedForms) {
  const dvec3 n(0, 0, 1);
  for (const Shape& shape : {Shape(Disk{0.4}), Shape(Tube{1.2, 0.05})}) {
    const Emitter e = emitterOf(shape, {0, 0, 1.5});
    const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&e, 1});
    double exact = 0.0;
    for (const LightTexel& t : cube.texels) {
      const dvec3 d = glm::normalize(t.point);
      exact += e.luminance * t.solid_angle * d.z;
    }
    const double expected =
        e.luminance *
        (e.kind == EmitterKind::tube
             ? tubeIrradiance(e.position, e.axis, e.half_length, e.radius, dvec3(0), n)
             : diskIrradiance(e.position, e.normal, e.radius, dvec3(0), n));
    // A tube's solid angle is not scaled: the lines of sight alone.
    EXPECT_NEAR(exact, expected, (e.kind == EmitterKind::tube ? 0.02 : kCoverage) * expected);
  }
}

TEST(LightCube, MeshIsTheSumOfItsFacingTriangles) {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {0, 0, -0.5F}};
  mesh->triangles = {{1, 0, 3}, {2, 1, 3}, {0, 2, 3}};  // a hanging pyramid, open above
  const Emitter lamp = emitterOf(MeshShape{"lamp.obj", 1.0, 'z', mesh}, {0.1, 0.2, 2.0});
  const LightCube cube = drawLights(Walls().depthFrom(dvec3(0)), {&lamp, 1});
  sh::Coefficients expected(25, 0.0);
  for (std::size_t t = 0; t < 3; ++t) {
    const auto part =
        sh::polygonCoefficients(std::span(lamp.corners).subspan(3 * t, 3), dvec3(0), kBands);
    for (std::size_t i = 0; i < 25; ++i) expected[i] += lamp.luminance * part[i];
  }
  ASSERT_GT(largest(expected), 0.0);
  EXPECT_LT(relative(greenAt(cube, lamp, dvec3(0)), expected), kCoverage);
}

TEST(LightCube, WallHidesWhatIsBehindIt) {
  const Emitter panel = emitterOf(Rectangle{1.2, 0.6}, {0, 0, 2.0});
  const Walls half = Walls().add({0, -5, 1}, {5, 0, 0}, {0, 10, 0});
  const LightCube cube = drawLights(half.depthFrom(dvec3(0)), {&panel, 1});
  Emitter left = panel;
  for (dvec3& v : left.outline) v.x = std::min(v.x, 0.0);
  // The edge runs along a border of texels: exact. Elsewhere half a texel of 3 cm is right or
  // wrong.
  EXPECT_LT(relative(greenAt(cube, panel, dvec3(0)), polygon(left, dvec3(0))), 2 * kCoverage);

  const Walls all = Walls().add({-5, -5, 1}, {10, 0, 0}, {0, 10, 0});
  EXPECT_TRUE(drawLights(all.depthFrom(dvec3(0)), {&panel, 1}).texels.empty());
  const Walls shifted = Walls().add({0.07F, -5, 1}, {5, 0, 0}, {0, 10, 0});
  for (std::size_t i = 0; i < 4; ++i) left.outline[i].x = std::min(panel.outline[i].x, 0.14);
  const LightCube cut = drawLights(shifted.depthFrom(dvec3(0)), {&panel, 1});
  EXPECT_LT(relative(greenAt(cut, panel, dvec3(0)), polygon(left, dvec3(0))), 0.5 * 0.0625 / 0.74);
}

TEST(LightCube, PanelLetIntoTheCeilingIsSeenAndItsBackIsDark) {
  const Emitter panel = emitterOf(Rectangle{1.2, 0.6}, {1.0, 0.5, 2.0});
  const Walls ceiling = Walls().add({-9, -9, 2}, {18, 0, 0}, {0, 18, 0});
  const LightCube below = drawLights(ceiling.depthFrom(dvec3(0)), {&panel, 1});
  EXPECT_LT(relative(greenAt(below, panel, dvec3(0)), polygon(panel, dvec3(0))), kCoverage);
  EXPECT_TRUE(drawLights(Walls().depthFrom(dvec3(0, 0, 3)), {&panel, 1}).texels.empty());
}

// Fujita & Kanai: a plane under an isotropic lamp follows cos / d^2 within 6 % of the peak in bands
// up to 4, although the light was drawn once, from one place.
TEST(LightCube, DistanceIsTakenAnewAtEachReceiver) {
  Luminaire l;
  l.shape = PointShape{};
  l.position = {0.2, 0.1, 1.0};
  l.flux = 4.0 * kPi * 100.0;
  l.distribution.kind = DistributionKind::isotropic;
  const Emitter lamp = *makeEmitter(l);
  const LightCube cube = drawLights(Walls().depthFrom(dvec3(0, 0, 0.1)), {&lamp, 1});
  ASSERT_EQ(cube.texels.size(), 1U);
  for (double x = -3.0; x <= 3.0; x += 0.25) {
    const dvec3 p(x, 0.4, 0.0);
    const dvec3 to = lamp.position - p;
    const double exact = 100.0 * to.z / std::pow(glm::length(to), 3);
    const double e = sh::irradiance(greenAt(cube, lamp, p), dvec3(0, 0, 1));
    EXPECT_NEAR(e, exact, 0.06 * 100.0) << x;
  }
}

TEST(LightCube, LightsAddUpWithGainAndColour) {
  std::vector<Emitter> all{emitterOf(Rectangle{0.6, 0.6}, {1, 0, 2}),
                           emitterOf(Sphere{0.1}, {-1, 1, 1.5}),
                           emitterOf(PointShape{}, {0.3, -1, 2})};
  const DepthCube depth = Walls().depthFrom(dvec3(0));
  const LightCube cube = drawLights(depth, all);
  // Dimmed and coloured after it was drawn.
  all[0].gain = 0.5;
  all[1].color = dvec3(1.5, 0.9, 0.2);
  all[2].gain = 0.0;
  const auto sum = coefficientsAt(cube, all, dvec3(0.1, 0, 0), kBands);
  for (std::size_t c = 0; c < 3; ++c) {
    sh::Coefficients expected(25, 0.0);
    for (std::size_t e = 0; e < 2; ++e) {
      const auto one =
          coefficientsAt(drawLights(depth, {&all[e], 1}), {&all[e], 1}, dvec3(0.1, 0, 0), kBands);
      for (std::size_t i = 0; i < 25; ++i) expected[i] += one[c][i];
    }
    EXPECT_LT(relative(sum[c], expected), 1e-12);
  }
}

TEST(LightCube, RadianceOfAFullySeenTexelIsTheLuminance) {
  const Emitter wide = emitterOf(Rectangle{20, 20}, {0, 0, 1.0});
  const LightCube cube =
      drawLights(Walls().depthFrom(dvec3(0), 16), {&wide, 1}, {.lines_of_sight = 40000});
  const auto planes = cube.radiance({&wide, 1});
  // Texels of the upper face lie within the panel whole, whose own scale is all but 1.
  for (std::size_t k = 0; k < 256; ++k) {
    EXPECT_NEAR(planes[0][4 * 256 + k], wide.luminance, 3e-3 * wide.luminance);
  }
}

TEST(DepthCube, IsTheDistanceAlongTheTexels) {
  const DepthCube cube =
      Walls().add({-50, -50, -2}, {100, 0, 0}, {0, 100, 0}).depthFrom({0, 0, 1}, 8);
  const auto samples = sh::cubeSamples(8);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const dvec3& d = samples.directions[k];
    if (d.z < -0.3) {
      EXPECT_NEAR(cube.distance[k], 3.0 / -d.z, 1e-5);
    } else if (d.z > 0.0) {
      EXPECT_TRUE(std::isinf(cube.distance[k]));
    }
  }
}

}  // namespace
}  // namespace soffit::light
