// SPDX-License-Identifier: MIT
#include "core/render/live_probes.h"

#include "core/glossy/lobe_shape.h"
#include "core/render/lamp_highlights.h"
#include "core/render/microfacet.h"
#include "core/render/probe_places.h"
#include "core/render/sent_albedo.h"
#include "tests/core/render/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::render {
namespace {

constexpr double kDiffuse = 0.5;
constexpr double kF0 = 0.04;

/// A room of 4 x 3 x 2.5 m with a floor of this roughness.
std::unique_ptr<ViewScene> roomScene(double roughness, double diffuse = kDiffuse) {
  SceneBuilder builder;
  const auto wall = builder.addMaterial({.diffuse = dvec3(diffuse)});
  const auto floor =
      builder.addMaterial({.diffuse = dvec3(diffuse), .specular = kF0, .roughness = roughness});
  builder.addQuad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, floor);
  builder.addQuad({0, 0, 2.5F}, {0, 3, 0}, {4, 0, 0}, wall);
  builder.addQuad({0, 0, 0}, {0, 3, 0}, {0, 0, 2.5F}, wall);
  builder.addQuad({0, 0, 0}, {0, 0, 2.5F}, {4, 0, 0}, wall);
  builder.addQuad({0, 3, 0}, {4, 0, 0}, {0, 0, 2.5F}, wall);
  builder.addQuad({4, 0, 0}, {0, 0, 2.5F}, {0, 3, 0}, wall);
  return builder.build();
}

transfer::Texels texelsOf(const ViewScene& scene) {
  const std::vector<std::uint8_t> sides(scene.mesh().triangles.size(), transfer::kFront);
  return transfer::makeTexels(scene.mesh(), sides, 0.25, nullptr);
}

/// Lux per slot such that all surfaces look the same, `radiance` cd/m2.
relight::Planes evenLight(const ViewScene& scene, const transfer::Texels& texels, float radiance) {
  const SentAlbedo sent(scene);
  relight::Planes lux;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    SurfaceSample sample;
    sample.albedo = scene.material(texels.triangle[s]).diffuse;
    sample.material = scene.materialIndex(texels.triangle[s]);
    const auto e = static_cast<float>(kPi) * radiance / sent.of(sample).y;
    for (auto& plane : lux) plane.push_back(e);
  }
  return lux;
}

light::Luminaire sphereLamp(const dvec3& at, double radius) {
  light::Luminaire lamp;
  lamp.shape = light::Sphere{radius};
  lamp.position = at;
  lamp.flux = 1000.0;
  return lamp;
}

TEST(LiveProbes, UniformLightGivesTheReflectance) {
  for (const double roughness : {0.2, 0.5, 0.9}) {
    const auto scene = roomScene(roughness);
    const transfer::Texels texels = texelsOf(*scene);
    const auto probes = LiveProbes::make(*scene, texels, {});
    ASSERT_NE(probes, nullptr);
    const auto lit = probes->light(evenLight(*scene, texels, 20.0F), {}, nullptr);
    for (const vec3& p : {vec3(1, 1, 0), vec3(3.5F, 0.2F, 0), vec3(0.1F, 2.9F, 0)}) {
      const vec3 to_eye = glm::normalize(vec3(2, 1.5F, 1.6F) - p);
      const double alpha = roughness * roughness;
      const double expected =
          20.0 * glossy::lobeShape(static_cast<double>(to_eye.z), alpha).reflectance(kF0);
      const vec3 found = lit->reflected({p, {0, 0, 1}, to_eye}, static_cast<float>(kF0),
                                        static_cast<float>(alpha));
      EXPECT_NEAR(static_cast<double>(found.y), expected, 1e-3 * expected) << roughness;
    }
  }
}

TEST(LiveProbes, MattSceneHasNone) {
  SceneBuilder builder;
  builder.addBox(vec3(0.0F), vec3(4, 3, 2.5F), builder.addMaterial({}), true);
  const auto scene = builder.build();
  EXPECT_EQ(LiveProbes::make(*scene, texelsOf(*scene), {}), nullptr);
}

TEST(LiveProbes, GivenUpWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  const auto scene = roomScene(0.5);
  EXPECT_EQ(LiveProbes::make(*scene, texelsOf(*scene), Job{nullptr, stop.get_token()}), nullptr);
}

/// What the floor of a black room shows of a lamp.
vec3 highlightOf(const LitLamp& lamp, const vec3& p, const vec3& eye, float alpha) {
  return lampHighlight(lamp, p, {0, 0, 1}, glm::normalize(eye - p), static_cast<float>(kF0), alpha);
}

TEST(LitLamp, SmallLampsGiveTheirIntensityThroughTheLobe) {
  const auto scene = roomScene(0.3, 0.0);
  const dvec3 at(3.0, 1.5, 1.5);
  const auto emitter = light::makeEmitter(sphereLamp(at, 0.005));
  ASSERT_TRUE(emitter.ok());
  LampMaker maker;
  const auto lamps = maker.lampsOf(std::span(&*emitter, 1), scene->caster(), {});
  ASSERT_EQ(lamps.size(), 1U);
  const vec3 eye(1.0F, 1.5F, 1.5F);
  constexpr float kAlpha = 0.09F;
  for (float x = 1.0F; x < 3.0F; x += 0.2F) {
    const vec3 p(x, 1.4F, 0.0F);
    const vec3 wi = glm::normalize(vec3(at) - p);
    const vec3 wo = glm::normalize(eye - p);
    const float r2 = static_cast<float>(glm::dot(at - dvec3(p), at - dvec3(p)));
    const float candela = 1000.0F / (4.0F * static_cast<float>(kPi));
    const float expected = candela / r2 * ggxReflection(wo, wi, static_cast<float>(kF0), kAlpha);
    // Wider by a sixtieth of alpha.
    EXPECT_NEAR(highlightOf(lamps[0], p, eye, kAlpha).y, expected, 0.04F * expected + 1e-4F) << x;
  }
}

TEST(LitLamp, LargeLampsAreNearTheClosedForm) {
  // Against linearly transformed cosines, whose shadow rays find nothing in the way.
  for (const double radius : {0.05, 0.2}) {
    const auto with = roomScene(0.4, 0.0);
    SceneBuilder builder;
    const auto floor = builder.addMaterial({.specular = kF0, .roughness = 0.4});
    builder.addQuad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}, floor);
    const auto lamp = sphereLamp(dvec3(3.0, 1.5, 1.5), radius);
    const auto scene = builder.build({lamp});
    LampMaker maker;
    const auto lamps = maker.lampsOf(scene->emitters(), with->caster(), {});
    double sum = 0.0;
    double off = 0.0;
    for (float x = 1.6F; x < 2.5F; x += 0.05F) {
      SurfaceSample at;
      at.point.position = {x, 1.5F, 0.0F};
      at.to_eye = glm::normalize(vec3(1.0F, 1.5F, 1.5F) - at.point.position);
      const double exact =
          static_cast<double>(lampHighlights(*scene, at, static_cast<float>(kF0), 0.16F).y);
      const double found = static_cast<double>(
          highlightOf(lamps[0], at.point.position, {1.0F, 1.5F, 1.5F}, 0.16F).y);
      sum += exact;
      off += std::abs(found - exact);
    }
    EXPECT_LT(off / sum, radius < 0.1 ? 0.015 : 0.04) << radius;
  }
}

TEST(LitLamp, WallsAndDarkSidesHideThem) {
  const auto scene = roomScene(0.3, 0.0);
  const auto above = light::makeEmitter(sphereLamp(dvec3(2.0, 1.5, 3.0), 0.1));
  ASSERT_TRUE(above.ok());
  LampMaker maker;
  const auto hidden = maker.lampsOf(std::span(&*above, 1), scene->caster(), {});
  ASSERT_EQ(hidden.size(), 1U);
  EXPECT_EQ(highlightOf(hidden[0], {2, 1.5F, 0}, {2, 1.5F, 2}, 0.3F), vec3(0.0F));
  light::Luminaire panel;
  panel.position = dvec3(2.0, 1.5, 2.5);  // in the ceiling
  panel.flux = 1000.0;
  const auto down = light::makeEmitter(panel);
  ASSERT_TRUE(down.ok());
  const auto lit = maker.lampsOf(std::span(&*down, 1), scene->caster(), {});
  EXPECT_GT(highlightOf(lit[0], {2, 1.5F, 0}, {2, 1.4F, 2}, 0.3F).y, 0.0F);
  panel.rotation_deg = dvec3(180.0, 0.0, 0.0);
  const auto up = light::makeEmitter(panel);
  ASSERT_TRUE(up.ok());
  const auto dark = maker.lampsOf(std::span(&*up, 1), scene->caster(), {});
  EXPECT_EQ(highlightOf(dark[0], {2, 1.5F, 0}, {2, 1.4F, 2}, 0.3F), vec3(0.0F));
}

TEST(LitLamp, WhatDidNotMoveIsKeptAndTheStrongestStay) {
  const auto scene = roomScene(0.3, 0.0);
  std::vector<light::Emitter> emitters;
  for (int i = 0; i < 80; ++i) {
    auto lamp = sphereLamp(dvec3(0.2 + 0.04 * i, 1.5, 2.0), 0.02);
    lamp.flux = 100.0 + i;
    emitters.push_back(*light::makeEmitter(lamp));
  }
  LampMaker maker;
  const auto first = maker.lampsOf(emitters, scene->caster(), {});
  ASSERT_EQ(first.size(), LampMaker::kMostLamps);
  EXPECT_FLOAT_EQ(first.front().position.x, 0.2F + 0.04F * 16.0F);  // the weakest are left out
  emitters[20] = *light::makeEmitter(sphereLamp(dvec3(0.5, 0.5, 1.0), 0.02));
  emitters[60].gain = 0.9;
  const auto second = maker.lampsOf(emitters, scene->caster(), {});
  ASSERT_EQ(second.size(), first.size());
  EXPECT_NE(second[4].map, first[4].map);
  EXPECT_EQ(second[44].map, first[44].map);
  EXPECT_FLOAT_EQ(second[44].color.y, 0.9F * first[44].color.y);
  EXPECT_EQ(second[6].map, first[6].map);
}

TEST(LitLamp, LongOnesAreARow) {
  const auto scene = roomScene(0.3, 0.0);
  light::Luminaire tube;
  tube.shape = light::Tube{1.2, 0.013};
  tube.position = dvec3(2.0, 1.5, 2.0);
  tube.flux = 1000.0;
  const auto emitter = light::makeEmitter(tube);
  ASSERT_TRUE(emitter.ok());
  const auto lamps = LampMaker().lampsOf(std::span(&*emitter, 1), scene->caster(), {});
  ASSERT_EQ(lamps.size(), 4U);
  float share = 0.0F;
  for (const LitLamp& lamp : lamps) share += lamp.color.y;
  EXPECT_NEAR(share, 1.0F, 1e-5F);
  EXPECT_NEAR(lamps[0].position.x, 1.55F, 1e-5F);
  EXPECT_NEAR(lamps[3].position.x, 2.45F, 1e-5F);
}

TEST(ProbePlaces, EveryRoomWithAFloorThatReflectsHasOne) {
  // Two rooms with a wall between them; a third floor lies open to the sky.
  SceneBuilder builder;
  const auto grey = builder.addMaterial({});
  builder.addBox({0, 0, 0}, {3, 3, 2.5F}, grey, true);
  builder.addBox({3.2F, 0, 0}, {6, 3, 2.5F}, grey, true);
  const auto scene = builder.build();
  std::vector<ReflectingPiece> pieces;
  for (float x = 0.1F; x < 6.0F; x += 0.2F) {
    for (float y = 0.1F; y < 3.0F; y += 0.2F) {
      if (x < 2.95F || x > 3.25F) pieces.push_back({{x, y, 0}, {0, 0, 1}, 0.04F});
    }
  }
  const auto places = probePlaces(scene->caster(), pieces, 8, false);
  EXPECT_GE(std::ranges::count_if(places, [](const vec3& p) { return p.x < 3.0F; }), 1);
  EXPECT_GE(std::ranges::count_if(places, [](const vec3& p) { return p.x > 3.2F; }), 1);
  EXPECT_LE(places.size(), 4U);
  for (const vec3& p : places) EXPECT_NEAR(p.z, 1.2F, 0.06F);
  EXPECT_EQ(probePlaces(scene->caster(), pieces, 1, false).size(), 1U);
  EXPECT_TRUE(probePlaces(scene->caster(), {}, 8, false).empty());
  // The undersides of the floors see the void alone.
  for (ReflectingPiece& piece : pieces) piece.normal = {0, 0, -1};
  EXPECT_TRUE(probePlaces(scene->caster(), pieces, 8, false).empty());
  EXPECT_FALSE(probePlaces(scene->caster(), pieces, 8, true).empty());
}

}  // namespace
}  // namespace soffit::render
