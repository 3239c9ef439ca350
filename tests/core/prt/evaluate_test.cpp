// SPDX-License-Identifier: MIT
#include "core/prt/evaluate.h"

#include "core/sh/analytic_light.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::prt {
namespace {

using testing::matte;

struct Baked {
  std::shared_ptr<const Surfaces> surfaces;
  std::unique_ptr<VertexReceivers> set;
  TransferRows rows;
};

Baked bakedBlock() {
  Baked b;
  b.surfaces = testing::blockOnFloor(20, {0.7F, 0.5F, 0.3F}, {0.2F, 0.6F, 0.4F}).surfaces();
  b.set = std::make_unique<VertexReceivers>(b.surfaces);
  const Directions directions(sh::hammersleySamples(256), 5);
  const auto pass = traceShadows(*b.surfaces, b.set->receivers(), directions).value();
  const auto direct = shadowedTransfer(b.set->receivers(), directions, pass.flags).value();
  b.rows = addBounces(*b.surfaces, *b.set, directions, pass.flags, direct, {}).value().transfer;
  return b;
}

sh::RgbCoefficients colored() {
  sh::RgbCoefficients light;
  for (std::size_t c = 0; c < 3; ++c) {
    light[c] = sh::analyticCoefficients({.side_azimuth = 1.0 + double(c), .scale = 100.0}, 5);
  }
  return light;
}

double relativeError(const TransferRows& rows, const sh::RgbCoefficients& light,
                     const Illuminances& found) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double wanted = testing::illuminance(rows, i, light[c], c);
      error += std::pow(double{found.channels[c][i]} - wanted, 2);
      size += wanted * wanted;
    }
  }
  return std::sqrt(error / size);
}

TEST(Evaluate, HalvesCostOneTenThousandth) {
  const Baked b = bakedBlock();
  ASSERT_EQ(b.rows.channels(), 3U);
  const TransferVectors vectors(b.rows);
  EXPECT_EQ(vectors.bytes(), TransferVectors::predictBytes(b.rows.size(), 5, 3));
  Illuminances found;
  evaluate(vectors, LightVector(colored()), found);
  ASSERT_EQ(found.size, b.rows.size());
  // Rounding of 2^-12 RMS per coefficient, 25 of which add up like random errors.
  EXPECT_LT(relativeError(b.rows, colored(), found), 2e-4);
}

TEST(Evaluate, OneChannelIsTheSameLight) {
  const auto surfaces = testing::blockOnFloor(6, vec3(0.5F), vec3(0.5F)).surfaces();
  const VertexReceivers set(surfaces);
  const TransferVectors vectors(unshadowedTransfer(set.receivers(), 3));
  const LightVector light(sh::analyticCoefficients({}, 3));
  Illuminances all;
  evaluate(vectors, light, all);
  std::vector<float> one(vectors.blockCount() * kBlock);
  evaluate(vectors, light.channels[0], one);
  for (std::size_t i = 0; i < all.size; ++i) {
    EXPECT_EQ(one[i], all.channels[0][i]);
    EXPECT_EQ(one[i], all.channels[2][i]);
  }
}

TEST(Evaluate, FewerBandsOfLightReadFewerOfTransfer) {
  const Baked b = bakedBlock();
  sh::RgbCoefficients low = colored();
  for (auto& c : low) c.resize(9);
  sh::RgbCoefficients padded = low;
  for (auto& c : padded) c.resize(25, 0.0);
  Illuminances a, z;
  const TransferVectors vectors(b.rows);
  evaluate(vectors, LightVector(low), a);
  evaluate(vectors, LightVector(padded), z);
  for (std::size_t i = 0; i < a.size; ++i) {
    EXPECT_NEAR(a.channels[1][i], z.channels[1][i], 1e-5F * (1.0F + std::abs(z.channels[1][i])));
  }
}

TEST(Evaluate, ZonesAndProbesMixTheirLight) {
  const Baked b = bakedBlock();
  const TransferVectors vectors(b.rows);
  const sh::RgbCoefficients first = colored();
  sh::RgbCoefficients second = first;
  for (auto& c : second) {
    for (double& v : c) v *= 3.0;
  }
  const std::vector<LightVector> probes{LightVector(first), LightVector(second)};
  std::vector<ProbeShares> shares(vectors.size());
  // The first blocks lie in zone 1 alone, the rest goes over to it step by step.
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const float s = i < 3 * kBlock ? 1.0F : static_cast<float>(i % 97) / 96.0F;
    shares[i].probe = {0, 1};
    shares[i].weight = {1.0F - s, s};
  }
  Illuminances one, mixed;
  evaluate(vectors, probes[0], one);
  evaluate(vectors, probes, shares, mixed);
  for (std::size_t i = 0; i < mixed.size; ++i) {
    const float scale = 1.0F + 2.0F * shares[i].weight[1];
    EXPECT_NEAR(mixed.channels[0][i], scale * one.channels[0][i],
                2e-5F * std::abs(scale * one.channels[0][i]) + 1e-3F);
  }
}

TEST(Evaluate, AVectorTakesATwentyFifthOfAMatrix) {
  // Of 25 x 25 matrices and 25-vectors the ratio is 25, where PRTT's table has 16.5; a texture of
  // 1024 x 1024 texels takes its 100 MB (MiB) in floats, half of it here.
  const std::uint64_t texture = TransferVectors::predictBytes(1024 * 1024, 5, 1);
  EXPECT_EQ(texture, 50U << 20U);
  EXPECT_EQ(TransferVectors::predictBytes(1024 * 1024, 5, 25), 25 * texture);
}

TEST(Evaluate, NothingIsAskedOfNoReceivers) {
  Illuminances out;
  evaluate(TransferVectors(TransferRows(0, 3, 1)), LightVector(sh::Coefficients(9, 1.0)), out);
  EXPECT_EQ(out.size, 0U);
}

}  // namespace
}  // namespace soffit::prt
