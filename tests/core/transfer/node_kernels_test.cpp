// SPDX-License-Identifier: MIT
// The loops over node functions against plain ones, for every instruction set.
#include "core/transfer/node_kernels.h"

#include "core/base/parallel.h"
#include "core/math/rng.h"
#include "tests/core/transfer/every_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace soffit::transfer {
namespace {

using testing::forEveryTarget;

float signedRandom(Rng& rng) {
  return 2.0F * rng.uniform() - 1.0F;
}

std::vector<PatchLight> randomLight(std::size_t patches, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<PatchLight> x(patches);
  for (PatchLight& p : x) {
    for (vec4& c : p.c) c = {signedRandom(rng), signedRandom(rng), signedRandom(rng), 0.0F};
  }
  return x;
}

/// Each pair with this probability; rows 0 and `patches - 1` are empty.
NodeMatrix randomMatrix(std::size_t patches, float density, std::uint64_t seed) {
  Rng rng(seed);
  NodeMatrix m;
  for (std::size_t i = 0; i < patches; ++i) {
    m.first.push_back(static_cast<std::uint32_t>(m.blocks.size()));
    for (std::uint32_t j = 0; j < patches && i != 0 && i + 1 != patches; ++j) {
      if (rng.uniform() > density) continue;
      NodeMatrix::Block& block = m.blocks.emplace_back();
      block.sender = j;
      for (float& v : block.value) v = signedRandom(rng);
    }
  }
  m.first.push_back(static_cast<std::uint32_t>(m.blocks.size()));
  return m;
}

TEST(MultiplyNodes, IsTheProduct) {
  forEveryTarget([] {
    for (const std::size_t patches : {1U, 2U, 7U, 300U}) {
      const NodeMatrix m = randomMatrix(patches, 0.3F, patches);
      const std::vector<PatchLight> x = randomLight(patches, 2);
      std::vector<PatchLight> y = randomLight(patches, 3);
      multiplyNodes(m, x, y);
      for (std::size_t i = 0; i < patches; ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
          dvec3 expected(0.0);
          for (std::size_t j = 0; j < patches; ++j) {
            for (std::size_t b = 0; b < 3; ++b) {
              expected += static_cast<double>(m.at(i, a, j, b)) * dvec3(x[j].c[b]);
            }
          }
          // Round-off: up to 900 products of at most 1.
          for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(static_cast<double>(y[i].c[a][c]), expected[c], 900 * 6e-8);
          }
        }
      }
    }
  });
}

TEST(MultiplyNodes, DoesNotDependOnTheNumberOfThreads) {
  const NodeMatrix m = randomMatrix(400, 0.5F, 4);
  const std::vector<PatchLight> x = randomLight(400, 5);
  const auto run = [&](int threads) {
    setThreadCount(threads);
    std::vector<PatchLight> y(400);
    multiplyNodes(m, x, y);
    setThreadCount(0);
    return y;
  };
  const auto one = run(1);
  const auto two = run(2);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].c, two[i].c);
}

TEST(MultiplyConstants, IsTheProductWithTheFirstFunctions) {
  forEveryTarget([] {
    for (const std::size_t patches : {1U, 2U, 7U, 900U}) {
      const NodeMatrix m = randomMatrix(patches, 0.4F, patches);
      const std::vector<PatchLight> x = randomLight(patches, 2);
      std::vector<vec4> constants;
      for (const PatchLight& p : x) constants.push_back(p.c[0]);
      std::vector<vec4> y(patches, vec4(7.0F));
      multiplyConstants(constantsOf(m), constants, y);
      for (std::size_t i = 0; i < patches; ++i) {
        dvec3 expected(0.0);
        for (std::uint32_t k = m.first[i]; k < m.first[i + 1]; ++k) {
          expected +=
              static_cast<double>(m.blocks[k].value[0]) * dvec3(constants[m.blocks[k].sender]);
        }
        for (int c = 0; c < 3; ++c) {
          EXPECT_NEAR(static_cast<double>(y[i][c]), expected[c], 900 * 6e-8);
        }
      }
    }
  });
}

TEST(RestrictSent, IsTheMomentsOfWhatIsReflected) {
  forEveryTarget([] {
    for (const std::uint32_t slots : {16U, 48U, 128U}) {
      Rng rng(slots);
      const std::uint32_t begin = 32;
      const std::uint32_t all = begin + slots;
      Nodes nodes;
      nodes.phi.resize(all);
      std::vector<float> area(all);
      std::array<std::vector<float>, 3> rho;
      std::array<std::vector<float>, 3> e;
      for (std::uint32_t s = 0; s < all; ++s) {
        nodes.phi[s] = {signedRandom(rng), signedRandom(rng)};
        area[s] = s % 5 == 0 ? 0.0F : rng.uniform();
        for (std::size_t c = 0; c < 3; ++c) {
          rho[c].push_back(rng.uniform());
          e[c].push_back(signedRandom(rng));  // weights may make it negative
        }
      }
      const Nodes::Patch patch{.begin = begin, .end = all, .count = 3, .area = 2.5};
      const PatchLight found = restrictSent(nodes, patch, area, {rho[0], rho[1], rho[2]},
                                            {&e[0][begin], &e[1][begin], &e[2][begin]});
      for (std::size_t c = 0; c < 3; ++c) {
        std::array<double, 3> expected{};
        for (std::uint32_t s = begin; s < all; ++s) {
          const double sent = static_cast<double>(area[s]) * static_cast<double>(rho[c][s]) *
                              std::max(0.0, static_cast<double>(e[c][s])) / patch.area;
          expected[0] += sent;
          expected[1] += sent * static_cast<double>(nodes.phi[s].x);
          expected[2] += sent * static_cast<double>(nodes.phi[s].y);
        }
        for (std::size_t a = 0; a < 3; ++a) {
          EXPECT_NEAR(static_cast<double>(found.c[a][static_cast<int>(c)]), expected[a],
                      128 * 6e-8);
        }
      }
    }
  });
  // Nothing is divided by an area of 0.
  const Nodes::Patch none{.begin = 0, .end = 16, .count = 1, .area = 0.0};
  EXPECT_EQ(restrictSent({}, none, {}, {}, {}).c[0], vec4(0.0F));
}

}  // namespace
}  // namespace soffit::transfer
