// SPDX-License-Identifier: MIT
// What the bake leaves behind: skeleton points, weights and the training that chose them.
#include "core/transfer/skeleton.h"

#include "core/transfer/far_blocks.h"

#include "core/transfer/kernels.h"
#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

BakeSettings settings() {
  BakeSettings s = smallSettings();
  s.texels = 3000;
  s.trainings = 32;
  s.field_rays = 16;
  s.list_rays = 24;
  s.max_rank = 12;
  s.tolerance = 0.05;
  return s;
}

std::shared_ptr<const Operators> baked(const BakeSettings& s) {
  const auto result = bake(*sceneOf(blockRoom()), s, {}, {});
  EXPECT_TRUE(result.ok());
  return *result;
}

const Operators& ordinary() {
  static const auto operators = baked(settings());
  return *operators;
}

/// Light at all slots that the skeletons give for radiosity x: W gather(x).
std::vector<float> spread(const Operators& op, std::vector<vec4> x) {
  const FarBlocks blocks(op.texels, op.area);
  x.resize(blocks.size());
  blocks.average(0, blocks.slotCount(), x);
  std::vector<vec4> y(op.lists.lists.size());
  gather(op.lists, 0, x, y);
  std::vector<float> out(op.texels.slotCount(), 0.0F);
  std::vector<float> rest(op.texels.slotCount(), 0.0F);
  for (std::size_t k = 0; k < op.clusters.size(); ++k) {
    const light::Receivers::Cluster& c = op.texels.receivers.clusters[k];
    const ClusterWeights& w = op.clusters[k];
    const std::size_t slots = c.end - c.begin;
    interpolate(std::span(op.weights).subspan(w.first_weight, w.rank * slots),
                std::span(y).subspan(w.first_list, w.rank), slots, &out[c.begin], &rest[c.begin],
                &rest[c.begin]);
  }
  return out;
}

TEST(Skeleton, EveryClusterHasAPointAndNoneMoreThanAllowed) {
  const Operators& op = ordinary();
  ASSERT_EQ(op.clusters.size(), op.texels.receivers.clusters.size());
  std::uint32_t lists = 0;
  for (std::size_t k = 0; k < op.clusters.size(); ++k) {
    EXPECT_EQ(op.clusters[k].first_list, lists);
    lists += op.clusters[k].rank;
    EXPECT_LE(op.clusters[k].rank, 12U);
    const light::Receivers::Cluster& c = op.texels.receivers.clusters[k];
    float area = 0.0F;
    for (std::uint32_t s = c.begin; s < c.end; ++s) area += op.area[s];
    if (area <= 0.0F) continue;
    EXPECT_GE(op.clusters[k].rank, 1U);
  }
  EXPECT_EQ(lists, op.lists.lists.size());
  EXPECT_EQ(op.list_area.size(), op.lists.lists.size());
}

TEST(Skeleton, UniformLightComesOutUniform) {
  const Operators& op = ordinary();
  // Every ray of a closed room meets radiosity 1.
  const std::vector<float> e = spread(op, std::vector<vec4>(op.texels.slotCount(), vec4(1.0F)));
  double square = 0.0;
  double area = 0.0;
  for (std::size_t s = 0; s < e.size(); ++s) {
    if (op.area[s] <= 0.0F) continue;
    const double d = static_cast<double>(e[s]) - 1.0;
    square += static_cast<double>(op.area[s]) * d * d;
    area += static_cast<double>(op.area[s]);
    // Weights are fitted to training fields within a tolerance of 2 % of their mean, by 12 points
    // at most; single texels in corners are further off.
    EXPECT_NEAR(e[s], 1.0F, 0.4F) << s;
  }
  EXPECT_LT(std::sqrt(square / area), 0.04);
}

TEST(Skeleton, SmoothLightIsThatOfTheTexelsOwnRays) {
  const Operators& op = ordinary();
  const auto scene = sceneOf(blockRoom());
  // A field that training never saw: brighter toward one corner.
  std::vector<vec4> x(op.texels.slotCount());
  for (std::size_t s = 0; s < x.size(); ++s) {
    const vec3 p = op.texels.receivers.position(s);
    x[s] = vec4(std::exp(-0.5F * glm::dot(p - vec3(0.5F), p - vec3(0.5F))));
  }
  const std::vector<float> e = spread(op, x);
  HemisphereScratch scratch;
  HemisphereHits hits;
  double square = 0.0;
  double mean = 0.0;
  int n = 0;
  for (std::size_t s = 0; s < x.size(); s += 13) {
    if (op.area[s] <= 0.0F) continue;
    traceHemisphere(*scene, op.texels, op.texels.receivers.position(s),
                    op.texels.receivers.normal(s), 32, 99 + s, 0.0F, scratch, hits);
    double own = 0.0;
    for (const std::uint32_t slot : hits.slots)
      own += slot == kNoTexel ? 0.0 : static_cast<double>(x[slot].x);
    own /= static_cast<double>(hits.slots.size());
    square += (static_cast<double>(e[s]) - own) * (static_cast<double>(e[s]) - own);
    mean += own;
    ++n;
  }
  // Interpolation by 12 points at most, 576 rays each, trained by 32 lights; measured: 0.10.
  EXPECT_LT(std::sqrt(square / n) / (mean / n), 0.15);
}

TEST(Skeleton, ListAreasAreSumsOfAreaTimesWeight) {
  const Operators& op = ordinary();
  for (std::size_t k = 0; k < op.clusters.size(); ++k) {
    const light::Receivers::Cluster& c = op.texels.receivers.clusters[k];
    const std::uint32_t slots = c.end - c.begin;
    for (std::uint32_t r = 0; r < op.clusters[k].rank; ++r) {
      double expected = 0.0;
      double scale = 0.0;
      for (std::uint32_t s = 0; s < slots; ++s) {
        const double term =
            static_cast<double>(op.area[c.begin + s]) *
            static_cast<double>(op.weights[op.clusters[k].first_weight + r * slots + s]);
        expected += term;
        scale += std::abs(term);
      }
      // Weights are rounded to 2^-11 of themselves after the sum was taken.
      EXPECT_NEAR(static_cast<double>(op.list_area[op.clusters[k].first_list + r]), expected,
                  0x1p-11 * scale + 1e-7);
    }
  }
}

TEST(Skeleton, ACoarserToleranceNeedsFewerPoints) {
  BakeSettings coarse = settings();
  coarse.tolerance = 0.5;
  EXPECT_LT(baked(coarse)->lists.lists.size(), ordinary().lists.lists.size());
}

TEST(Bake, IsTheSameEveryTimeAndOtherwiseWithAnotherSeed) {
  const auto again = baked(settings());
  EXPECT_EQ(again->weights, ordinary().weights);
  EXPECT_EQ(again->list_area, ordinary().list_area);
  ASSERT_EQ(again->nodes.matrix.blocks.size(), ordinary().nodes.matrix.blocks.size());
  for (std::size_t k = 0; k < again->nodes.matrix.blocks.size(); ++k) {
    EXPECT_EQ(again->nodes.matrix.blocks[k].value, ordinary().nodes.matrix.blocks[k].value);
  }
  BakeSettings other = settings();
  other.seed = 2;
  EXPECT_NE(baked(other)->weights, ordinary().weights);
}

TEST(Bake, StopsWhenItIsToldTo) {
  std::stop_source stop;
  stop.request_stop();
  const auto result = bake(*sceneOf(blockRoom()), settings(), {nullptr, stop.get_token()}, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().what, "cancelled");
}

TEST(Bake, TheCoarseResultComesFirst) {
  int calls = 0;
  const auto result = bake(*sceneOf(blockRoom()), settings(), {},
                           [&](const std::shared_ptr<const Operators>& coarse) {
                             ++calls;
                             EXPECT_TRUE(coarse->coarse);
                             EXPECT_GT(coarse->nodes.functions, 0U);
                             EXPECT_TRUE(coarse->lists.lists.empty());
                           });
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE((*result)->coarse);
}

TEST(Bake, OfManyTexelsFewComeFirst) {
  std::vector<std::size_t> counts;
  std::stop_source stop;
  BakeSettings many = settings();
  many.texels = 40000;
  many.least_cell = 0.01;
  const auto result =
      bake(*sceneOf(blockRoom()), many, {nullptr, stop.get_token()}, [&](const auto& coarse) {
        EXPECT_TRUE(coarse->coarse);
        counts.push_back(coarse->texels.texelCount());
        if (counts.size() == 2) stop.request_stop();
      });
  EXPECT_FALSE(result.ok());
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_LT(3 * counts[0], counts[1]);
  EXPECT_GT(counts[0], 8000U);
}

TEST(Training, FieldsAreDeterministicFiniteAndOfMeanOne) {
  const auto scene = sceneOf(blockRoom());
  Operators op;
  op.texels = makeTexels(*scene->mesh, scene->sides, 0.2, &scene->caster);
  op.area = op.texels.area;
  op.fill_from.resize(op.area.size());
  op.buried.assign(op.area.size(), 0);
  for (std::uint32_t s = 0; s < op.fill_from.size(); ++s) {
    op.fill_from[s] = op.texels.receivers.slot_of[op.texels.receivers.point_of[s]];
  }
  const auto hits = firstHits(*scene, op.texels, 4);
  op.nodes = makeNodes(op.texels, op.area, 64);
  fillNodeMatrix(op.nodes, op.area, hits, 16);
  BakeSettings s = settings();
  s.node_rays = 4;
  const TrainingFields a = makeTrainingFields(*scene, op, hits, 16, s, {});
  const TrainingFields b = makeTrainingFields(*scene, op, hits, 16, s, {});
  EXPECT_EQ(a.value, b.value);
  ASSERT_EQ(a.count, s.trainings);
  ASSERT_EQ(a.value.size(), FarBlocks::sizeFor(op.area.size()) * static_cast<std::size_t>(a.count));
  const auto count = static_cast<std::size_t>(a.count);
  double area = 0.0;
  std::vector<double> mean(count, 0.0);
  for (std::size_t slot = 0; slot < op.area.size(); ++slot) {
    area += static_cast<double>(op.area[slot]);
    for (std::size_t t = 0; t < count; ++t) {
      const float v = a.value[slot * count + t];
      ASSERT_TRUE(std::isfinite(v));
      ASSERT_GE(v, 0.0F);
      mean[t] += static_cast<double>(op.area[slot]) * static_cast<double>(v);
    }
  }
  // Single precision. The last field is even light, of three times the others' weight.
  for (std::size_t t = 0; t + 1 < count; ++t) EXPECT_NEAR(mean[t] / area, 1.0, 1e-4);
  for (std::size_t slot = 0; slot < op.area.size(); ++slot)
    ASSERT_EQ(a.value[slot * count + count - 1], 3.0F);
  s.seed = 9;
  EXPECT_NE(makeTrainingFields(*scene, op, hits, 16, s, {}).value, a.value);
}

}  // namespace
}  // namespace soffit::transfer
