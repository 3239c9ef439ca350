// SPDX-License-Identifier: MIT
#include "core/daylight/environment.h"
#include "core/relight/lighting.h"
#include "tests/core/relight/readings.h"

#include <cmath>
#include <vector>

namespace soffit::relight {
namespace {

using namespace testing;

const std::shared_ptr<const Solver>& room() {
  static const auto solver = solverFor(blockRoom(), {dvec3(0.7, 0.6, 0.5)});
  return solver;
}

std::vector<light::Emitter> emittersOf(const std::vector<light::Luminaire>& luminaires,
                                       const std::vector<std::size_t>& which) {
  std::vector<light::Emitter> out;
  for (const std::size_t i : which) {
    const auto emitter = light::makeEmitter(luminaires[i], room()->scene().mesh->origin);
    EXPECT_TRUE(emitter.ok());
    out.push_back(*emitter);
  }
  return out;
}

Planes freshTotal(const std::vector<light::Luminaire>& luminaires) {
  Lighting fresh(room());
  EXPECT_TRUE(fresh.setLuminaires(luminaires).ok());
  return fresh.total();
}

/// RMS of the difference by the mean of b.
double difference(const Planes& a, const Planes& b) {
  double squares = 0.0;
  double sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < a[c].size(); ++s) {
      squares += std::pow(static_cast<double>(a[c][s]) - static_cast<double>(b[c][s]), 2.0);
      sum += static_cast<double>(b[c][s]);
    }
  }
  const auto count = static_cast<double>(3 * a[0].size());
  return std::sqrt(squares / count) / (sum / count);
}

std::vector<light::Luminaire> fourPanels() {
  std::vector<light::Luminaire> all{panel({1, 1.5, 2.9}), panel({3, 4, 2.9}), panel({2, 3, 2.4}),
                                    panel({3, 1, 2.9}, 0.3, 900.0)};
  all[1].colour.rgb = dvec3(1.0, 0.4, 0.2);
  all[2].dimming = 0.3;
  return all;
}

TEST(Hand, SeveralLuminairesMoveTogether) {
  auto luminaires = fourPanels();
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  const std::vector<std::size_t> hand{0, 1, 2};
  lighting.grab(hand);
  // As they are: the light of each to itself is at hand, and of all together is the same.
  (void)lighting.move(emittersOf(luminaires, hand));
  EXPECT_LT(difference(lighting.moved(), lighting.total()), 1e-3);
  for (int step = 0; step < 4; ++step) {
    for (const std::size_t i : hand) luminaires[i].position += dvec3(0.1, 0.07, -0.02);
    const StageTimes times = lighting.move(emittersOf(luminaires, hand));
    EXPECT_GT(times.total(), 0.0);
    // Energy is conserved by the sum of a colour instead of by the luminaire.
    EXPECT_LT(difference(lighting.moved(), freshTotal(luminaires)), 1e-3) << step;
  }
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), freshTotal(luminaires));
}

TEST(Hand, WhatIsOffGivesNothingAndIsThereWhenSwitchedOn) {
  auto luminaires = fourPanels();
  luminaires[1].on = false;
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  const std::vector<std::size_t> hand{1, 3};
  lighting.grab(hand);
  for (const std::size_t i : hand) luminaires[i].position.y += 0.3;
  (void)lighting.move(emittersOf(luminaires, hand));
  EXPECT_LT(difference(lighting.moved(), freshTotal(luminaires)), 1e-3);
  luminaires[1].on = true;
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), freshTotal(luminaires));
}

TEST(Hand, DimmingTakesNoDirectLight) {
  auto luminaires = fourPanels();
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  for (const std::vector<std::size_t>& hand : {std::vector<std::size_t>{0}, {0, 2}}) {
    lighting.grab(hand);
    for (const std::size_t i : hand) luminaires[i].dimming *= 0.5;
    light::DirectCounts counts;
    const StageTimes times = lighting.move(emittersOf(luminaires, hand), &counts);
    EXPECT_EQ(counts.clusters, 0U);
    EXPECT_EQ(times.direct, 0.0);
    EXPECT_LT(difference(lighting.moved(), freshTotal(luminaires)), 1e-3);
  }
}

TEST(Hand, AMovingBodyShadesTheOthers) {
  auto luminaires = fourPanels();
  luminaires[2].casts_shadow = true;
  luminaires[2].shape = light::Rectangle{0.9, 0.7};
  luminaires[2].position = dvec3(1.0, 1.6, 2.0);  // under the first panel
  luminaires[3].on = false;
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  const Planes before = lighting.total();
  lighting.grab(2);
  for (int step = 0; step < 3; ++step) {
    luminaires[2].position += dvec3(0.5, 0.6, 0.05);
    light::DirectCounts counts;
    (void)lighting.move(emittersOf(luminaires, {2}), &counts);
    const Planes now = freshTotal(luminaires);
    // The shadows matter here, and follow.
    EXPECT_GT(difference(before, now), 0.05);
    EXPECT_LT(difference(lighting.moved(), now), 1e-3) << step;
  }
  luminaires[3].on = true;
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), freshTotal(luminaires));
}

TEST(Hand, OfAMovingBodyOnlyItsShadowsAreComputedAnew) {
  auto luminaires = fourPanels();
  luminaires[2].shape = light::Sphere{0.05};
  luminaires[2].position = dvec3(3.7, 4.7, 0.3);
  Lighting lighting(room());
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  light::DirectCounts alone;
  lighting.grab(2);
  luminaires[2].position.z += 0.02;
  (void)lighting.move(emittersOf(luminaires, {2}), &alone);
  luminaires[2].casts_shadow = true;
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  light::DirectCounts with_body;
  lighting.grab(2);
  luminaires[2].position.z += 0.02;
  (void)lighting.move(emittersOf(luminaires, {2}), &with_body);
  // A ball of 10 cm in a corner stands before little of the room: three more lights, and not half
  // as many points again.
  EXPECT_GT(with_body.points, alone.points);
  EXPECT_LT(with_body.points, alone.points + alone.points / 2);
}

TEST(Hand, ABodyMovesBesideGlass) {
  auto mesh = blockRoom();
  addQuad(*mesh, {0, 3, 0}, {4, 3, 0}, {4, 3, 3}, {0, 3, 3}, 1);
  mesh->materials = {"walls", "glass"};
  std::vector<scene::Material> materials(2);
  materials[0].diffuse = dvec3(0.5);
  materials[1].glass = scene::Glass{1.52, 0.8};
  const auto scene = transfer::makeStaticScene(mesh, {}, daylight::Panes::make(*mesh, materials));
  auto operators = transfer::bake(*scene, quickSettings(), {}, {});
  ASSERT_TRUE(operators.ok());
  const auto solver = std::make_shared<const Solver>(scene, *operators, materials);
  auto luminaires = fourPanels();
  luminaires[2].casts_shadow = true;
  luminaires[2].shape = light::Rectangle{0.9, 0.7};
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  lighting.grab(2);
  luminaires[2].position += dvec3(-0.5, -0.4, -0.3);
  (void)lighting.move(emittersOf(luminaires, {2}));
  ASSERT_TRUE(lighting.setLuminaires(luminaires).ok());
  Lighting fresh(solver);
  ASSERT_TRUE(fresh.setLuminaires(luminaires).ok());
  EXPECT_EQ(lighting.total(), fresh.total());
}

TEST(Hand, TheSunsShadowOfABodyFollowsWhenItIsLetGo) {
  // A room without its ceiling.
  auto mesh = emptyMesh();
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  std::erase_if(mesh->triangles, [&](const uvec3& t) {
    return mesh->positions[t.x].z > 2.9F && mesh->positions[t.y].z > 2.9F &&
           mesh->positions[t.z].z > 2.9F;
  });
  mesh->material_of.resize(mesh->triangles.size());
  mesh->object_of.resize(mesh->triangles.size());
  const auto solver = solverFor(mesh, {dvec3(0.5)});
  scene::Environment sky;
  sky.light = scene::Sky{.cie = 12,
                         .sun_azimuth_deg = 180.0,
                         .sun_altitude_deg = 60.0,
                         .horizontal_illuminance = 10000.0,
                         .direct_normal_illuminance = 60000.0};
  const auto outside = std::make_shared<const daylight::Environment>(sky);
  auto body = panel({2, 2.5, 1.0});
  body.casts_shadow = true;
  Lighting lighting(solver);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{body}).ok());
  ASSERT_TRUE(lighting.setEnvironment(outside).ok());
  lighting.grab(0);
  body.position.x += 0.8;
  const auto emitter = light::makeEmitter(body, mesh->origin);
  (void)lighting.move(*emitter);
  ASSERT_TRUE(lighting.setLuminaires(std::vector{body}).ok());
  Lighting fresh(solver);
  ASSERT_TRUE(fresh.setLuminaires(std::vector{body}).ok());
  ASSERT_TRUE(fresh.setEnvironment(outside).ok());
  EXPECT_EQ(lighting.total(), fresh.total());
}

}  // namespace
}  // namespace soffit::relight
