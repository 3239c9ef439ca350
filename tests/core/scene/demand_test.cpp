// SPDX-License-Identifier: MIT
#include "core/scene/demand.h"

#include "core/scene/equality.h"
#include "core/scene/roughness.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace soffit::scene {
namespace {

Scene emptyScene() {
  Scene scene;
  scene.mesh = std::make_shared<const geometry::Mesh>();
  return scene;
}

bool needs(const Scene& scene, const char* what) {
  const Demand demand = demandOf(scene);
  const bool needed = std::ranges::find(demand.needed, what) != demand.needed.end();
  const bool skipped =
      std::ranges::find(demand.skipped, what, &Demand::Skip::what) != demand.skipped.end();
  EXPECT_NE(needed, skipped) << what << " is said once";
  return needed;
}

TEST(Demand, LightFromOutsideIsNeededWhereThereIsAny) {
  Scene scene = emptyScene();
  EXPECT_FALSE(needs(scene, "light from outside"));
  EXPECT_FALSE(needs(scene, "sunlight"));
  EXPECT_FALSE(needs(scene, "light through glass"));
  Sky sky{.cie = 12, .horizontal_illuminance = 1.0};
  scene.environment = Environment{"", sky};
  EXPECT_TRUE(needs(scene, "light from outside"));
  EXPECT_FALSE(needs(scene, "sunlight"));
  sky.direct_normal_illuminance = 1.0;
  scene.environment->light = sky;
  EXPECT_TRUE(needs(scene, "sunlight"));
  sky.sun_altitude_deg = -1.0;
  scene.environment->light = sky;
  EXPECT_FALSE(needs(scene, "sunlight")) << "it is night";
  scene.materials.emplace_back().glass = Glass{};
  EXPECT_TRUE(needs(scene, "light through glass"));
}

TEST(Demand, MapsAreNeededWhereMaterialsHaveThem) {
  Scene scene = emptyScene();
  const auto image = std::make_shared<const Image>(Image{1, 1, 3, {0.5F, 0.5F, 0.5F}});
  Material& m = scene.materials.emplace_back();
  for (const char* what : {"pictures on surfaces", "bent normals", "roughness that changes"}) {
    EXPECT_FALSE(needs(scene, what)) << what;
  }
  m.roughness_image = image;
  EXPECT_FALSE(needs(scene, "roughness that changes")) << "there is no lobe";
  m.specular = 0.04;
  EXPECT_TRUE(needs(scene, "roughness that changes"));
  m.diffuse_image = image;
  EXPECT_TRUE(needs(scene, "pictures on surfaces"));
  m.normal_image = image;
  EXPECT_TRUE(needs(scene, "bent normals"));
}

TEST(RoughnessRange, IsTheMapsGreenTimesTheFactor) {
  Material m{.roughness = 0.8};
  EXPECT_EQ(roughnessRange(m).least, 0.8);
  EXPECT_EQ(roughnessRange(m).mean, 0.8);
  m.roughness_image =
      std::make_shared<const Image>(Image{2, 1, 3, {0.0F, 0.25F, 1.0F, 1.0F, 0.75F, 0.0F}});
  EXPECT_DOUBLE_EQ(roughnessRange(m).least, 0.2);
  EXPECT_DOUBLE_EQ(roughnessRange(m).mean, 0.4);
}

TEST(RoughnessRange, LooksAtPartOfALargePicture) {
  Image large{2000, 3, 3, {}};
  large.pixels.assign(std::size_t{2000} * 3 * 3, 0.5F);
  const Material m{.roughness = 0.6,
                   .roughness_image = std::make_shared<const Image>(std::move(large))};
  EXPECT_NEAR(roughnessRange(m).mean, 0.3, 1e-12);
}

TEST(Environment, IsComparedByContent) {
  const Environment sky{"a", Sky{.cie = 3, .horizontal_illuminance = 1.0}};
  EXPECT_TRUE(same(sky, Environment{"b", Sky{.cie = 3, .horizontal_illuminance = 1.0}}));
  EXPECT_FALSE(same(sky, Environment{"a", Sky{.cie = 4, .horizontal_illuminance = 1.0}}));
  EXPECT_FALSE(same(sky, Environment{"a", PatchLight{}}));
  const auto image = [](float x) {
    return std::make_shared<const Image>(Image{1, 1, 3, {x, x, x}});
  };
  const auto probe = [&](float x) {
    return Environment{"", Probe{"p.exr", ProbeLayout::cross, 10.0, 1.0, image(x)}};
  };
  EXPECT_TRUE(same(probe(1.0F), probe(1.0F)));
  EXPECT_FALSE(same(probe(1.0F), probe(2.0F)));
  PatchLight turned;
  turned.rotation_deg = 1.0;
  EXPECT_FALSE(same(Environment{"", PatchLight{}}, Environment{"", turned}));
}

}  // namespace
}  // namespace soffit::scene
