// SPDX-License-Identifier: MIT
#include "core/transfer/linear_solver.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace soffit::transfer {
namespace {

/// A closed room of n patches: rows sum to 1 before noise, lane c reflects rho[c].
struct Room {
  std::size_t n;
  std::vector<float> f;
  glm::vec4 rho;
  void operator()(std::span<const vec4> x, std::span<vec4> y) const {
    for (std::size_t i = 0; i < n; ++i) {
      vec4 sum(0.0F);
      for (std::size_t j = 0; j < n; ++j) sum += f[i * n + j] * x[j];
      y[i] = rho * sum;
    }
  }
};

/// Two rooms joined by a door; form factors with noise, so not symmetric.
Room roomOf(std::size_t n, const vec4& rho) {
  Rng rng(5);
  Room room{n, std::vector<float>(n * n), rho};
  for (std::size_t i = 0; i < n; ++i) {
    float sum = 0.0F;
    for (std::size_t j = 0; j < n; ++j) {
      const bool same = (i < n / 2) == (j < n / 2);
      room.f[i * n + j] = (same ? 1.0F : 0.02F) * (0.2F + rng.uniform());
      sum += room.f[i * n + j];
    }
    for (std::size_t j = 0; j < n; ++j) room.f[i * n + j] /= sum;
  }
  return room;
}

std::vector<vec4> randomLight(std::size_t n) {
  Rng rng(6);
  std::vector<vec4> g(n);
  for (vec4& v : g) v = {rng.uniform(), rng.uniform(), 100.0F * rng.uniform(), 0.0F};
  return g;
}

TEST(SolveLanes, SolvesEachLaneByItself) {
  const std::size_t n = 60;
  const Room room = roomOf(n, {0.3F, 0.7F, 0.95F, 0.0F});
  const std::vector<vec4> g = randomLight(n);
  std::vector<vec4> x(n);
  const int products = solveLanes(room, g, x, 2e-6);
  EXPECT_LT(products, 30);
  for (int c = 0; c < 3; ++c) {
    std::vector<double> sum(n, 0.0);  // the Neumann series in double precision
    for (int bounce = 0; bounce < 1000; ++bounce) {
      std::vector<double> next(n);
      for (std::size_t i = 0; i < n; ++i) {
        next[i] = static_cast<double>(g[i][c]);
        for (std::size_t j = 0; j < n; ++j) {
          next[i] += static_cast<double>(room.rho[c] * room.f[i * n + j]) * sum[j];
        }
      }
      sum = next;
    }
    for (std::size_t i = 0; i < n; ++i) {
      // The residual, amplified by up to 1 / (1 - rho).
      EXPECT_NEAR(static_cast<double>(x[i][c]), sum[i], 1e-4 * sum[i]) << c << ' ' << i;
    }
  }
}

TEST(SolveLanes, DarkAndUnreflectingLanesNeedNothing) {
  const Room room = roomOf(8, vec4(0.0F));
  std::vector<vec4> g(8, vec4(0.0F));
  std::vector<vec4> x(8, vec4(9.0F));
  EXPECT_EQ(solveLanes(room, g, x, 2e-6), 1);
  for (const vec4& v : x) EXPECT_EQ(v, vec4(0.0F));
  g.assign(8, vec4(3.0F));
  EXPECT_EQ(solveLanes(room, g, x, 2e-6), 1);
  for (const vec4& v : x) EXPECT_EQ(v, vec4(3.0F));
  EXPECT_EQ(solveLanes(roomOf(0, vec4(0.5F)), {}, {}, 2e-6), 1);
}

TEST(SolveLanes, EndsWhereNoLightIsLost) {
  const Room room = roomOf(20, vec4(1.0F));  // no solution
  const std::vector<vec4> g(20, vec4(1.0F));
  std::vector<vec4> x(20);
  EXPECT_LE(solveLanes(room, g, x, 2e-6, 60), 121);
}

}  // namespace
}  // namespace soffit::transfer
