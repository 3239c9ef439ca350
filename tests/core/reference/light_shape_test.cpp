// SPDX-License-Identifier: MIT
#include "core/reference/light_shape.h"

#include "rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::reference {
namespace {

light::Emitter emitterOf(light::Shape shape, bool casts_shadow = true) {
  light::Luminaire l = test::luminaire(std::move(shape), {1, 2, 3});
  l.casts_shadow = casts_shadow;
  return light::makeEmitter(l).value();
}

std::vector<double> crossings(const light::Emitter& e, const Line& line) {
  std::vector<Crossing> found;
  LightShape(e).cross(line, kInfinity, found);
  std::vector<double> t;
  for (const Crossing& c : found) t.push_back(c.t);
  return t;
}

double body(const light::Emitter& e, const Line& line) {
  return LightShape(e).bodyDistance(line, kInfinity);
}

const Line kUp{{1, 2, 0}, {0, 0, 1}};
const Line kDown{{1, 2, 5}, {0, 0, -1}};
constexpr double kRoundoff = 1e-13;

TEST(LightShape, PlanarShapesAreCrossedAndBlockFromBothSides) {
  for (const light::Shape& shape :
       {light::Shape(light::Rectangle{0.4, 0.2}), light::Shape(light::Disk{0.2}),
        light::Shape(light::Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}})}) {
    const light::Emitter e = emitterOf(shape);
    ASSERT_EQ(crossings(e, kUp).size(), 1U);
    EXPECT_NEAR(crossings(e, kUp)[0], 3.0, kRoundoff);
    EXPECT_NEAR(crossings(e, kDown)[0], 2.0, kRoundoff);
    EXPECT_NEAR(body(e, kUp), 3.0, kRoundoff);
    EXPECT_NEAR(body(e, kDown), 2.0, kRoundoff);
    EXPECT_EQ(body(e, {{3, 2, 0}, {0, 0, 1}}), kInfinity);
    EXPECT_EQ(body(e, {{1, 2, 0}, {0, 0, -1}}), kInfinity);
    EXPECT_EQ(LightShape(e).bodyDistance(kUp, 2.9), kInfinity);
  }
}

TEST(LightShape, RectanglesEndAtTheirEdges) {
  const light::Emitter e = emitterOf(light::Rectangle{0.4, 0.2});
  EXPECT_EQ(crossings(e, {{1.199, 2.099, 0}, {0, 0, 1}}).size(), 1U);
  EXPECT_TRUE(crossings(e, {{1.201, 2.0, 0}, {0, 0, 1}}).empty());
  EXPECT_TRUE(crossings(e, {{1.0, 2.101, 0}, {0, 0, 1}}).empty());
}

TEST(LightShape, NotchesOfPolygonsLetRaysThrough) {
  const light::Emitter e =
      emitterOf(light::Polygon{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  EXPECT_EQ(crossings(e, {{1.5, 3.5, 0}, {0, 0, 1}}).size(), 1U);
  EXPECT_TRUE(crossings(e, {{2.5, 3.5, 0}, {0, 0, 1}}).empty());
}

TEST(LightShape, SpheresAreCrossedTwiceWithOutwardNormals) {
  const light::Emitter e = emitterOf(light::Sphere{0.5});
  std::vector<Crossing> found;
  LightShape(e).cross(kUp, kInfinity, found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].t, 2.5, kRoundoff);
  EXPECT_NEAR(found[1].t, 3.5, kRoundoff);
  EXPECT_NEAR(found[0].normal.z, -1.0, kRoundoff);
  EXPECT_NEAR(found[1].normal.z, 1.0, kRoundoff);
  EXPECT_NEAR(body(e, kUp), 2.5, kRoundoff);
}

TEST(LightShape, TubesShineFromTheirSideAndAreClosedAtTheirEnds) {
  const light::Emitter e = emitterOf(light::Tube{1.0, 0.1});
  EXPECT_EQ(crossings(e, kUp).size(), 2U);
  EXPECT_NEAR(crossings(e, kUp)[0], 2.9, kRoundoff);
  const Line along{{-1, 2, 3}, {1, 0, 0}};  // inside, parallel to the axis
  EXPECT_TRUE(crossings(e, along).empty());
  EXPECT_NEAR(body(e, along), 1.5, kRoundoff);
  EXPECT_TRUE(crossings(e, {{1.6, 2, 0}, {0, 0, 1}}).empty());
}

std::shared_ptr<const geometry::Mesh> twoSheets() {
  return test::Builder()
      .quad({-1, -1, 0}, {0, 2, 0}, {2, 0, 0}, test::matte(0.0))
      .quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, test::matte(0.0))
      .scene()
      .mesh;
}

TEST(LightShape, MeshesHideWhatIsBehindOnlyIfTheyCastShadows) {
  const light::MeshShape sheets{"m.obj", 1.0, 'z', twoSheets()};
  const Line line{{1.3, 2.2, 0}, {0, 0, 1}};
  EXPECT_EQ(crossings(emitterOf(sheets, false), line).size(), 2U);
  EXPECT_EQ(crossings(emitterOf(sheets, true), line).size(), 1U);
  const light::Emitter shading = emitterOf(sheets, true);
  const dvec3 below(1.3, 2.2, 0.0);
  const dvec3 down(0, 0, -1);
  EXPECT_FALSE(LightShape(shading).shadesItself(below, {1.3, 2.2, 3.0}, down));
  EXPECT_TRUE(LightShape(shading).shadesItself(below, {1.3, 2.2, 4.0}, down));
  EXPECT_FALSE(LightShape(emitterOf(sheets, false)).shadesItself(below, {1.3, 2.2, 4.0}, down));
}

TEST(LightShape, PointsHaveNoSurfaceAndNoBody) {
  const light::Emitter e = emitterOf(light::PointShape{});
  EXPECT_TRUE(crossings(e, kUp).empty());
  EXPECT_EQ(body(e, kUp), kInfinity);
}

}  // namespace
}  // namespace soffit::reference
