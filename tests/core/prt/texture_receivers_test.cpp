// SPDX-License-Identifier: MIT
#include "core/prt/texture_receivers.h"

#include "core/math/rng.h"
#include "core/prt/shadow_pass.h"
#include "tests/core/prt/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soffit::prt {
namespace {

using testing::Builder;
using testing::matte;

vec3 pointOf(const Surfaces& s, const geometry::Hit& h) {
  return (1.0F - h.u - h.v) * s.corner(h.triangle, 0) + h.u * s.corner(h.triangle, 1) +
         h.v * s.corner(h.triangle, 2);
}

TEST(TextureReceivers, InterpolationIsExactForLinearLightAwayFromEdges) {
  const auto surfaces =
      Builder()
          .add(testing::turned(geometry::makeRectangle(3, 2), {20, 30, 40}), matte(vec3(0.5F)))
          .surfaces();
  const TextureReceivers set = TextureReceivers::perObject(surfaces, {.texel = 0.1});
  Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    geometry::Hit hit{rng.below(2), 1.0F, rng.uniform(), 0.0F};
    hit.v = (1.0F - hit.u) * rng.uniform();
    for (const bool front : {true, false}) {
      ReceiverSet::Around taps;
      const std::size_t count = set.around(hit, front, taps);
      ASSERT_GT(count, 0U);
      vec3 mean(0.0F);
      float sum = 0.0F;
      for (std::size_t k = 0; k < count; ++k) {
        mean += taps[k].weight * set.receivers().positions[taps[k].receiver];
        sum += taps[k].weight;
        EXPECT_GT(glm::dot(set.receivers().facing[taps[k].receiver],
                           (front ? 1.0F : -1.0F) * surfaces->normals[0]),
                  0.99F);
      }
      EXPECT_NEAR(sum, 1.0F, 1e-5F);
      // Within half a texel of an edge the outer neighbor is missing.
      const float off = glm::distance(mean, pointOf(*surfaces, hit));
      EXPECT_LT(off, count == 4 ? 1e-4F : 0.0708F);
    }
  }
}

TEST(TextureReceivers, EveryObjectHasATextureOfItsOwn) {
  const auto surfaces = testing::blockOnFloor(1, vec3(0.5F), vec3(0.4F)).surfaces();
  const TextureReceivers sets = TextureReceivers::perObject(surfaces, {.texel = 0.1});
  ASSERT_EQ(sets.sets().size(), 2U);
  EXPECT_EQ(sets.sets()[0].name, "o0");
  EXPECT_EQ(sets.sets()[0].count, 2 * 40U * 40U);
  EXPECT_EQ(sets.sets()[1].first, sets.sets()[0].count);
  EXPECT_EQ(sets.sets()[1].count, 2 * 10U * 10U + 4 * 10U * 12U);
  const TextureReceivers atlas = TextureReceivers::atlas(surfaces, {.texel = 0.1});
  EXPECT_EQ(atlas.sets().size(), 1U);
  EXPECT_EQ(atlas.receivers().size(), sets.receivers().size());
}

TEST(TextureReceivers, SetsOfEqualSideAreSharperOnSmallThings) {
  // PRTT's figure 3: with the same memory, a texture each against one for all.
  const auto surfaces = testing::blockOnFloor(1, vec3(0.5F), vec3(0.4F)).surfaces();
  const TextureReceivers atlas = TextureReceivers::atlas(surfaces, {.side = 256});
  const TextureReceivers sets = TextureReceivers::perObject(surfaces, {.side = 172});
  const auto texels = [](const TextureReceivers& r) {
    double sum = 0.0;
    for (const TextureSet& s : r.sets()) sum += double(s.layout.width) * s.layout.height;
    return sum;
  };
  EXPECT_LT(texels(sets), 1.05 * texels(atlas));
  // The block has 6.8 of 38.8 m^2 and half of the texels: sqrt(2 * 6.8 / 38.8) = 0.59, and gutters.
  EXPECT_LT(sets.sets()[1].layout.texel, 0.65 * atlas.sets()[0].layout.texel);
}

/// A wave of normals along x in tangent space.
scene::Material bumpy() {
  scene::Material m = matte(vec3(0.5F));
  auto image = std::make_shared<scene::Image>();
  image->width = 64;
  image->height = 1;
  for (int i = 0; i < 64; ++i) {
    const double slope = 0.5 * std::sin(2 * kPi * (i + 0.5) / 64);
    const dvec3 n = glm::normalize(dvec3(slope, 0, 1));
    for (int c = 0; c < 3; ++c) image->pixels.push_back(static_cast<float>(0.5 + 0.5 * n[c]));
  }
  m.normal_image = image;
  return m;
}

TEST(TextureReceivers, NormalMapsBendTheShadingNormalAlone) {
  geometry::Mesh quad = testing::quad({0, 0, 0}, {3.2F, 0, 0}, {0, 0.1F, 0});
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto surfaces = Builder().add(quad, bumpy()).surfaces();
  const TextureReceivers set =
      TextureReceivers::perObject(surfaces, {.texel = 0.05, .given_uvs = false});
  const Receivers& r = set.receivers();
  for (std::size_t i = 0; i < r.size(); ++i) {
    EXPECT_EQ(std::abs(r.facing[i].z), 1.0F);
    const double slope = 0.5 * std::sin(2 * kPi * double{r.positions[i].x} / 3.2);
    const dvec3 wanted = glm::normalize(dvec3(slope, 0, 1));
    const float side = r.facing[i].z;
    // Bilinear in the map and averaged over one of its texels: sin(pi/64) / (pi/64) twice.
    EXPECT_NEAR(r.normals[i].x, side * wanted.x, 2e-3);
  }
}

TEST(TextureReceivers, NormalMapsFollowTheLight) {
  geometry::Mesh quad = testing::quad({0, 0, 0}, {3.2F, 0, 0}, {0, 0.1F, 0});
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto surfaces = Builder().add(quad, bumpy()).surfaces();
  const TextureReceivers set =
      TextureReceivers::perObject(surfaces, {.texel = 0.05, .given_uvs = false});
  const TransferRows rows = unshadowedTransfer(set.receivers(), 2);
  // Light from +x against light from -x: what one brightens the other darkens.
  sh::Coefficients right(4, 0.0), left(4, 0.0);
  right[0] = left[0] = 1.0;
  right[sh::index(1, 1)] = 1.0;
  left[sh::index(1, 1)] = -1.0;
  for (std::size_t i = 0; i < set.receivers().size(); ++i) {
    const double difference =
        testing::illuminance(rows, i, right) - testing::illuminance(rows, i, left);
    EXPECT_NEAR(difference,
                2 * std::sqrt(3 / (4 * kPi)) * 2 * kPi / 3 * double{set.receivers().normals[i].x},
                1e-5);
  }
}

TEST(TextureReceivers, DiffuseMapsColorTexels) {
  geometry::Mesh quad = testing::quad({0, 0, 0}, {2, 0, 0}, {0, 1, 0});
  quad.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  scene::Material m = matte({0.5F, 1.0F, 0.5F});
  auto image = std::make_shared<scene::Image>();
  image->width = 2;
  image->height = 1;
  image->pixels = {1, 1, 1, 0, 0.5F, 0};
  m.diffuse_image = image;
  const auto surfaces = Builder().add(quad, m).surfaces();
  const TextureReceivers set = TextureReceivers::perObject(surfaces, {.texel = 0.1});
  const Receivers& r = set.receivers();
  double sum = 0.0;
  double area = 0.0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    sum += double{r.areas[i]} * double{r.reflectance[i].y};
    area += double{r.areas[i]};
    const bool white = std::abs(r.positions[i].x - 0.5F) < 0.06F;
    EXPECT_NEAR(r.reflectance[i].x, white ? 0.5F : 0.25F, white ? 0.03F : 0.26F);
  }
  EXPECT_NEAR(sum / area, 0.75, 1e-3);
  EXPECT_FALSE(r.grey());
}

TEST(TextureReceivers, TexelsInMatterTakeTheirNeighborsLight) {
  Builder b;
  b.add(geometry::makeRectangle(4, 4), matte(vec3(0.5F)));
  b.add(geometry::makeBox({-0.75F, -0.75F, -0.5F}, {0.75F, 0.75F, 1.0F}), matte(vec3(0.5F)));
  const auto surfaces = b.surfaces();
  TextureReceivers set = TextureReceivers::perObject(surfaces, {.texel = 0.1});
  set.replaceInvalid(findUncovered(*surfaces, set.receivers()).value());
  const Receivers& r = set.receivers();
  for (std::size_t i = 0; i < set.sets()[0].count; ++i) {
    const float edge = std::max(std::abs(r.positions[i].x), std::abs(r.positions[i].y));
    EXPECT_EQ(r.standsForItself(i), edge > 0.75F) << edge;
    const vec3& from = r.positions[r.sourceOf(i)];
    EXPECT_GT(std::max(std::abs(from.x), std::abs(from.y)), 0.75F);
    EXPECT_EQ(r.facing[r.sourceOf(i)], r.facing[i]);
  }
}

}  // namespace
}  // namespace soffit::prt
