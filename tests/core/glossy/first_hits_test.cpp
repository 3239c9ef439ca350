// SPDX-License-Identifier: MIT
#include "core/glossy/first_hits.h"

#include "core/sh/cube_map.h"
#include "tests/core/glossy/test_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace soffit::glossy {
namespace {

std::shared_ptr<const sh::SphereSamples> cube(int side) {
  return std::make_shared<const sh::SphereSamples>(sh::cubeSamples(side));
}

TEST(FirstHits, AProbeSeesTheWallsAllRound) {
  const geometry::RayCaster box = boxCaster({-1, -1, -1}, {1, 1, 1});
  const std::array<vec3, 1> probe{vec3(0.0F)};
  const FirstHits first(box, probe, {}, cube(8));
  for (std::size_t k = 0; k < first.samples().size(); ++k) {
    ASSERT_TRUE(first.hits(0)[k].valid());
    // The distance to a cube's wall from its middle is 1 over the greatest component.
    const dvec3 d = glm::abs(first.samples().directions[k]);
    EXPECT_NEAR(static_cast<double>(first.hits(0)[k].t), 1.0 / std::max({d.x, d.y, d.z}), 1e-5);
  }
}

TEST(FirstHits, AReceiverSeesWhatIsAboveIt) {
  const geometry::RayCaster box = boxCaster({-1, -1, 0}, {1, 1, 2});
  const std::array<vec3, 1> at{vec3(0.0F)};
  const std::array<vec3, 1> up{vec3(0.0F, 0.0F, 1.0F)};
  const FirstHits first(box, at, up, cube(8));
  for (std::size_t k = 0; k < first.samples().size(); ++k) {
    EXPECT_EQ(first.hits(0)[k].valid(), first.samples().directions[k].z > 0.0);
  }
}

TEST(FirstHits, LightIsAskedForAtHitsAloneAndMissesShowTheBackground) {
  const geometry::RayCaster floor = floorCaster(0.0F);
  const std::array<vec3, 1> probe{vec3(0.0F, 0.0F, 1.0F)};
  const FirstHits first(floor, probe, {}, cube(8));
  const auto radiance = lightHits(
      first, 0,
      [](std::span<const geometry::Ray> rays, std::span<const geometry::Hit> hits,
         std::span<vec3> out) {
        for (std::size_t k = 0; k < hits.size(); ++k) {
          EXPECT_TRUE(hits[k].valid());
          EXPECT_LT(rays[k].direction.z, 0.0F);
          out[k] = vec3(1.0F, 2.0F, hits[k].t);
        }
      },
      vec3(7.0F));
  for (std::size_t k = 0; k < radiance.size(); ++k) {
    if (first.samples().directions[k].z > 0.0) {
      EXPECT_EQ(radiance[k], vec3(7.0F));
    } else {
      EXPECT_NEAR(radiance[k].z, -1.0 / first.samples().directions[k].z, 1e-4);
    }
  }
}

TEST(FirstHits, SourcesAreGathered) {
  const std::array<std::uint32_t, 3> source_of{1, kNoSource, 0};
  const std::array<vec3, 2> values{vec3(3.0F), vec3(1.0F, 2.0F, 4.0F)};
  const auto radiance = gatherSources(source_of, values);
  EXPECT_EQ(radiance[0], values[1]);
  EXPECT_EQ(radiance[1], vec3(0.0F));
  EXPECT_EQ(radiance[2], values[0]);
}

}  // namespace
}  // namespace soffit::glossy
