// SPDX-License-Identifier: MIT
#include "core/render/engine_light.h"

#include "tests/core/render/lit_room.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::render {
namespace {

using testing::LitRoom;
using testing::material;
using testing::spot;

/// Points of the floor's first triangle, off the middles of its texels.
std::vector<SurfacePoint> floorPoints(float blur) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < i; ++j) {
      const vec3 p(0.13F + 0.19F * static_cast<float>(i), 0.11F + 0.19F * static_cast<float>(j),
                   0.0F);
      SurfacePoint point{p, {0, 0, 1}, {0, 0, 1}, 0, {0.0F, 0.0F}};
      point.blur = blur;
      points.push_back(point);
    }
  }
  return points;
}

struct Light {
  std::vector<vec3> direct, indirect;
  Light(const EngineLight& light, const std::vector<SurfacePoint>& points)
      : direct(points.size()), indirect(points.size()) {
    light.evaluate(points, direct, indirect);
  }
};

double rms(const std::vector<vec3>& a, const std::vector<vec3>& b) {
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto d = static_cast<double>(a[i].y - b[i].y);
    squares += d * d;
    sum += static_cast<double>(b[i].y);
  }
  const auto n = static_cast<double>(a.size());
  return std::sqrt(squares / n) / (sum / n);
}

TEST(EngineLight, BlurredPointsTakeTheirTexelsLight) {
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), {spot()});
  const EngineLight engine(room.lighting);
  const Light exact(engine, floorPoints(0.0F));
  const Light blurred(engine, floorPoints(1.0F));
  // Between texels of 10 cm the light of a lamp 2 m above bends little, but is not the same.
  EXPECT_LT(rms(blurred.direct, exact.direct), 0.01);
  EXPECT_GT(rms(blurred.direct, exact.direct), 1.0e-5);
  EXPECT_EQ(blurred.indirect, exact.indirect);
}

TEST(EngineLight, TooLittleBlurForATexelIsExact) {
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), {spot()});
  const EngineLight engine(room.lighting);
  EXPECT_EQ(Light(engine, floorPoints(0.01F)).direct, Light(engine, floorPoints(0.0F)).direct);
}

TEST(EngineLight, SharpAndBlurredPointsMix) {
  const LitRoom room(material(0.4, 0.0, 0.5), material(0.5, 0.0, 0.5), {spot()});
  const EngineLight engine(room.lighting);
  const Light exact(engine, floorPoints(0.0F));
  const Light blurred(engine, floorPoints(1.0F));
  std::vector<SurfacePoint> mixed = floorPoints(0.0F);
  for (std::size_t i = 0; i < mixed.size(); i += 2) mixed[i].blur = 1.0F;
  const Light found(engine, mixed);
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    const vec3& wanted = i % 2 == 0 ? blurred.direct[i] : exact.direct[i];
    EXPECT_NEAR(found.direct[i].y, wanted.y, 1.0e-3F * wanted.y);
  }
}

}  // namespace
}  // namespace soffit::render
