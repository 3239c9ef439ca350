// SPDX-License-Identifier: MIT
#include "core/scene/reflectances.h"

#include "core/geometry/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace soffit::scene {
namespace {

using testing::ElementsAre;

/// A rectangle of 2 x 3 m of one material.
Scene sheetOf(Material material) {
  Scene scene;
  geometry::Mesh mesh = geometry::makeRectangle(2.0F, 3.0F, 2, 2);
  material.name = "paint";
  mesh.materials = {material.name};
  scene.mesh = std::make_shared<const geometry::Mesh>(std::move(mesh));
  scene.materials = {std::move(material)};
  return scene;
}

// Round-off of single-precision vertices.
constexpr double kRoundoff = 1e-6;

TEST(MaterialAreas, AreThoseOfOneSide) {
  const auto areas = materialAreas(sheetOf({}));
  ASSERT_EQ(areas.size(), 1U);
  EXPECT_NEAR(areas[0], 6.0, 6.0 * kRoundoff);
}

TEST(Reflectance, IsLuminanceAndCountsSpecularAndMap) {
  Material m;
  m.diffuse = {1.0, 0.0, 0.0};
  EXPECT_NEAR(reflectance(m), 0.2126390058715104, 1e-12);  // of red, IEC 61966-2-1
  m.diffuse = dvec3(0.8);
  m.specular = 0.04;
  EXPECT_NEAR(reflectance(m), 0.84, 1e-12);
  m.diffuse_image = std::make_shared<const Image>(Image{2, 1, 3, {1, 1, 1, 0, 0, 0}});
  EXPECT_NEAR(reflectance(m), 0.44, 1e-12);
}

TEST(ImplausibleReflectances, NamesWhatNoPaintHas) {
  Material m;
  m.diffuse = dvec3(0.97);
  EXPECT_THAT(implausibleReflectances(sheetOf(m)),
              ElementsAre("materials.paint: reflectance 0.97 on 6 m² is more than white paint has "
                          "(0.85)"));
  m.diffuse = dvec3(0.0);
  EXPECT_THAT(implausibleReflectances(sheetOf(m)),
              ElementsAre("materials.paint: reflectance 0.00 on 6 m² is a black that hardly "
                          "exists"));
}

TEST(ImplausibleReflectances, LeavesPaintGlassAndUnusedMaterialsAlone) {
  Material m;
  m.diffuse = dvec3(0.85);
  EXPECT_TRUE(implausibleReflectances(sheetOf(m)).empty());
  m.diffuse = dvec3(0.0);
  m.glass = Glass{};
  EXPECT_TRUE(implausibleReflectances(sheetOf(m)).empty());
  Scene scene = sheetOf({});
  scene.materials.push_back({.name = "left over", .diffuse = dvec3(1.0)});
  EXPECT_TRUE(implausibleReflectances(scene).empty());
}

TEST(Reflectance, OfAGreyMapAndOfOneWithOpacity) {
  Material grey;
  grey.diffuse = dvec3(1.0);
  grey.diffuse_image = std::make_shared<const Image>(Image{2, 2, 1, {0.1F, 0.2F, 0.3F, 0.4F}});
  EXPECT_NEAR(reflectance(grey), 0.25, 1e-6);
  grey.diffuse_image = std::make_shared<const Image>(Image{1, 1, 4, {0.5F, 0.5F, 0.5F, 0.0F}});
  EXPECT_NEAR(reflectance(grey), 0.5, 1e-6);
}

}  // namespace
}  // namespace soffit::scene
