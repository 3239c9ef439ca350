// SPDX-License-Identifier: MIT
#include "core/scene/diff.h"

#include "tests/core/scene/example_scene.h"

#include <gtest/gtest.h>

namespace soffit::scene {
namespace {

TEST(Diff, OfEqualScenesIsEmptyEvenWhenTheyWereLoadedTwice) {
  EXPECT_FALSE(diff(exampleScene(), exampleScene()).any());
}

TEST(Diff, AMoveNeedsRaysAndADimmerDoesNot) {
  const Scene before = exampleScene();
  Scene after = before;
  after.luminaires[0].position.x += 0.1;
  after.luminaires[1].dimming = 0.5;
  const SceneDiff d = diff(before, after);
  ASSERT_EQ(d.luminaires.size(), 2U);
  EXPECT_TRUE(d.luminaires[0].moved);
  EXPECT_TRUE(d.luminaires[0].needsRays());
  EXPECT_FALSE(d.luminaires[0].gain);
  EXPECT_TRUE(d.luminaires[1].gain);
  EXPECT_FALSE(d.luminaires[1].needsRays());
  EXPECT_FALSE(d.geometry);
}

TEST(Diff, TellsEachReasonApart) {
  const Scene before = exampleScene();
  const auto changed = [&](auto&& change) {
    Scene after = before;
    change(after.luminaires[0]);
    const auto changes = diff(before, after).luminaires;
    EXPECT_EQ(changes.size(), 1U);
    return changes.empty() ? LuminaireChange{} : changes.front();
  };
  EXPECT_TRUE(changed([](auto& l) { l.rotation_deg.z = 5; }).moved);
  EXPECT_TRUE(changed([](auto& l) { l.shape = light::Disk{0.3}; }).reshaped);
  EXPECT_TRUE(changed([](auto& l) { l.shape = light::Rectangle{0.6, 0.7}; }).reshaped);
  EXPECT_TRUE(changed([](auto& l) { l.scale = 2; }).reshaped);
  EXPECT_TRUE(changed([](auto& l) {
                l.distribution.kind = light::DistributionKind::isotropic;
              }).photometry);
  EXPECT_TRUE(changed([](auto& l) { l.casts_shadow = true; }).casts_shadow);
  EXPECT_TRUE(changed([](auto& l) { l.flux = 1.0; }).flux);
  EXPECT_FALSE(changed([](auto& l) { l.flux = 1.0; }).needsRays());
  EXPECT_TRUE(changed([](auto& l) { l.on = false; }).gain);
  EXPECT_TRUE(changed([](auto& l) { l.colour.cct_k = 3000.0; }).color);
  EXPECT_FALSE(changed([](auto& l) { l.colour.cct_k = 3000.0; }).needsRays());
  EXPECT_TRUE(changed([](auto& l) { l.group = "G"; }).group);
}

TEST(Diff, ADimmerOfALightThatIsOffChangesNothing) {
  Scene before = exampleScene();
  before.luminaires[0].on = false;
  Scene after = before;
  after.luminaires[0].dimming = 0.3;
  EXPECT_TRUE(diff(before, after).luminaires.empty());
}

TEST(Diff, NamesAddedAndRemovedLuminaires) {
  const Scene before = exampleScene();
  Scene after = before;
  after.luminaires.erase(after.luminaires.begin());
  after.luminaires.push_back(before.luminaires[0]);
  after.luminaires.back().name = "New";
  const auto changes = diff(before, after).luminaires;
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].name, "New");
  EXPECT_TRUE(changes[0].added);
  EXPECT_EQ(changes[1].name, "Panel");
  EXPECT_TRUE(changes[1].removed);
}

TEST(Diff, APaintIsAReflectanceAndNoGeometry) {
  const Scene before = exampleScene();
  Scene after = before;
  after.materials[1].diffuse = dvec3(0.2);
  const SceneDiff d = diff(before, after);
  EXPECT_EQ(d.reflectances, std::vector<std::size_t>{1});
  EXPECT_FALSE(d.geometry);
}

TEST(Diff, AMovedVertexIsGeometry) {
  const Scene before = exampleScene();
  Scene after = before;
  geometry::Mesh mesh = *before.mesh;
  mesh.positions[0].x = 0.25F;
  after.mesh = std::make_shared<const geometry::Mesh>(mesh);
  EXPECT_TRUE(diff(before, after).geometry);
}

TEST(Diff, TellsTheOtherSectionsApart) {
  const Scene before = exampleScene();
  const auto changed = [&](auto&& change) {
    Scene after = before;
    change(after);
    return diff(before, after);
  };
  EXPECT_TRUE(changed([](Scene& s) { s.layouts[1].edits["Panel"].on = false; }).layouts);
  EXPECT_TRUE(changed([](Scene& s) { s.cameras[0].target.x = 9; }).cameras);
  EXPECT_TRUE(changed([](Scene& s) { s.work_planes[0].nu = 9; }).work_planes);
  EXPECT_TRUE(changed([](Scene& s) { s.environment = Environment{"sky"}; }).environment);
  EXPECT_TRUE(changed([](Scene& s) { s.view.exposure = 1; }).view);
  EXPECT_TRUE(changed([](Scene& s) { s.quality.preset = "final"; }).quality);
  EXPECT_TRUE(changed([](Scene& s) { s.name = "Other"; }).name);
}

}  // namespace
}  // namespace soffit::scene
