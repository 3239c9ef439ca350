// SPDX-License-Identifier: MIT
#include "core/reference/beams.h"

#include "core/light/polygon_irradiance.h"
#include "rooms.h"

#include <gtest/gtest.h>

#include <cmath>

/// Lines of sight with known radiance.
namespace soffit::reference {
namespace {

using test::luminaire;
using test::matte;

scene::Scene floorOf(const scene::Material& material) {
  return test::Builder().quad({-500, -500, 0}, {1000, 0, 0}, {0, 1000, 0}, material).scene();
}

Beam downAt(const dvec3& point, const dvec3& from) {
  return {from, glm::normalize(point - from)};
}

TEST(Beams, MatteFloorUnderAPanelShowsItsIlluminance) {
  const light::Luminaire panel = luminaire(light::Rectangle{1.0, 1.0}, {0, 0, 2}, 1000.0);
  const ReferenceScene scene = test::prepare(floorOf(matte(0.5)), {panel});
  const std::vector<Beam> beams{downAt({0, 0, 0}, {3, 1, 1}), downAt({1, 0.5, 0}, {3, 1, 1})};
  const auto seen = traceBeams(scene, beams, {.paths = 4096});
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const dvec3 p = i == 0 ? dvec3(0, 0, 0) : dvec3(1, 0.5, 0);
    const std::vector<dvec3> outline{
        {-0.5, -0.5, 2}, {-0.5, 0.5, 2}, {0.5, 0.5, 2}, {0.5, -0.5, 2}};
    const double lux = 1000.0 / kPi * light::polygonIrradiance(outline, p, {0, 0, 1});
    // Statistical: the panel is sampled by area, f varies by 20 % over it; 8192 paths.
    EXPECT_NEAR(seen[i].mean().y, 0.5 * lux / kPi, 0.5 * lux / kPi * 0.01);
  }
}

TEST(Beams, NearMirrorUnderUniformLightReflectsFresnel) {
  // A panel so large that the reflected lobe lies in it; alpha = 0.01.
  scene::Material m = matte(0.0);
  m.specular = 0.3;
  m.roughness = 0.1;
  const double side = 100.0;
  const ReferenceScene scene =
      test::prepare(floorOf(m), {luminaire(light::Rectangle{side, side}, {0, 0, 2}, 1.0e6)});
  const double luminance = 1.0e6 / (kPi * side * side);
  const std::vector<Beam> beams{downAt({0, 0, 0}, {0.5, 0, 1.5})};
  const auto seen = traceBeams(scene, beams, {.paths = 8192});
  const double cosine = 1.5 / std::sqrt(0.25 + 2.25);
  const double fresnel = 0.3 + 0.7 * std::pow(1.0 - cosine, 5);
  EXPECT_NEAR(seen[0].mean().y, luminance * fresnel, luminance * fresnel * 0.01);
}

TEST(Beams, LuminairesThatAreLookedAtAreLeftOut) {
  const ReferenceScene scene =
      test::prepare(floorOf(matte(0.0)), {luminaire(light::Rectangle{1, 1}, {0, 0, 2})});
  const std::vector<Beam> beams{downAt({0, 0, 2}, {0, 0, 1})};
  EXPECT_EQ(traceBeams(scene, beams, {.paths = 64})[0].mean(), dvec3(0.0));
}

TEST(Beams, APixelsFilterIsATent) {
  // Bright where x > 0 only: a pixel centred on the edge sees half, one a quarter of its radius to
  // the side the tent's share beyond it.
  const auto room = test::Builder()
                        .quad({0, -50, 0}, {50, 0, 0}, {0, 100, 0}, matte(0.8))
                        .quad({-50, -50, 0}, {50, 0, 0}, {0, 100, 0}, matte(0.0))
                        .scene();
  const ReferenceScene scene =
      test::prepare(room, {luminaire(light::Sphere{0.5}, {0, 0, 100}, 1.0e6)});
  Beam pixel{{0, 0, 10}, {0, 0, -1}, {0.1, 0, 0}, {0, 0.1, 0}};
  Beam beside = pixel;
  beside.direction = glm::normalize(dvec3(0.05, 0, -1));
  const Beam inside = downAt({5, 0, 0}, {0, 0, 10});
  const auto seen = traceBeams(scene, std::vector{pixel, beside, inside}, {.paths = 16384});
  EXPECT_NEAR(seen[0].mean().y / seen[2].mean().y, 0.5, 0.02);
  EXPECT_NEAR(seen[1].mean().y / seen[2].mean().y, 1.0 - 0.5 * 0.25, 0.02);
}

TEST(Beams, HalvesAreIndependentAndRepeatable) {
  const ReferenceScene scene =
      test::prepare(floorOf(matte(0.5)), {luminaire(light::Rectangle{1, 1}, {0, 0, 2})});
  const std::vector<Beam> beams{downAt({0, 0, 0}, {3, 1, 1})};
  const auto a = traceBeams(scene, beams, {.paths = 64});
  const auto b = traceBeams(scene, beams, {.paths = 64});
  EXPECT_EQ(a[0].halves[0], b[0].halves[0]);
  EXPECT_NE(a[0].halves[0], a[0].halves[1]);
  EXPECT_NE(traceBeams(scene, beams, {.paths = 64, .seed = 2})[0].halves[0], a[0].halves[0]);
}

}  // namespace
}  // namespace soffit::reference
