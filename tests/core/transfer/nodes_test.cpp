// SPDX-License-Identifier: MIT
// Nodes, their transfer matrix and the solver on top of it.
#include "core/transfer/nodes.h"

#include "core/transfer/node_solver.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

struct Coarse {
  std::shared_ptr<const StaticScene> scene;
  Texels texels;
  Nodes nodes;
};

/// blockRoom() to its node matrix, 8 x 8 rays a texel.
const Coarse& coarse() {
  static const Coarse c = [] {
    Coarse out{sceneOf(blockRoom()), {}, {}};
    out.texels = makeTexels(*out.scene->mesh, out.scene->sides, 0.15, &out.scene->caster);
    out.nodes = makeNodes(out.texels, out.texels.area, 64);
    fillNodeMatrix(out.nodes, out.texels.area, firstHits(*out.scene, out.texels, 8), 64);
    return out;
  }();
  return c;
}

double phi(const Nodes& nodes, std::uint32_t slot, std::uint32_t function) {
  if (function == 0) return 1.0;
  return static_cast<double>(function == 1 ? nodes.phi[slot].x : nodes.phi[slot].y);
}

TEST(Nodes, PatchesPartTheSlotsAndTheirFunctionsAreOrthonormal) {
  const Nodes& nodes = coarse().nodes;
  const std::vector<float>& area = coarse().texels.area;
  std::size_t functions = 0;
  std::uint32_t next = 0;
  for (std::size_t k = 0; k < nodes.patches.size(); ++k) {
    const Nodes::Patch& p = nodes.patches[k];
    EXPECT_EQ(p.begin, next);
    EXPECT_LE(p.end - p.begin, 64U);
    EXPECT_EQ(p.first, functions);
    functions += p.count;
    next = p.end;
    for (std::uint32_t a = 0; a < p.count; ++a) {
      for (std::uint32_t b = 0; b <= a; ++b) {
        double product = 0.0;
        for (std::uint32_t s = p.begin; s < p.end; ++s) {
          EXPECT_EQ(nodes.patch_of[s], k);
          product += static_cast<double>(area[s]) * phi(nodes, s, a) * phi(nodes, s, b);
        }
        // Sums of at most 64 products in single precision.
        EXPECT_NEAR(product / p.area, a == b ? 1.0 : 0.0, 1e-5);
      }
    }
  }
  EXPECT_EQ(next, coarse().texels.slotCount());
  EXPECT_EQ(functions, nodes.functions);
  EXPECT_EQ(nodes.stride % 16, 0U);
  EXPECT_GE(nodes.stride, nodes.functions);
}

TEST(Nodes, RestrictingWhatWasProlongedGivesItBack) {
  const Nodes& nodes = coarse().nodes;
  std::vector<float> c(nodes.stride, 0.0F);
  for (std::size_t f = 0; f < nodes.functions; ++f)
    c[f] = 1.0F + 0.3F * std::sin(static_cast<float>(f));
  std::vector<float> value(coarse().texels.slotCount());
  prolongFromNodes(nodes, c, value);
  std::vector<float> back(nodes.stride, 0.0F);
  restrictToNodes(nodes, coarse().texels.area, value, back);
  for (std::size_t f = 0; f < nodes.functions; ++f) EXPECT_NEAR(back[f], c[f], 1e-4F) << f;
}

TEST(Nodes, ALinearFieldOnAFlatPatchIsExact) {
  const Nodes& nodes = coarse().nodes;
  const Texels& texels = coarse().texels;
  std::vector<float> value(texels.slotCount());
  for (std::size_t s = 0; s < value.size(); ++s) {
    value[s] = 2.0F + glm::dot(vec3(0.3F, -0.2F, 0.5F), texels.receivers.position(s));
  }
  std::vector<float> c(nodes.stride, 0.0F);
  restrictToNodes(nodes, texels.area, value, c);
  std::vector<float> back(value.size());
  prolongFromNodes(nodes, c, back);
  for (const Nodes::Patch& p : nodes.patches) {
    if (p.count < 3) continue;
    const vec3 n = texels.receivers.normal(p.begin);
    bool flat = true;
    for (std::uint32_t s = p.begin; s < p.end; ++s) {
      flat = flat && glm::dot(n, texels.receivers.normal(s)) > 0.9999F &&
             std::abs(glm::dot(
                 n, texels.receivers.position(s) - texels.receivers.position(p.begin))) < 1e-4F;
    }
    if (!flat) continue;
    for (std::uint32_t s = p.begin; s < p.end; ++s) EXPECT_NEAR(back[s], value[s], 1e-4F);
  }
}

std::size_t indexOf(const Nodes::Patch& patch) {
  return static_cast<std::size_t>(&patch - coarse().nodes.patches.data());
}

TEST(NodeMatrix, UniformLightStaysUniformAndNoneIsLost) {
  const Nodes& nodes = coarse().nodes;
  // The void beyond is closed off: every surface sees radiosity 1, so receives 1.
  std::vector<double> arrived(nodes.functions, 0.0);
  for (const Nodes::Patch& p : nodes.patches) {
    if (p.area <= 0.0) continue;
    double e = 0.0;
    for (const Nodes::Patch& q : nodes.patches)
      e += static_cast<double>(nodes.matrix.at(indexOf(p), 0, indexOf(q), 0));
    // 64 rays from each of some 30 texels: noise of N^-3/4 per texel, averaged; conservation moves
    // rows by as much.
    EXPECT_NEAR(e, 1.0, 0.06);
    for (const Nodes::Patch& q : nodes.patches) {
      for (std::uint32_t b = 0; b < q.count; ++b) {
        arrived[q.first + b] +=
            p.area * static_cast<double>(nodes.matrix.at(indexOf(p), 0, indexOf(q), b));
      }
    }
  }
  for (const Nodes::Patch& q : nodes.patches) {
    if (q.area <= 0.0) continue;
    EXPECT_NEAR(arrived[q.first] / q.area, 1.0, 1e-4);  // single precision sums
  }
}

TEST(NodeMatrix, FormFactorsAreReciprocal) {
  const Nodes& nodes = coarse().nodes;
  double difference = 0.0;
  double whole = 0.0;
  for (const Nodes::Patch& p : nodes.patches) {
    for (const Nodes::Patch& q : nodes.patches) {
      const double there =
          p.area * static_cast<double>(nodes.matrix.at(indexOf(p), 0, indexOf(q), 0));
      const double back =
          q.area * static_cast<double>(nodes.matrix.at(indexOf(q), 0, indexOf(p), 0));
      difference += std::abs(there - back);
      whole += 0.5 * (there + back);
    }
  }
  // Both directions come from rays of their own; their noise is per pair of patches.
  EXPECT_LT(difference, 0.1 * whole);
}

/// e = F (b0 + M e) by iteration in double precision, with all functions and texel reflectances.
std::vector<double> solvedDense(const std::vector<float>& b0, const std::vector<float>& rho) {
  const Nodes& nodes = coarse().nodes;
  const std::vector<float>& area = coarse().texels.area;
  std::vector<double> e(nodes.functions, 0.0);
  for (int bounce = 0; bounce < 200; ++bounce) {
    std::vector<double> b(nodes.functions, 0.0);
    for (const Nodes::Patch& p : nodes.patches) {
      if (p.area <= 0.0) continue;
      for (std::uint32_t s = p.begin; s < p.end; ++s) {
        double value = 0.0;
        for (std::uint32_t a = 0; a < p.count; ++a) value += e[p.first + a] * phi(nodes, s, a);
        const double share =
            static_cast<double>(area[s]) * static_cast<double>(rho[s]) * value / p.area;
        for (std::uint32_t a = 0; a < p.count; ++a) b[p.first + a] += share * phi(nodes, s, a);
      }
    }
    for (std::size_t i = 0; i < nodes.patches.size(); ++i) {
      const Nodes::Patch& p = nodes.patches[i];
      for (std::uint32_t a = 0; a < p.count; ++a) e[p.first + a] = 0.0;
      for (std::uint32_t k = nodes.matrix.first[i]; k < nodes.matrix.first[i + 1]; ++k) {
        const NodeMatrix::Block& block = nodes.matrix.blocks[k];
        const Nodes::Patch& q = nodes.patches[block.sender];
        for (std::uint32_t a = 0; a < p.count; ++a) {
          for (std::uint32_t c = 0; c < q.count; ++c) {
            e[p.first + a] += static_cast<double>(block.value[3 * a + c]) *
                              (static_cast<double>(b0[q.first + c]) + b[q.first + c]);
          }
        }
      }
    }
  }
  return e;
}

TEST(NodeSolver, AgreesWithADenseSolutionOfAllBounces) {
  const Nodes& nodes = coarse().nodes;
  const Texels& texels = coarse().texels;
  const std::size_t slots = texels.slotCount();
  // Three channels, one of them dark; light on the floor near a corner.
  std::array<std::vector<float>, 3> rho;
  const std::array<float, 3> wall = {0.8F, 0.5F, 0.1F};
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t s = 0; s < slots; ++s)
      rho[c].push_back(texels.material[s] == 0 ? wall[c] : 0.3F);
  }
  std::vector<float> lit(slots, 0.0F);
  for (std::size_t s = 0; s < slots; ++s) {
    const vec3 p = texels.receivers.position(s);
    if (texels.receivers.normal(s).z > 0.5F && p.x < 1.5F && p.y < 1.5F) lit[s] = 100.0F;
  }
  const std::array<std::span<const float>, 3> channels = {rho[0], rho[1], rho[2]};
  const NodeSolver solver(nodes, texels.area, channels);
  NodeSolver::Vectors b0(3, std::vector<float>(nodes.stride, 0.0F));
  NodeSolver::Vectors e;
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<float> x(slots);
    for (std::size_t s = 0; s < slots; ++s) x[s] = rho[c][s] * lit[s];
    restrictToNodes(nodes, texels.area, x, b0[c]);
  }
  solver.solve(b0, e);
  ASSERT_EQ(e.size(), 3U);
  for (std::size_t c = 0; c < 3; ++c) {
    const std::vector<double> expected = solvedDense(b0[c], rho[c]);
    double square = 0.0;
    double norm = 0.0;
    double found_flux = 0.0;
    double expected_flux = 0.0;
    for (const Nodes::Patch& p : nodes.patches) {
      for (std::uint32_t a = 0; a < p.count; ++a) {
        const double d = static_cast<double>(e[c][p.first + a]) - expected[p.first + a];
        square += p.area * d * d;
        norm += p.area * expected[p.first + a] * expected[p.first + a];
      }
      found_flux += p.area * static_cast<double>(e[c][p.first]);
      expected_flux += p.area * expected[p.first];
    }
    // Truncation: from the third bounce on patches of 1.2 m are constant, which loses their slope;
    // less of the light is that old where walls are darker.
    EXPECT_LT(std::sqrt(square / norm), 0.05 * static_cast<double>(wall[c])) << c;
    EXPECT_NEAR(found_flux, expected_flux, 2e-3 * expected_flux) << c;
  }
}

TEST(NodeSolver, ReflectsTexelByTexel) {
  const Nodes& nodes = coarse().nodes;
  const Texels& texels = coarse().texels;
  std::vector<float> rho(texels.slotCount());
  for (std::size_t s = 0; s < rho.size(); ++s)
    rho[s] = 0.5F + 0.4F * std::sin(static_cast<float>(3 * s));
  const std::span<const float> channel(rho);
  const NodeSolver solver(nodes, texels.area, std::span(&channel, 1));
  std::vector<float> e(nodes.stride, 0.0F);
  for (std::size_t f = 0; f < nodes.functions; ++f)
    e[f] = 1.0F + 0.5F * std::cos(static_cast<float>(f));
  const std::vector<PatchLight> received = toPatches(nodes, {e});
  std::vector<PatchLight> sent(received.size());
  solver.reflect(received, sent);
  NodeSolver::Vectors found(1);
  fromPatches(nodes, sent, found);
  std::vector<float> value(rho.size());
  prolongFromNodes(nodes, e, value);
  for (std::size_t s = 0; s < rho.size(); ++s) value[s] *= rho[s];
  std::vector<float> expected(nodes.stride, 0.0F);
  restrictToNodes(nodes, texels.area, value, expected);
  for (std::size_t f = 0; f < nodes.functions; ++f) EXPECT_NEAR(found[0][f], expected[f], 1e-4F);
}

}  // namespace
}  // namespace soffit::transfer
