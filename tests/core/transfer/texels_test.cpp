// SPDX-License-Identifier: MIT
#include "core/transfer/texels.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::transfer {
namespace {

using namespace testing;

TEST(Texels, TheirAreasAreThatOfAllLitSides) {
  const auto scene = sceneOf(blockRoom());
  const Texels plain = makeTexels(*scene->mesh, scene->sides, 0.0937, nullptr);
  // Nothing covers anything here, so the same with a caster. Sums of single precision.
  EXPECT_NEAR(sum(plain.area), kBlockRoomArea, 1e-5 * kBlockRoomArea);
  const Texels measured = makeTexels(*scene->mesh, scene->sides, 0.0937, &scene->caster);
  EXPECT_NEAR(sum(measured.area), kBlockRoomArea, 1e-5 * kBlockRoomArea);
}

TEST(Texels, LieOnTheirTriangleAndLookAwayFromIt) {
  const auto scene = sceneOf(blockRoom());
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  const geometry::Mesh& mesh = *scene->mesh;
  for (std::uint32_t s = 0; s < texels.slotCount(); ++s) {
    const std::uint32_t t = texels.triangle[s];
    const vec3 n = scene->normals[t];
    const vec3 p = texels.receivers.position(s);
    EXPECT_NEAR(glm::dot(n, p - mesh.positions[mesh.triangles[t].x]), 0.0F, 1e-5F);
    EXPECT_NEAR(std::abs(glm::dot(n, texels.receivers.normal(s))), 1.0F, 1e-5F);
    EXPECT_EQ(texels.material[s], mesh.material_of[t]);
    // The texel at its own point is itself.
    if (texels.area[s] > 0.0F) {
      EXPECT_EQ(texels.at(t, glm::dot(n, texels.receivers.normal(s)) > 0.0F, p), s);
    }
  }
}

TEST(Texels, TheFarSideOfARoomsWallsHasNone) {
  const auto scene = sceneOf(blockRoom());
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  for (std::uint32_t t = 0; t < scene->mesh->triangles.size(); ++t) {
    const uvec3& i = scene->mesh->triangles[t];
    const vec3 middle =
        (scene->mesh->positions[i.x] + scene->mesh->positions[i.y] + scene->mesh->positions[i.z]) /
        3.0F;
    EXPECT_NE(texels.at(t, true, middle), kNoTexel);
    EXPECT_EQ(texels.at(t, false, middle), kNoTexel);
  }
}

TEST(Texels, AroundAPointWeightsInterpolateLinearly) {
  const auto scene = sceneOf(blockRoom());
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  std::array<std::uint32_t, Texels::kMostAround> slots{};
  std::array<float, Texels::kMostAround> weights{};
  int asked = 0;
  for (std::uint32_t t = 0; t < scene->mesh->triangles.size(); ++t) {
    const uvec3& i = scene->mesh->triangles[t];
    const vec3& a = scene->mesh->positions[i.x];
    // Well inside the triangle: four whole cells around.
    const vec3 p =
        a + 0.4F * (scene->mesh->positions[i.y] - a) + 0.35F * (scene->mesh->positions[i.z] - a);
    const int count = texels.around(t, true, p, slots, weights);
    ASSERT_GT(count, 0);
    EXPECT_EQ(texels.around(t, false, p, slots, weights), 0);
    ASSERT_EQ(texels.around(t, true, p, slots, weights), count);
    float total = 0.0F;
    vec3 mean(0.0F);
    for (int k = 0; k < count; ++k) {
      const auto j = static_cast<std::size_t>(k);
      total += weights[j];
      mean += weights[j] * texels.receivers.position(slots[j]);
      EXPECT_GE(weights[j], 0.0F);
      EXPECT_GT(glm::dot(texels.receivers.normal(slots[j]), scene->normals[t]), 0.999F);
    }
    EXPECT_NEAR(total, 1.0F, 1e-5F);
    // Positions are linear, so bilinear weights between cell centres give the point back.
    const bool whole = std::all_of(slots.begin(), slots.begin() + count, [&](std::uint32_t s) {
      return texels.area[s] > 0.99F * *std::max_element(texels.area.begin(), texels.area.end());
    });
    if (!whole) continue;
    EXPECT_LT(glm::length(mean - p), 1e-3F)
        << "at " << p.x << ' ' << p.y << ' ' << p.z << " from " << count;
    ++asked;
  }
  EXPECT_EQ(asked, 24);
}

TEST(Texels, LightIsNotTakenFromBehindAWallThatEndsInTheRoom) {
  // The floor is one part: one may walk round the wall. Still, what is lit behind the wall is not
  // seen at its foot.
  for (const float thickness : {0.03F, 0.08F, 0.16F, 0.25F}) {
    for (const double cell : {0.06, 0.1, 0.13}) {
      const float lo = 1.95F;
      const float hi = lo + thickness;
      geometry::Mesh mesh;
      append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
      append(mesh, geometry::makeBox({lo, 0.5F, -0.002F}, {hi, 2.5F, 2.0F}), 1);
      const std::vector<vec3> inside = {{1, 1, 1}};
      const auto scene =
          makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
      const Texels texels = makeTexels(*scene->mesh, scene->sides, cell, &scene->caster);
      std::array<std::uint32_t, Texels::kMostAround> slots{};
      std::array<float, Texels::kMostAround> weights{};
      for (int k = 0; k < 200; ++k) {
        const float along = 0.8F + 0.007F * static_cast<float>(k);
        const bool right = k % 2 == 0;
        const float off = 0.001F + 0.0004F * static_cast<float>(k);
        const vec3 p(right ? hi + off : lo - off, along, 0.0F);
        const geometry::Hit hit = scene->caster.closest({p + vec3(0, 0, 0.01F), 0.0F, {0, 0, -1}});
        ASSERT_TRUE(hit.valid());
        const int count = texels.around(hit.triangle, true, p, slots, weights);
        ASSERT_GT(count, 0);
        for (int i = 0; i < count; ++i) {
          const auto at = static_cast<std::size_t>(i);
          const float x = texels.receivers.position(slots[at]).x;
          EXPECT_TRUE(weights[at] < 1e-6F || (right ? x > 0.5F * (lo + hi) : x < 0.5F * (lo + hi)))
              << thickness << ' ' << cell << ": " << p.x << " takes " << weights[at] << " of " << x;
        }
      }
    }
  }
}

TEST(Texels, ClustersHoldTheirNumberAndPadding) {
  const auto scene = sceneOf(roomMesh());
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.08, &scene->caster);
  std::size_t used = 0;
  for (const light::Receivers::Cluster& c : texels.receivers.clusters) {
    EXPECT_EQ(c.begin % 16, 0U);
    EXPECT_EQ(c.end % 16, 0U);
    EXPECT_LE(c.end - c.begin, 256U);
    for (std::uint32_t s = c.begin + c.used; s < c.end; ++s) EXPECT_EQ(texels.area[s], 0.0F);
    used += c.used;
  }
  EXPECT_EQ(used, texels.texelCount());
  EXPECT_EQ(texels.area.size(), texels.receivers.slotCount());
}

TEST(CellForCount, GivesAboutTheNumberThatIsWished) {
  const auto scene = sceneOf(blockRoom());
  for (const std::size_t wished : {600U, 3000U, 20000U}) {
    const double cell = cellForCount(*scene->mesh, scene->sides, wished, 1e-3);
    const auto found =
        static_cast<double>(makeTexels(*scene->mesh, scene->sides, cell, nullptr).texelCount());
    EXPECT_GE(found, static_cast<double>(wished));
    EXPECT_LE(found, 1.06 * static_cast<double>(
                                wished));  // "about": whole rows of cells come and go together
  }
  EXPECT_EQ(cellForCount(*scene->mesh, scene->sides, 1000000, 0.05), 0.05);
}

TEST(CellForCount, WithoutLitSidesIsHarmless) {
  const auto scene = sceneOf(blockRoom());
  const std::vector<std::uint8_t> none(scene->mesh->triangles.size(), kNoSide);
  EXPECT_GT(cellForCount(*scene->mesh, none, 1000, 0.03), 0.0);
}

}  // namespace
}  // namespace soffit::transfer
