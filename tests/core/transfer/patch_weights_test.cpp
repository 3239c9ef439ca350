// SPDX-License-Identifier: MIT
#include "core/transfer/patch_weights.h"

#include "core/math/rng.h"
#include "core/transfer/kernels.h"
#include "core/transfer/node_kernels.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

namespace soffit::transfer {
namespace {

using namespace testing;

TEST(PatchWeights, SendWhatInterpolationAndRestrictionSend) {
  const auto baked = bake(*sceneOf(blockRoom()), smallSettings(), {}, {});
  ASSERT_TRUE(baked.ok());
  const Operators& op = **baked;
  Rng rng(5);
  std::array<std::vector<float>, 3> rho;
  for (auto& plane : rho) {
    for (std::size_t s = 0; s < op.texels.slotCount(); ++s) plane.push_back(rng.uniform());
  }
  const std::array<std::span<const float>, 3> spans = {rho[0], rho[1], rho[2]};
  const PatchWeights weights = makePatchWeights(op, spans);
  ASSERT_EQ(weights.first.size(), op.nodes.patches.size());
  std::size_t patch = 0;
  for (std::size_t i = 0; i < op.clusters.size(); ++i) {
    const light::Receivers::Cluster& c = op.texels.receivers.clusters[i];
    const ClusterWeights& cw = op.clusters[i];
    const std::size_t slots = c.end - c.begin;
    std::vector<vec4> y(cw.rank);
    // Bright enough that nothing comes out below 0, which restrictSent() cuts off.
    for (vec4& v : y) v = vec4(10.0F + rng.uniform(), 20.0F + rng.uniform(), 30.0F, 0.0F);
    std::array<std::vector<float>, 3> e;
    for (auto& plane : e) plane.assign(slots, 0.0F);
    interpolate(std::span(op.weights).subspan(cw.first_weight, cw.rank * slots), y, slots,
                e[0].data(), e[1].data(), e[2].data());
    for (; patch < op.nodes.patches.size() && op.nodes.patches[patch].begin < c.end; ++patch) {
      const Nodes::Patch& p = op.nodes.patches[patch];
      const std::size_t from = p.begin - c.begin;
      const PatchLight wanted =
          restrictSent(op.nodes, p, op.area, spans, {&e[0][from], &e[1][from], &e[2][from]});
      const PatchLight found = sentOn(weights, patch, y);
      for (std::size_t a = 0; a < 3; ++a) {
        for (int k = 0; k < 3; ++k)
          EXPECT_NEAR(found.c[a][k], wanted.c[a][k], 2e-4F)
              << a << k;  // rounding of sums of some 30 lux
      }
    }
  }
  EXPECT_EQ(patch, op.nodes.patches.size());
}

}  // namespace
}  // namespace soffit::transfer
