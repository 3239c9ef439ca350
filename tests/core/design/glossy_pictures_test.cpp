// SPDX-License-Identifier: MIT
#include "core/design/glossy_pictures.h"

#include "tests/core/reference/rooms.h"
#include "tests/core/render/test_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace soffit::design {
namespace {

using testing::HasSubstr;

/// A rough, black, specular floor before a matte wall, under a panel.
struct Stage {
  scene::Scene scene;
  std::unique_ptr<render::ViewScene> view;
  reference::ReferenceScene reference;

  static Stage make() {
    scene::Material floor = reference::test::matte(0.0);
    floor.specular = 0.04;
    floor.roughness = 0.65;
    floor.name = "floor";
    auto scene = reference::test::Builder()
                     .quad({-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, floor)
                     .quad({-4, 4, 0}, {8, 0, 0}, {0, 0, 3}, reference::test::matte(0.6))
                     .scene();
    const std::vector<light::Luminaire> lamps{
        reference::test::luminaire(light::Rectangle{1.0, 1.0}, {0, 2, 2.8}, 3000.0)};
    scene.luminaires = lamps;
    std::vector<light::Emitter> emitters{*light::makeEmitter(lamps[0])};
    const auto caster =
        std::make_shared<const geometry::RayCaster>(scene.mesh->positions, scene.mesh->triangles);
    auto view = std::make_unique<render::ViewScene>(std::make_shared<scene::Scene>(scene), caster,
                                                    std::move(emitters));
    auto traced = reference::test::prepare(scene, lamps);
    return {std::move(scene), std::move(view), std::move(traced)};
  }
};

GlossyPictureOptions small() {
  GlossyPictureOptions o;
  o.width = 64;
  o.height = 48;
  o.stride = 8;
  o.samples = 16;
  o.paths = 1024;
  o.map_side = 32;
  return o;
}

TEST(GlossyPictures, EveryMethodComesNearThePathTracer) {
  const Stage stage = Stage::make();
  const render::SampledLight light(*stage.view, 64, vec3(0.0F));
  const scene::Camera camera{"Eye", {0, -3.5, 1.6}, {0, 1.5, 0.2}, 50.0};
  const auto rows =
      measureGlossyPictures(*stage.view, {light, light}, stage.reference, camera, small());
  ASSERT_TRUE(rows) << rows.error().message();
  std::map<std::string, double> floor;
  for (const GlossyPictureRow& row : rows->rows) {
    EXPECT_EQ(row.camera, "Eye");
    if (row.part == "floor, roughness 0.65") floor[row.method.substr(0, 12)] = row.rms;
    if (row.part == "picture") {
      EXPECT_EQ(row.pixels, 48U);
    }
  }
  ASSERT_EQ(floor.size(), 7U);
  // Shares of the whole picture's mean, in which the floor is dark: the light that the floor casts
  // on the wall is missing in the light handed over.
  EXPECT_GT(floor["matte alone"], 0.02);
  EXPECT_LT(floor["rays"], 0.3 * floor["matte alone"]);
  EXPECT_LT(floor["reflection m"], 0.3 * floor["matte alone"]);
  EXPECT_LT(floor["harmonics, 6"], 0.3 * floor["matte alone"]);
  EXPECT_THAT(formatGlossyPictureRows(rows->rows), HasSubstr("\"Eye\",\"rays\",\"picture\",48,"));
}

TEST(GlossyPictures, StopsWhenAskedAndRefusesABadCamera) {
  const Stage stage = Stage::make();
  const render::EvenLight light(vec3(1.0F));
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(measureGlossyPictures(*stage.view, {light, light}, stage.reference,
                                     {"Eye", {0, -3.5, 1.6}, {0, 1.5, 0.2}, 50.0}, small(),
                                     {nullptr, stop.get_token()}));
  EXPECT_FALSE(measureGlossyPictures(*stage.view, {light, light}, stage.reference,
                                     {"Blind", {0, 0, 1}, {0, 0, 1}, 50.0}, small()));
}

}  // namespace
}  // namespace soffit::design
