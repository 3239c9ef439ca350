// SPDX-License-Identifier: MIT
#include "core/scene/layout_edits.h"

#include "core/scene/edits.h"
#include "tests/core/scene/example_scene.h"

#include <gmock/gmock.h>

namespace soffit::scene {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> namesOf(const Scene& scene) {
  std::vector<std::string> names;
  for (const Layout& layout : scene.layouts) names.push_back(layout.name);
  return names;
}

Scene threeLayouts() {
  Scene scene = exampleScene();
  scene.layouts = {{"A", {}}, {"B", {}}, {"C", {}}};
  scene.layouts[1].edits["Panel"].dimming = 0.5;
  return scene;
}

TEST(LayoutEdits, RenameKeepsWhatTheLayoutSays) {
  const auto renamed = withLayoutRenamed(threeLayouts(), "B", "Evening");
  ASSERT_TRUE(renamed);
  EXPECT_THAT(namesOf(*renamed), ElementsAre("A", "Evening", "C"));
  EXPECT_EQ(renamed->layouts[1].edits.at("Panel").dimming, 0.5);
  EXPECT_TRUE(withLayoutRenamed(threeLayouts(), "B", "B").ok());
}

TEST(LayoutEdits, RemoveAndMove) {
  EXPECT_THAT(namesOf(*withoutLayout(threeLayouts(), "B")), ElementsAre("A", "C"));
  EXPECT_THAT(namesOf(*withLayoutAt(threeLayouts(), "C", 0)), ElementsAre("C", "A", "B"));
  EXPECT_THAT(namesOf(*withLayoutAt(threeLayouts(), "A", 1)), ElementsAre("B", "A", "C"));
  EXPECT_THAT(namesOf(*withLayoutAt(threeLayouts(), "A", 99)), ElementsAre("B", "C", "A"));
}

TEST(LayoutEdits, FaultsAreTold) {
  EXPECT_EQ(withLayoutRenamed(threeLayouts(), "B", "C").error().what, "the name 'C' is taken");
  EXPECT_EQ(withLayoutRenamed(threeLayouts(), "B", "").error().what, "the name is empty");
  EXPECT_EQ(withLayoutRenamed(threeLayouts(), "X", "Y").error().what,
            "there is no layout named 'X'");
  EXPECT_FALSE(withoutLayout(threeLayouts(), "X").ok());
  EXPECT_FALSE(withLayoutAt(threeLayouts(), "X", 0).ok());
}

TEST(LayoutEdits, FreeNamesCountOn) {
  EXPECT_EQ(freeLayoutName(threeLayouts(), "A"), "A 2");
  Scene scene = threeLayouts();
  scene.layouts.push_back({"A 2", {}});
  EXPECT_EQ(freeLayoutName(scene, "A 2"), "A 3");
}

}  // namespace
}  // namespace soffit::scene
