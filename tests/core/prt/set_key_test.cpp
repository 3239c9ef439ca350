// SPDX-License-Identifier: MIT
#include "core/prt/set_key.h"

#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

SetKey keyOf(const geometry::Mesh& mesh, const scene::Material& material,
             const TextureOptions& options = {}) {
  const auto surfaces = Builder().add(mesh, material).surfaces();
  std::vector<std::uint32_t> all(surfaces->triangleCount());
  std::iota(all.begin(), all.end(), 0U);
  return setKey(*surfaces, all, options);
}

geometry::Mesh mappedQuad() {
  geometry::Mesh quad = testing::quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return quad;
}

scene::Material bumped(float x) {
  scene::Material m = matte(vec3(0.5F));
  auto image = std::make_shared<scene::Image>();
  image->width = image->height = 1;
  image->pixels = {x, 0.5F, 1.0F};
  m.normal_image = std::move(image);
  return m;
}

TEST(SetKey, WhatDecidesTexelsCounts) {
  const SetKey plain = keyOf(mappedQuad(), matte(vec3(0.5F)));
  EXPECT_EQ(plain, keyOf(mappedQuad(), matte(vec3(0.5F))));
  EXPECT_NE(plain, keyOf(testing::moved(mappedQuad(), {0, 0, 1e-5F}), matte(vec3(0.5F))));
  geometry::Mesh shifted = mappedQuad();
  shifted.uvs[2].x = 0.9F;
  EXPECT_NE(plain, keyOf(shifted, matte(vec3(0.5F))));
  geometry::Mesh bent = mappedQuad();
  bent.normals[1] = glm::normalize(vec3(0.1F, 0, 1));
  EXPECT_NE(plain, keyOf(bent, matte(vec3(0.5F))));
  scene::Material glass;
  glass.glass = scene::Glass{1.52, 0.8};
  EXPECT_NE(plain, keyOf(mappedQuad(), glass));
  EXPECT_NE(plain, keyOf(mappedQuad(), bumped(0.5F)));
  EXPECT_NE(keyOf(mappedQuad(), bumped(0.6F)), keyOf(mappedQuad(), bumped(0.5F)));
  EXPECT_NE(plain, keyOf(mappedQuad(), matte(vec3(0.5F)), {.texel = 0.04}));
  EXPECT_NE(plain, keyOf(mappedQuad(), matte(vec3(0.5F)), {.side = 128}));
  EXPECT_NE(plain, keyOf(mappedQuad(), matte(vec3(0.5F)), {.dilation = 2}));
}

TEST(SetKey, PaintDoesNot) {
  EXPECT_EQ(keyOf(mappedQuad(), matte(vec3(0.5F))), keyOf(mappedQuad(), matte({0.9F, 0.1F, 0})));
}

}  // namespace
}  // namespace soffit::prt
