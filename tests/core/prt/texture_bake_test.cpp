// SPDX-License-Identifier: MIT
#include "core/prt/texture_bake.h"

#include "core/math/rng.h"
#include "core/prt/evaluate.h"
#include "core/sh/analytic_light.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stop_token>
#include <string>
#include <string_view>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::evenLight;
using testing::matte;

TextureBakeOptions quick() {
  TextureBakeOptions options;
  options.textures.texel = 0.1;
  options.bands = 4;
  options.directions = 400;
  options.bounce_coarseness = 3;
  return options;
}

std::vector<vec3> valuesOf(const TextureBake& bake, const sh::Coefficients& light) {
  Illuminances lux;
  evaluate(bake.transfer, LightVector(light), lux);
  std::vector<vec3> values;
  for (std::size_t i = 0; i < lux.size; ++i) values.push_back(lux.at(i));
  return values;
}

TEST(TextureBake, AWallOfTwoTrianglesShowsTheRightShadow) {
  const auto surfaces = testing::blockOnFloor(1, vec3(0.5F), vec3(0.5F), 0.3F).surfaces();
  TextureBakeOptions options = quick();
  options.textures.texel = 0.05;
  options.directions = 2048;
  options.bounces = false;
  const TextureBake bake = bakeTextures(surfaces, options).value();
  const sh::Coefficients light = sh::analyticCoefficients({}, 4);
  const std::vector<vec3> values = valuesOf(bake, light);
  const TextureSet& floor = bake.receivers->sets()[0];
  const LightTexture texture = paint(floor.levels[0], std::span(values).first(floor.count));
  Rng rng(6);
  double error = 0.0, size = 0.0;
  for (int i = 0; i < 60; ++i) {
    const vec3 p(1.9F * (2 * rng.uniform() - 1), 1.9F * (2 * rng.uniform() - 1), 0);
    const geometry::Hit hit = surfaces->caster->closest({p + vec3(0, 0, -1), 0.0F, {0, 0, 1}});
    vec2 place;
    ASSERT_TRUE(bake.receivers->place(hit, true, place));
    const Receivers at = testing::pointReceivers({p}, {0, 0, 1});
    const Directions fine(sh::hammersleySamples(20000), 4);
    const double wanted = testing::illuminance(testing::shadowed(*surfaces, at, fine), 0, light);
    error += std::pow(double{texture.at(place).y} - wanted, 2);
    size += wanted * wanted;
  }
  // 2048 directions and interpolation over 5 cm.
  EXPECT_LT(std::sqrt(error / size), 0.015);
}

TEST(TextureBake, WhatItTakesIsKnownBefore) {
  const auto surfaces = testing::blockOnFloor(1, vec3(0.5F), {0.5F, 0.2F, 0.2F}).surfaces();
  const TextureBakeOptions options = quick();
  const TextureBakeSize size =
      predictTextureBake(TextureReceivers::perObject(surfaces, options.textures), options);
  const TextureBake bake = bakeTextures(surfaces, options).value();
  EXPECT_EQ(size.texels, bake.receivers->receivers().size());
  EXPECT_EQ(size.flag_bytes, bake.flags.bytes());
  EXPECT_EQ(size.transfer_bytes, bake.transfer.bytes());
  EXPECT_EQ(bake.transfer.channels(), 3U);
  EXPECT_NEAR(double(size.shadow_rays), double(bake.shadow_rays), 0.2 * double(size.shadow_rays));
}

TEST(TextureBake, WhiteThingsUnderAnEvenSkyAllRoundAreFurnaces) {
  const auto surfaces = testing::blockOnFloor(1, vec3(1.0F), vec3(1.0F)).surfaces();
  TextureBakeOptions options = quick();
  options.directions = 1024;
  options.passes.threshold = 1e-5;
  const TextureBake bake = bakeTextures(surfaces, options).value();
  for (const vec3& e : valuesOf(bake, evenLight(4))) EXPECT_NEAR(e.y, kPi, 0.01 * kPi);
}

TEST(TextureBake, CoarseBouncesLookLikeFineOnes) {
  const auto surfaces =
      testing::blockOnFloor(1, {0.8F, 0.7F, 0.6F}, {0.8F, 0.3F, 0.2F}, 0.3F).surfaces();
  TextureBakeOptions options = quick();
  const auto coarse = valuesOf(bakeTextures(surfaces, options).value(), evenLight(4));
  options.bounce_coarseness = 1;
  const auto fine = valuesOf(bakeTextures(surfaces, options).value(), evenLight(4));
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    error += glm::dot(coarse[i] - fine[i], coarse[i] - fine[i]);
    size += glm::dot(fine[i], fine[i]);
  }
  EXPECT_LT(std::sqrt(error / size), 0.005);
}

Builder furnished(const vec3& box_at, const vec3& paint) {
  Builder b;
  b.add(geometry::makeRectangle(6, 6), matte(paint));
  b.add(testing::moved(geometry::makeBox({-0.3F, -0.2F, 0.1F}, {0.3F, 0.2F, 0.6F}), box_at),
        matte(vec3(0.5F)));
  b.add(geometry::makeSphere({-1.5F, 1, 0.6F}, 0.5F, 8), matte(vec3(0.5F)));
  // A room of its own that sees nothing of the others.
  b.add(geometry::makeSphere({40, 0, -40}, 1.0F, 8), matte(vec3(0.4F)));
  return b;
}

void expectEqual(const TextureBake& a, const TextureBake& b) {
  EXPECT_TRUE(a.flags == b.flags);
  EXPECT_EQ(a.keys, b.keys);
  ASSERT_EQ(a.direct.size(), b.direct.size());
  for (std::size_t i = 0; i < a.direct.size(); ++i) {
    EXPECT_EQ(a.direct.row(i)[0], b.direct.row(i)[0]);
    EXPECT_EQ(a.transfer.at(i, 0, 1), b.transfer.at(i, 0, 1));
  }
}

TEST(TextureBake, AfterAnEditOnlyStaleTexelsAreBakedAgain) {
  const TextureBakeOptions options = quick();
  const TextureBake first =
      bakeTextures(furnished({0.5F, 0.2F, 0}, vec3(0.6F)).surfaces(), options).value();
  for (const auto& share : first.redone) EXPECT_TRUE(share.new_layout);
  const auto moved = furnished({1.1F, -0.7F, 0.3F}, vec3(0.6F)).surfaces();
  const TextureBake whole = bakeTextures(moved, options).value();
  const TextureBake again = rebakeTextures(first, moved, options).value();
  expectEqual(again, whole);
  EXPECT_TRUE(again.redone[1].new_layout);
  EXPECT_EQ(again.redone[1].texels, again.receivers->sets()[1].count);
  for (const std::size_t k : {0U, 2U}) {
    EXPECT_FALSE(again.redone[k].new_layout);
    EXPECT_GT(again.redone[k].texels, 0U);
    EXPECT_LT(again.redone[k].texels, again.receivers->sets()[k].count);
  }
  EXPECT_EQ(again.redone[3].texels, 0U);  // too far away to see it
  EXPECT_LT(again.shadow_rays, whole.shadow_rays / 3);
}

TEST(TextureBake, PaintNeedsNoShadowRays) {
  TextureBakeOptions options = quick();
  options.bounce_coarseness = 1;
  const TextureBake grey =
      bakeTextures(furnished({0.5F, 0.2F, 0}, vec3(0.6F)).surfaces(), options).value();
  const auto red = furnished({0.5F, 0.2F, 0}, {0.8F, 0.2F, 0.1F}).surfaces();
  const TextureBake again = rebakeTextures(grey, red, options).value();
  EXPECT_EQ(again.shadow_rays, 0U);
  for (const auto& share : again.redone) EXPECT_EQ(share.texels, 0U);
  expectEqual(again, bakeTextures(red, options).value());
  EXPECT_EQ(again.transfer.channels(), 3U);
}

TEST(TextureBake, TakingAPaneOutBrightens) {
  const auto room = [](bool pane) {
    Builder b;
    b.add(geometry::makeRectangle(4, 4), matte(vec3(0.5F)));
    if (pane) {
      scene::Material glass;
      glass.glass = scene::Glass{1.52, 0.6};
      b.add(testing::moved(geometry::makeRectangle(2, 2), {0, 0, 1}), glass);
    }
    return b.surfaces();
  };
  TextureBakeOptions options = quick();
  const TextureBake with = bakeTextures(room(true), options).value();
  EXPECT_GT(with.flags.allDimmed().size(), 0U);
  const TextureBake without = rebakeTextures(with, room(false), options).value();
  expectEqual(without, bakeTextures(room(false), options).value());
  const TextureBake back = rebakeTextures(without, room(true), options).value();
  expectEqual(back, with);
}

/// Asks for a stop at the n-th report.
class Stopper final : public ProgressObserver {
 public:
  explicit Stopper(int n) : left_(n) {}
  void onProgress(std::string_view, double) override {
    if (--left_ == 0) stop_.request_stop();
  }
  [[nodiscard]] Job job() { return {this, stop_.get_token()}; }

 private:
  std::atomic<int> left_;
  std::stop_source stop_;
};

TEST(TextureBake, StopsInAnyStage) {
  const auto surfaces = testing::blockOnFloor(1, vec3(0.5F), vec3(0.5F)).surfaces();
  TextureBakeOptions options = quick();
  options.passes.threshold = 1e-3;
  int reports = 0;
  for (bool stopped = true; stopped; ++reports) {
    Stopper stopper(1 + 25 * reports);
    const auto bake = bakeTextures(surfaces, options, stopper.job());
    stopped = !bake.ok();
    const std::string message = stopped ? bake.error().message() : "";
    EXPECT_TRUE(!stopped || message == "transfer: cancelled") << message;
  }
  // The first three stages of a bake report some hundred times each.
  EXPECT_GT(reports, 5);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(bakeTextures(surfaces, options, {nullptr, stop.get_token()}).ok());
}

TEST(TextureBake, EmptyScenesBakeToNothing) {
  const TextureBake bake = bakeTextures(Builder().surfaces(), quick()).value();
  EXPECT_EQ(bake.transfer.size(), 0U);
}

}  // namespace
}  // namespace soffit::prt
