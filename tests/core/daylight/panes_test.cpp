// SPDX-License-Identifier: MIT
#include "core/daylight/panes.h"

#include "core/math/rng.h"

#include <gtest/gtest.h>

namespace soffit::daylight {
namespace {

/// Parallel unit squares at these heights; material 1 is glass.
struct Stack {
  geometry::Mesh mesh;
  std::vector<scene::Material> materials{2};
  Stack() { materials[1].glass = scene::Glass{1.52, 0.88}; }
  Stack& at(float z, std::uint32_t material) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const vec2& p : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
      mesh.positions.emplace_back(p.x, p.y, z);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
    mesh.material_of.insert(mesh.material_of.end(), {material, material});
    return *this;
  }
};

TEST(Panes, ASceneWithoutGlassHasNone) {
  const Stack stack = Stack().at(1.0F, 0);
  EXPECT_EQ(Panes::make(stack.mesh, stack.materials), nullptr);
}

TEST(Panes, SheetsMultiply) {
  const Stack stack = Stack().at(1.0F, 1).at(1.004F, 1).at(2.0F, 0);
  const auto panes = Panes::make(stack.mesh, stack.materials);
  ASSERT_NE(panes, nullptr);
  geometry::Ray up{vec3(0.3F, 0.4F, 0.0F), 0.0F, vec3(0, 0, 1)};
  EXPECT_NEAR(panes->transmittance(up), 0.88 * 0.88, 1e-6);
  up.t_max = 1.002F;
  EXPECT_NEAR(panes->transmittance(up), 0.88, 1e-6);
  const vec3 slanted(0.6F, 0.0F, 0.8F);
  const double each = Slab(*stack.materials[1].glass).at(0.8).transmitted;
  EXPECT_NEAR(panes->transmittance({vec3(0.1F, 0.5F, 0.5F), 0.0F, slanted}), each * each, 1e-6);
  EXPECT_NEAR(panes->transmittance({vec3(0.1F, 0.5F, 0.5F), 0.0F, 3.0F * slanted}), each * each,
              1e-6)
      << "whatever the direction's length";
}

TEST(Panes, OpaqueRaysPassGlassAndKeepTheMeshsNumbers) {
  const Stack stack = Stack().at(1.0F, 1).at(2.0F, 0);
  const auto panes = Panes::make(stack.mesh, stack.materials);
  const geometry::RayCaster opaque = opaqueCaster(stack.mesh, panes.get());
  Rng rng(1);
  for (int i = 0; i < 500; ++i) {
    const geometry::Hit hit =
        opaque.closest({vec3(0.01F + 0.98F * rng.uniform(), 0.01F + 0.98F * rng.uniform(), 0.0F),
                        0.0F, vec3(0, 0, 1)});
    ASSERT_TRUE(hit.valid());
    EXPECT_GE(hit.triangle, 2U);
    EXPECT_FLOAT_EQ(hit.t, 2.0F);
  }
}

TEST(Panes, ACommonEdgeCountsOnce) {
  const Stack stack = Stack().at(1.0F, 1);
  const auto panes = Panes::make(stack.mesh, stack.materials);
  for (int i = 1; i < 200; ++i) {
    const float x = static_cast<float>(i) / 200.0F;  // along the diagonal
    EXPECT_NEAR(panes->transmittance({vec3(x, x, 0.0F), 0.0F, vec3(0, 0, 1)}), 0.88, 1e-6) << x;
  }
}

TEST(Panes, ManyRaysAtOnceAgreeWithOneByOne) {
  const Stack stack = Stack().at(1.0F, 1).at(1.5F, 1);
  const auto panes = Panes::make(stack.mesh, stack.materials);
  Rng rng(2);
  std::vector<geometry::Ray> rays;
  std::vector<float> share;
  for (int i = 0; i < 200; ++i) {
    const vec3 d(2.0F * rng.uniform() - 1.0F, 2.0F * rng.uniform() - 1.0F, 1.0F);
    rays.push_back({vec3(0.5F, 0.5F, 0.0F), 0.0F, glm::normalize(d)});
    share.push_back(i % 3 == 0 ? 0.0F : 0.5F);
  }
  std::vector<float> many = share;
  panes->attenuate(rays, many);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    EXPECT_NEAR(many[i], share[i] * panes->transmittance(rays[i]), 1e-6);
  }
}

}  // namespace
}  // namespace soffit::daylight
