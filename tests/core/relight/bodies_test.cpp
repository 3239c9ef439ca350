// SPDX-License-Identifier: MIT
#include "core/relight/bodies.h"

#include "tests/core/relight/readings.h"

#include <numbers>

namespace soffit::relight {
namespace {

using namespace testing;

light::Emitter bodyOf(const light::Shape& shape, const dvec3& position = dvec3(2, 2.5, 1.5),
                      bool casts_shadow = true) {
  light::Luminaire l = panel(position);
  l.shape = shape;
  l.casts_shadow = casts_shadow;
  const auto e = light::makeEmitter(l);
  EXPECT_TRUE(e.ok());
  return *e;
}

double areaOf(const light::MaskBlocker& b) {
  dvec3 sum(0.0);
  for (int i = 1; i + 1 < b.count; ++i) {
    const dvec3 a(b.corners[0]);
    sum += 0.5 * glm::cross(dvec3(b.corners[static_cast<std::size_t>(i)]) - a,
                            dvec3(b.corners[static_cast<std::size_t>(i + 1)]) - a);
  }
  return glm::length(sum);
}

/// Area of the shadow along z: half of what all faces of a closed body, or all of a flat one,
/// project.
double shadowArea(const std::vector<light::MaskBlocker>& body, bool closed) {
  double sum = 0.0;
  for (const light::MaskBlocker& b : body)
    sum += areaOf(b) * std::abs(static_cast<double>(b.normal.z));
  return closed ? 0.5 * sum : sum;
}

TEST(BodyBlockers, HaveTheSilhouetteOfTheShape) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(shadowArea(bodyBlockers(bodyOf(light::Rectangle{0.6, 0.3})), false), 0.18, 1e-6);
  EXPECT_NEAR(shadowArea(bodyBlockers(bodyOf(light::Disk{0.4})), false), kPi * 0.16, 1e-5);
  // Tessellated, the same area within a few per cent.
  EXPECT_NEAR(shadowArea(bodyBlockers(bodyOf(light::Sphere{0.4})), true), kPi * 0.16,
              0.02 * kPi * 0.16);
  EXPECT_NEAR(shadowArea(bodyBlockers(bodyOf(light::Tube{1.2, 0.1})), true), 1.2 * 0.2,
              0.03 * 0.24);
  EXPECT_TRUE(bodyBlockers(bodyOf(light::PointShape{})).empty());
  EXPECT_TRUE(bodyBlockers(bodyOf(light::Sphere{0.4}, dvec3(0), false)).empty());
}

const std::shared_ptr<const Solver>& room() {
  static const auto solver = [] {
    auto mesh = emptyMesh();
    addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
    return solverFor(mesh, {dvec3(0.5)});
  }();
  return solver;
}

TEST(CoverTexels, TakesTheBodysAreaFromTheSurfaceItHugs) {
  const transfer::Texels& texels = room()->operators().texels;
  const auto covered = [&](double height, bool casts_shadow = true) {
    std::vector<float> open(texels.slotCount(), 1.0F);
    coverTexels(bodyOf(light::Rectangle{0.8, 0.6}, {2.03, 2.57, height}, casts_shadow), texels,
                open);
    double area = 0.0;
    for (std::size_t s = 0; s < open.size(); ++s) {
      EXPECT_GE(open[s], 0.0F);
      EXPECT_LE(open[s], 1.0F);
      area += static_cast<double>(texels.area[s]) * (1.0 - static_cast<double>(open[s]));
    }
    return area;
  };
  // 36 taps a texel of 15 cm: its edge is known to 2.5 cm, on a body of 80 x 60 cm.
  EXPECT_NEAR(covered(2.99), 0.48, 0.05);  // just below the ceiling
  EXPECT_NEAR(covered(0.01), 0.48, 0.05);  // lying on the floor
  EXPECT_EQ(covered(1.5), 0.0);            // hanging free
  EXPECT_EQ(covered(2.99, false), 0.0);
}

TEST(Bodies, ShadeOtherLightsAndNotTheirOwn) {
  // A black disk between a lamp and the floor; its own light goes on.
  light::Luminaire lamp = panel({2, 2.5, 2.9}, 0.1);
  light::Luminaire shade = panel({2, 2.5, 1.5}, 0.6, 500.0);
  const std::vector<scene::Sensor> below = {{{2, 2.5, 0.0}, {0, 0, 1}},
                                            {{3.9, 2.5, 0.0}, {0, 0, 1}}};
  const Readings lamp_alone = readIn(room(), {lamp}, below);
  const Readings shade_alone = readIn(room(), {shade}, below);
  shade.casts_shadow = true;
  const Readings both = readIn(room(), {lamp, shade}, below);
  EXPECT_NEAR(both.direct[0], shade_alone.direct[0],
              1e-5 * shade_alone.direct[0]);  // the lamp is hidden
  EXPECT_NEAR(both.direct[1], lamp_alone.direct[1] + shade_alone.direct[1],
              1e-5 * both.direct[1]);  // seen past it
}

}  // namespace
}  // namespace soffit::relight
