// SPDX-License-Identifier: MIT
// Which texels share a cluster, told by the clusters that makeTexels() forms.
#include "core/transfer/regions.h"

#include "tests/core/transfer/rooms.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace soffit::transfer {
namespace {

using namespace testing;

/// Clusters that hold lit texels of both kinds, told by the place a little above the surface.
int mixedClusters(const Texels& texels, const std::function<int(const vec3&)>& kind) {
  int mixed = 0;
  for (const light::Receivers::Cluster& c : texels.receivers.clusters) {
    std::set<int> kinds;
    for (std::uint32_t s = c.begin; s < c.begin + c.used; ++s) {
      if (texels.area[s] <= 0.0F) continue;
      const int k = kind(texels.receivers.position(s) + 0.005F * texels.receivers.normal(s));
      if (k >= 0) kinds.insert(k);
    }
    mixed += kinds.size() > 1 ? 1 : 0;
  }
  return mixed;
}

TEST(Regions, TwoRoomsOverOneSlabAreTwo) {
  // One shell, a wall from floor to ceiling that sinks 2 mm in all around.
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1.9F, -0.002F, -0.002F}, {2.05F, 3.002F, 2.502F}), 0);
  const std::vector<vec3> inside = {{1, 1, 1}, {3, 1, 1}};
  const auto scene =
      makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
  for (const double cell : {0.11, 0.07}) {
    const Texels texels = makeTexels(*scene->mesh, scene->sides, cell, &scene->caster);
    const auto room = [](const vec3& p) {
      const bool within = p.x > 0 && p.x < 4 && p.y > 0 && p.y < 3 && p.z > 0 && p.z < 2.5F;
      return !within ? -1 : (p.x < 1.9F ? 0 : (p.x > 2.05F ? 1 : -1));
    };
    EXPECT_EQ(mixedClusters(texels, room), 0) << cell;
  }
}

TEST(Regions, ADoorwayJoinsThem) {
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1.95F, -0.002F, -0.002F}, {2.05F, 1.0F, 2.502F}), 0);
  append(mesh, geometry::makeBox({1.95F, 2.0F, -0.002F}, {2.05F, 3.002F, 2.502F}), 0);
  const std::vector<vec3> inside = {{1, 1, 1}, {3, 1, 1}};
  const auto scene =
      makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  // The floor is one region again: some cluster reaches through.
  EXPECT_GT(
      mixedClusters(texels, [](const vec3& p) { return p.z > 0.1F ? -1 : (p.x < 1.95F ? 0 : 1); }),
      0);
}

TEST(Regions, ASealedBoxKeepsToItself) {
  // A closed showcase within the room, known to be lit inside.
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1, 1, 0.5F}, {2.5F, 2, 1.5F}), 0);
  const std::vector<vec3> inside = {{1.7F, 1.5F, 1}, {3, 0.5F, 1}};
  const auto scene =
      makeStaticScene(std::make_shared<const geometry::Mesh>(std::move(mesh)), inside);
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  const auto kind = [](const vec3& p) {
    return p.x > 1 && p.x < 2.5F && p.y > 1 && p.y < 2 && p.z > 0.5F && p.z < 1.5F ? 0 : 1;
  };
  EXPECT_EQ(mixedClusters(texels, kind), 0);
  int within = 0;
  for (std::size_t s = 0; s < texels.slotCount(); ++s) {
    within += kind(texels.receivers.position(s) + 0.005F * texels.receivers.normal(s)) == 0 ? 1 : 0;
  }
  EXPECT_GT(within, 500);  // 8 m^2 in cells of 0.01 m^2
}

TEST(Regions, AGapAndTheOpenAreApart) {
  geometry::Mesh mesh;
  append(mesh, roomBox({0, 0, 0}, {4, 3, 2.5F}), 0);
  append(mesh, geometry::makeBox({1, 1, 0.01F}, {2.2F, 2.2F, 0.3F}), 1);
  const auto scene = sceneOf(std::move(mesh));
  const Texels texels = makeTexels(*scene->mesh, scene->sides, 0.1, &scene->caster);
  EXPECT_EQ(
      mixedClusters(texels,
                    [](const vec3& p) {
                      if (p.z > 0.006F) return -1;
                      const bool under = p.x > 1.15F && p.x < 2.05F && p.y > 1.15F && p.y < 2.05F;
                      const bool beside = p.x < 0.85F || p.x > 2.35F || p.y < 0.85F || p.y > 2.35F;
                      return under ? 0 : (beside ? 1 : -1);
                    }),
      0);
}

}  // namespace
}  // namespace soffit::transfer
