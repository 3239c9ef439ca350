// SPDX-License-Identifier: MIT
#include "core/prt/bounces.h"

#include "core/base/parallel.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::evenLight;
using testing::illuminance;
using testing::matte;

/// A shut room whose receivers all start with the same row.
struct Furnace {
  std::shared_ptr<const Surfaces> surfaces;
  std::unique_ptr<VertexReceivers> set;
  Directions directions{sh::hammersleySamples(400), 3};
  VisibilityFlags flags;
  TransferRows start;

  explicit Furnace(const vec3& rho,
                   const geometry::Mesh& room = geometry::makeBox(vec3(0.0F), vec3(4, 3, 2.5F))) {
    surfaces = Builder().add(room, matte(rho)).surfaces({room.bounds().center()});
    set = std::make_unique<VertexReceivers>(surfaces);
    flags = traceShadows(*surfaces, set->receivers(), directions).value().flags;
    start = TransferRows(set->receivers().size(), 3, 1);
    for (std::size_t i = 0; i < start.size(); ++i) {
      for (std::size_t k = 0; k < 9; ++k) start.row(i)[k] = 1.0F - 0.2F * static_cast<float>(k);
    }
  }
  [[nodiscard]] BouncedTransfer bounce(const BounceOptions& options = {}) const {
    return addBounces(*surfaces, *set, directions, flags, start, options).value();
  }
};

TEST(Bounces, AFurnaceTakesThePassesOfItsReflectance) {
  const struct {
    float rho;
    std::size_t passes;
  } cases[] = {{0.5F, 14}, {0.7F, 26}, {0.8F, 42}};
  for (const auto& c : cases) {
    const BouncedTransfer out = Furnace(vec3(c.rho)).bounce();
    EXPECT_TRUE(out.converged);
    EXPECT_EQ(out.passes.size(), c.passes + 1);
    EXPECT_EQ(out.transfer.channels(), 1U);
    // 1 / (1 - rho), less what the threshold leaves out: rho / (1 - rho) 1e-4 of it at most.
    const double wanted = 1.0 / (1.0 - double{c.rho});
    for (std::size_t i = 0; i < out.transfer.size(); ++i) {
      EXPECT_NEAR(out.transfer.row(i)[0], wanted, 1.1e-4 * wanted);
      EXPECT_NEAR(out.transfer.row(i)[3], 0.4 * wanted, 1.1e-4 * wanted);
    }
  }
}

TEST(Bounces, ThreeOrFourPassesAreNotEnough) {
  // Fujita & Kanai's number of passes leaves rho^(k+1) of the light out.
  const struct {
    float rho;
    double missing;
  } cases[] = {{0.5F, 0.03}, {0.7F, 0.17}, {0.8F, 0.33}};
  for (const auto& c : cases) {
    const BouncedTransfer out = Furnace(vec3(c.rho)).bounce({.most_passes = 4});
    EXPECT_FALSE(out.converged);
    const double share = double{out.transfer.row(0)[0]} * (1.0 - double{c.rho});
    EXPECT_NEAR(1.0 - share, std::pow(double{c.rho}, 5), 1e-4);
    EXPECT_NEAR(1.0 - share, c.missing, 0.005);
  }
}

TEST(Bounces, EnergiesFallByTheReflectance) {
  const BouncedTransfer out = Furnace(vec3(0.6F)).bounce();
  for (std::size_t k = 1; k < out.passes.size(); ++k) {
    EXPECT_NEAR(out.passes[k].energy / out.passes[k - 1].energy, 0.6, 1e-4) << k;
  }
  EXPECT_GT(out.passes[1].rays, 0U);
  EXPECT_EQ(out.passes[2].rays, 0U);  // kept
  EXPECT_EQ(out.rays, out.passes[1].rays);
}

TEST(Bounces, ColorsBounceOnTheirOwn) {
  const BouncedTransfer out = Furnace({0.8F, 0.5F, 0.1F}).bounce();
  ASSERT_EQ(out.transfer.channels(), 3U);
  EXPECT_NEAR(out.transfer.vector(5, 0)[0], 5.0, 5e-3);
  EXPECT_NEAR(out.transfer.vector(5, 1)[0], 2.0, 5e-3);
  EXPECT_NEAR(out.transfer.vector(5, 2)[0], 1.0 / 0.9, 5e-3);
}

TEST(Bounces, KeptOrTracedAgainIsTheSame) {
  const Furnace furnace(vec3(0.7F), geometry::makeSphere(vec3(0), 2.0F, 10));
  const BouncedTransfer kept = furnace.bounce();
  const BouncedTransfer traced = furnace.bounce({.keep_bytes = 1000});
  EXPECT_GT(kept.kept_bytes, 0U);
  EXPECT_EQ(traced.kept_bytes, 0U);
  EXPECT_EQ(traced.rays, kept.rays * (traced.passes.size() - 1));
  for (std::size_t i = 0; i < kept.transfer.size(); ++i) {
    for (std::size_t k = 0; k < 9; ++k) {
      // Equal but for the order of sums in single precision, over 26 passes.
      const float wanted = kept.transfer.row(i)[k];
      EXPECT_NEAR(wanted, traced.transfer.row(i)[k], 1e-5F * (1.0F + std::abs(wanted)));
    }
  }
}

TEST(Bounces, ThreadsChangeNothing) {
  const Furnace furnace({0.7F, 0.2F, 0.3F});
  const BouncedTransfer all = furnace.bounce();
  setThreadCount(1);
  const BouncedTransfer one = furnace.bounce();
  setThreadCount(0);
  EXPECT_EQ(all.passes.back().energy, one.passes.back().energy);
  for (std::size_t i = 0; i < all.transfer.size(); ++i) {
    EXPECT_EQ(all.transfer.row(i)[0], one.transfer.row(i)[0]);
  }
}

TEST(Bounces, WhiteThingsUnderAnEvenSkyAllRoundAreFurnacesToo) {
  // Where L = 1 everywhere and nothing absorbs, L = 1 stays: every receiver has pi lux.
  const auto surfaces = testing::blockOnFloor(24, vec3(1.0F), vec3(1.0F)).surfaces();
  VertexReceivers set(surfaces);
  set.replaceInvalid(findUncovered(*surfaces, set.receivers()).value());
  const Directions directions(sh::hammersleySamples(1024), 3);
  const auto pass = traceShadows(*surfaces, set.receivers(), directions).value();
  const auto direct = shadowedTransfer(set.receivers(), directions, pass.flags).value();
  const auto out =
      addBounces(*surfaces, set, directions, pass.flags, direct, {.threshold = 1e-5}).value();
  EXPECT_TRUE(out.converged);
  for (std::size_t i = 0; i < out.transfer.size(); ++i) {
    EXPECT_NEAR(illuminance(out.transfer, i, evenLight(3)), kPi, 0.01 * kPi);
    EXPECT_LE(illuminance(direct, i, evenLight(3)), kPi * 1.00001);
  }
}

TEST(Bounces, ConvexThingsGetNone) {
  const auto surfaces =
      Builder().add(geometry::makeSphere(vec3(0), 1.0F, 12), matte(vec3(0.8F))).surfaces();
  const VertexReceivers set(surfaces);
  const Directions directions(sh::stratifiedSamples(20, 1), 3);
  const auto pass = traceShadows(*surfaces, set.receivers(), directions).value();
  EXPECT_EQ(pass.flags.countBlocked(3), 0U);
  const auto direct = shadowedTransfer(set.receivers(), directions, pass.flags).value();
  const auto out = addBounces(*surfaces, set, directions, pass.flags, direct, {}).value();
  EXPECT_EQ(out.passes.size(), 2U);
  EXPECT_EQ(out.rays, 0U);
  EXPECT_EQ(out.transfer.row(3)[0], direct.row(3)[0]);
}

TEST(Bounces, ALastGatherIsOneMorePass) {
  const Furnace furnace(vec3(0.5F));
  const BouncedTransfer solved = furnace.bounce({.threshold = 1e-6});
  const auto out =
      gatherBounce(*furnace.surfaces, *furnace.set, solved.transfer, furnace.set->receivers(),
                   furnace.directions, furnace.flags, furnace.start)
          .value();
  for (std::size_t i = 0; i < furnace.start.size(); ++i) {
    EXPECT_NEAR(out.transfer.row(i)[0], 2.0, 1e-5);
  }
}

TEST(Bounces, StopWhenAskedBetweenReceivers) {
  const Furnace furnace(vec3(0.9F));
  std::stop_source stop;
  stop.request_stop();
  const auto out = addBounces(*furnace.surfaces, *furnace.set, furnace.directions, furnace.flags,
                              furnace.start, {}, {nullptr, stop.get_token()});
  EXPECT_FALSE(out.ok());
}

}  // namespace
}  // namespace soffit::prt
