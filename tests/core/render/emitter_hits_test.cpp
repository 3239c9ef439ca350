// SPDX-License-Identifier: MIT
#include "core/render/emitter_hits.h"

#include "core/math/rng.h"
#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <memory>

namespace soffit::render {
namespace {

light::Emitter make(const light::Shape& shape, const dvec3& position, bool body = false,
                    bool on = true) {
  light::Luminaire l;
  l.name = "L";
  l.shape = shape;
  l.position = position;
  l.flux = 1000.0;
  l.casts_shadow = body;
  l.on = on;
  return light::makeEmitter(l).value();
}

EmitterHit shoot(const light::Emitter& e, const vec3& origin, const vec3& direction) {
  const std::vector<light::Emitter> one{e};
  return EmitterHits(one).closest({.origin = origin, .direction = glm::normalize(direction)});
}

constexpr vec3 kUp(0, 0, 1);
constexpr vec3 kDown(0, 0, -1);
constexpr vec3 kEast(1, 0, 0);

TEST(EmitterHits, SeesARectangleFromItsEmittingSideOnly) {
  const light::Emitter e = make(light::Rectangle{0.6, 0.4}, {1, 1, 2});
  const EmitterHit hit = shoot(e, {1.29F, 1.19F, 0}, kUp);
  ASSERT_TRUE(hit.valid());
  EXPECT_FLOAT_EQ(hit.t, 2.0F);
  EXPECT_TRUE(hit.emits);
  EXPECT_EQ(hit.normal, kDown);
  EXPECT_FALSE(shoot(e, {1.31F, 1.0F, 0}, kUp).valid());
  EXPECT_FALSE(shoot(e, {1, 1.21F, 0}, kUp).valid());
  EXPECT_FALSE(shoot(e, {1, 1, 3}, kDown).valid());  // its back is not there
}

TEST(EmitterHits, ABodyIsBlackFromBehindAndWhenItIsOff) {
  const EmitterHit back = shoot(make(light::Rectangle{}, {0, 0, 2}, true), {0, 0, 3}, kDown);
  ASSERT_TRUE(back.valid());
  EXPECT_FALSE(back.emits);
  const EmitterHit off = shoot(make(light::Rectangle{}, {0, 0, 2}, true, false), {0, 0, 0}, kUp);
  ASSERT_TRUE(off.valid());
  EXPECT_FALSE(off.emits);
  EXPECT_FALSE(shoot(make(light::Rectangle{}, {0, 0, 2}, false, false), {0, 0, 0}, kUp).valid());
}

TEST(EmitterHits, FollowsConcaveOutlines) {
  // An L whose inner corner is at (0.15, 0.15).
  const light::Emitter e =
      make(light::Polygon{{{0, 0}, {0.4, 0}, {0.4, 0.15}, {0.15, 0.15}, {0.15, 0.4}, {0, 0.4}}},
           {0, 0, 1});
  EXPECT_TRUE(shoot(e, {0.3F, 0.1F, 0}, kUp).valid());
  EXPECT_TRUE(shoot(e, {0.1F, 0.3F, 0}, kUp).valid());
  EXPECT_FALSE(shoot(e, {0.3F, 0.3F, 0}, kUp).valid());
}

TEST(EmitterHits, MeetsDiskSphereAndTubeExactly) {
  EXPECT_TRUE(shoot(make(light::Disk{0.3}, {0, 0, 1}), {0.29F, 0, 0}, kUp).valid());
  EXPECT_FALSE(shoot(make(light::Disk{0.3}, {0, 0, 1}), {0.22F, 0.22F, 0}, kUp).valid());

  const light::Emitter ball = make(light::Sphere{0.5}, {3, 0, 0});
  EXPECT_FLOAT_EQ(shoot(ball, {0, 0, 0}, kEast).t, 2.5F);
  EXPECT_FLOAT_EQ(shoot(ball, {0, 0.3F, 0}, kEast).t, 2.6F);  // 3 - sqrt(0.25 - 0.09)
  EXPECT_FALSE(shoot(ball, {0, 0.51F, 0}, kEast).valid());
  EXPECT_FALSE(shoot(ball, {3, 0, 0}, kEast).valid());  // its inside gives no light
  EXPECT_FALSE(shoot(make(light::Sphere{0.5}, {3, 0, 0}, true), {3, 0, 0}, kEast).emits);

  const light::Emitter tube = make(light::Tube{1.0, 0.1}, {0, 0, 1});
  EXPECT_FLOAT_EQ(shoot(tube, {0.49F, 0, 0}, kUp).t, 0.9F);
  EXPECT_EQ(shoot(tube, {0.49F, 0, 0}, kUp).normal, kDown);
  EXPECT_FALSE(shoot(tube, {0.51F, 0, 0}, kUp).valid());
  EXPECT_FALSE(shoot(tube, {-2, 0, 1}, kEast).valid());  // through its open ends
  const EmitterHit end = shoot(make(light::Tube{1.0, 0.1}, {0, 0, 1}, true), {-2, 0, 1.05F}, kEast);
  ASSERT_TRUE(end.valid());
  EXPECT_FLOAT_EQ(end.t, 1.5F);
  EXPECT_FALSE(end.emits);
}

TEST(EmitterHits, SeesAMeshThroughItsUnlitSides) {
  auto mesh = std::make_shared<geometry::Mesh>();
  // Two sheets at z = 0 and z = 1 that both emit down.
  mesh->positions = {{-1, -1, 0}, {-1, 3, 0}, {3, -1, 0}, {-1, -1, 1}, {-1, 3, 1}, {3, -1, 1}};
  mesh->triangles = {{0, 1, 2}, {3, 4, 5}};
  light::MeshShape shape;
  shape.mesh = mesh;
  const EmitterHit below = shoot(make(shape, {0, 0, 0}), {0, 0, -1}, kUp);
  EXPECT_FLOAT_EQ(below.t, 1.0F);
  EXPECT_TRUE(below.emits);
  EXPECT_FLOAT_EQ(shoot(make(shape, {0, 0, 0}), {0, 0, 0.5F}, kUp).t, 0.5F);
  EXPECT_FALSE(shoot(make(shape, {0, 0, 0}), {0, 0, 2}, kDown).valid());
  EXPECT_FALSE(shoot(make(shape, {0, 0, 0}, true), {0, 0, 2}, kDown).emits);
  EXPECT_TRUE(shoot(make(shape, {0, 0, 0}, true), {0, 0, 2}, kDown).valid());
}

TEST(EmitterHits, PointsAreTooSmallToBeSeen) {
  EXPECT_TRUE(
      EmitterHits(std::vector<light::Emitter>{make(light::PointShape{}, {0, 0, 1})}).empty());
}

TEST(EmitterHits, TheHierarchyFindsWhatEachOneAloneGives) {
  Rng rng(7);
  std::vector<light::Emitter> emitters;
  for (int i = 0; i < 60; ++i) {
    const dvec3 p(4 * rng.uniformDouble(), 4 * rng.uniformDouble(), 4 * rng.uniformDouble());
    switch (i % 4) {
      case 0:
        emitters.push_back(make(light::Rectangle{0.5, 0.3}, p, i % 3 == 0));
        break;
      case 1:
        emitters.push_back(make(light::Disk{0.3}, p));
        break;
      case 2:
        emitters.push_back(make(light::Sphere{0.2}, p));
        break;
      default:
        emitters.push_back(make(light::Tube{0.7, 0.05}, p, i % 3 == 0));
        break;
    }
  }
  const EmitterHits all(emitters);
  int found = 0;
  for (int i = 0; i < 2000; ++i) {
    const vec3 origin(4 * rng.uniform(), 4 * rng.uniform(), 4 * rng.uniform());
    const geometry::Ray ray{.origin = origin,
                            .direction = uniformSphere(rng.uniform(), rng.uniform())};
    EmitterHit nearest;
    bool body = false;
    for (std::size_t k = 0; k < emitters.size(); ++k) {
      const EmitterHit hit = EmitterHits(std::span(emitters).subspan(k, 1)).closest(ray);
      if (hit.valid() && hit.t < nearest.t)
        nearest = {static_cast<int>(k), hit.t, hit.normal, hit.emits};
      body = body || (hit.valid() && emitters[k].casts_shadow && k != 0);
    }
    const EmitterHit hit = all.closest(ray);
    ASSERT_EQ(hit.emitter, nearest.emitter);
    ASSERT_EQ(hit.t, nearest.t);
    ASSERT_EQ(all.blocked(ray, 0), body);
    found += hit.valid() ? 1 : 0;
  }
  EXPECT_GT(found, 200);
}

}  // namespace
}  // namespace soffit::render
