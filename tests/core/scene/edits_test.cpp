// SPDX-License-Identifier: MIT
#include "core/scene/edits.h"

#include "core/scene/equality.h"
#include "tests/core/scene/example_scene.h"

#include <gtest/gtest.h>

namespace soffit::scene {
namespace {

TEST(EditBetween, AppliedLeadsFromOneToTheOther) {
  const Scene scene = exampleScene();
  light::Luminaire to = scene.luminaires[1];
  to.name = scene.luminaires[0].name;
  to.colour.cct_k = 2700.0;
  to.distribution.kind = light::DistributionKind::isotropic;
  to.casts_shadow = true;
  to.rotation_deg = {0, 90, 0};
  to.scale = 2.0;
  to.on = false;
  to.group = "Evening";
  const LuminaireEdit edit = editBetween(scene.luminaires[0], to);
  EXPECT_TRUE(same(applyEdit(scene.luminaires[0], edit), to));
}

TEST(EditBetween, OfEqualLuminairesIsEmpty) {
  const Scene scene = exampleScene();
  EXPECT_TRUE(isEmpty(editBetween(scene.luminaires[0], scene.luminaires[0])));
}

TEST(WithEdit, OfALayoutLeavesTheBaseAlone) {
  const Scene scene = exampleScene();
  LuminaireEdit edit;
  edit.position = dvec3(5, 5, 5);
  const auto edited = withEdit(scene, "Evening", "Panel", edit);
  ASSERT_TRUE(edited);
  EXPECT_EQ(edited->luminaires[0].position, dvec3(1, 2, 3));
  const auto resolved = resolveLayout(*edited, edited->layouts[1]);
  EXPECT_EQ(resolved[0].position, dvec3(5, 5, 5));
  EXPECT_EQ(resolved[0].dimming, 0.25) << "what the layout named before stays";
}

TEST(WithEdit, OfTheBaseShowsInEveryLayout) {
  const Scene scene = exampleScene();
  LuminaireEdit edit;
  edit.flux = 1.0;
  const auto edited = withEdit(scene, "", "Panel", edit);
  ASSERT_TRUE(edited);
  EXPECT_EQ(resolveLayout(*edited, edited->layouts[1])[0].flux, 1.0);
}

TEST(WithEdit, RefusesUnknownNames) {
  const Scene scene = exampleScene();
  const auto no_layout = withEdit(scene, "Noon", "Panel", {});
  ASSERT_FALSE(no_layout);
  EXPECT_EQ(no_layout.error().message(),
            "layouts: there is no layout named 'Noon'. Choose one of: Base, Evening.");
  const auto no_luminaire = withEdit(scene, "Base", "Candle", {});
  ASSERT_FALSE(no_luminaire);
  EXPECT_EQ(
      no_luminaire.error().message(),
      "luminaires: there is no luminaire named 'Candle'. Check the spelling, or add it first.");
  Scene bare = scene;
  bare.layouts.clear();
  EXPECT_EQ(withEdit(bare, "Noon", "Panel", {}).error().hint, "The project has no layouts.");
}

TEST(WithLuminaire, OfALayoutAloneIsCompleteThere) {
  const Scene scene = exampleScene();
  light::Luminaire spot;
  spot.name = "Spot";
  spot.shape = light::Disk{0.05};
  spot.flux = 600.0;
  const auto edited = withLuminaire(scene, "Base", spot);
  ASSERT_TRUE(edited);
  const auto resolved = resolveLayout(*edited, edited->layouts[0]);
  ASSERT_EQ(resolved.size(), 3U);
  EXPECT_TRUE(same(resolved[2], spot));
  EXPECT_EQ(resolveLayout(*edited, edited->layouts[1]).size(), 3U);
}

TEST(WithLuminaire, RefusesTakenAndEmptyNames) {
  const Scene scene = exampleScene();
  light::Luminaire candle;
  candle.name = "Candle";  // of a layout, taken all the same
  EXPECT_EQ(withLuminaire(scene, "", candle).error().what, "the name 'Candle' is taken");
  candle.name.clear();
  EXPECT_EQ(withLuminaire(scene, "", candle).error().what, "the name is empty");
}

TEST(WithoutLuminaire, LeavesNoEditBehind) {
  const auto edited = withoutLuminaire(exampleScene(), "Panel");
  ASSERT_TRUE(edited);
  EXPECT_EQ(edited->luminaires.size(), 1U);
  EXPECT_FALSE(edited->layouts[1].edits.contains("Panel"));
  EXPECT_FALSE(withoutLuminaire(*edited, "Panel"));
}

TEST(WithLuminaireRenamed, KeepsTheEditsOfLayouts) {
  const auto edited = withLuminaireRenamed(exampleScene(), "Panel", "Panel A");
  ASSERT_TRUE(edited);
  EXPECT_EQ(edited->luminaires[0].name, "Panel A");
  EXPECT_EQ(edited->layouts[1].edits.at("Panel A").dimming, 0.25);
  EXPECT_FALSE(withLuminaireRenamed(exampleScene(), "Panel", "Lamp"));
  EXPECT_FALSE(withLuminaireRenamed(exampleScene(), "Nobody", "Lamp 2"));
}

TEST(WithLayout, CopiesTheEditsOfItsSource) {
  const auto edited = withLayout(exampleScene(), "Night", "Evening");
  ASSERT_TRUE(edited);
  ASSERT_EQ(edited->layouts.size(), 3U);
  EXPECT_EQ(edited->layouts[2].name, "Night");
  EXPECT_EQ(edited->layouts[2].edits.size(), 2U);
  EXPECT_EQ(withLayout(exampleScene(), "Base", "").error().what, "the name 'Base' is taken");
  EXPECT_EQ(withLayout(exampleScene(), "", "").error().what, "the name is empty");
  EXPECT_FALSE(withLayout(exampleScene(), "Night", "Noon"));
}

TEST(FreeLuminaireName, CountsUp) {
  const Scene scene = exampleScene();
  EXPECT_EQ(freeLuminaireName(scene, "Spot"), "Spot");
  EXPECT_EQ(freeLuminaireName(scene, "Panel"), "Panel 2");
  EXPECT_EQ(freeLuminaireName(scene, "Candle"), "Candle 2");
  EXPECT_EQ(freeLuminaireName(scene, ""), "Luminaire 2");
}

}  // namespace
}  // namespace soffit::scene
