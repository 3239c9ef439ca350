// SPDX-License-Identifier: MIT
#include "core/transfer/cache_key.h"

#include "tests/core/transfer/small_bake.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace soffit::transfer {
namespace {

using testing::roomMesh;

/// The room as the bake sees it, without the work of finding its lit sides.
StaticScene bareScene(geometry::Mesh mesh) {
  StaticScene scene{.mesh = std::make_shared<const geometry::Mesh>(std::move(mesh)),
                    .caster = geometry::RayCaster({}, {})};
  scene.sides.assign(scene.mesh->triangles.size(), kFront);
  return scene;
}

std::string keyOf(const std::function<void(geometry::Mesh&)>& change) {
  geometry::Mesh mesh = roomMesh();
  change(mesh);
  return cacheKey(bareScene(std::move(mesh)), {});
}

TEST(CacheKey, IsThirtyTwoHexadecimalDigitsAndRepeats) {
  const std::string key = cacheKey(bareScene(roomMesh()), {});
  EXPECT_THAT(key, ::testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_EQ(key.size(), 32U);
  EXPECT_EQ(key, cacheKey(bareScene(roomMesh()), {}));
}

TEST(CacheKey, ChangesWithGeometry) {
  std::set<std::string> keys{keyOf([](geometry::Mesh&) {})};
  keys.insert(keyOf([](geometry::Mesh& m) { m.positions[3].x += 1e-6F; }));
  keys.insert(keyOf([](geometry::Mesh& m) { std::swap(m.triangles[0], m.triangles[1]); }));
  keys.insert(keyOf([](geometry::Mesh& m) { m.triangles.pop_back(); }));
  keys.insert(keyOf([](geometry::Mesh& m) { m.material_of[5] = 7; }));
  keys.insert(keyOf([](geometry::Mesh& m) { m.uvs[2].y = 0.25F; }));
  keys.insert(keyOf([](geometry::Mesh& m) { m.uvs.clear(); }));
  StaticScene scene = bareScene(roomMesh());
  scene.sides[4] = kBothSides;
  keys.insert(cacheKey(scene, {}));
  EXPECT_EQ(keys.size(), 8U);
}

TEST(CacheKey, ChangesWithEverySetting) {
  const StaticScene scene = bareScene(roomMesh());
  const std::vector<std::function<void(BakeSettings&)>> changes = {
      [](BakeSettings& s) { ++s.texels; },           [](BakeSettings& s) { s.least_cell *= 1.001; },
      [](BakeSettings& s) { s.most_cell *= 1.001; },
      [](BakeSettings& s) { s.patch = 64; },         [](BakeSettings& s) { ++s.node_rays; },
      [](BakeSettings& s) { ++s.trainings; },        [](BakeSettings& s) { ++s.field_rays; },
      [](BakeSettings& s) { ++s.list_rays; },        [](BakeSettings& s) { ++s.max_rank; },
      [](BakeSettings& s) { s.lists *= 0.999; }, [](BakeSettings& s) { s.tolerance *= 0.999; }, [](BakeSettings& s) { ++s.seed; }};
  std::set<std::string> keys{cacheKey(scene, {})};
  for (const auto& change : changes) {
    BakeSettings settings;
    change(settings);
    keys.insert(cacheKey(scene, settings));
  }
  EXPECT_EQ(keys.size(), changes.size() + 1);
}

// Reflectances are no part of the static scene at all: it knows materials by number.
TEST(CacheKey, IgnoresNamesObjectsShadingNormalsAndOrigin) {
  const std::string key = keyOf([](geometry::Mesh&) {});
  EXPECT_EQ(key, keyOf([](geometry::Mesh& m) {
              m.materials = {"wall", "block", "die"};
              m.objects = {"room"};
              m.object_of.assign(m.triangles.size(), 0);
              m.normals.assign(m.positions.size(), vec3(0, 0, 1));
              m.origin = dvec3(1e6, 2e6, 100);
            }));
}

}  // namespace
}  // namespace soffit::transfer
