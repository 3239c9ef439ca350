// SPDX-License-Identifier: MIT
#include "core/design/compare.h"

#include "tests/core/design/scenes.h"

#include <gmock/gmock.h>

namespace soffit::design {
namespace {

using namespace testing;
using ::testing::HasSubstr;

TEST(CompareLayouts, GivesLightAndFluxOfEach) {
  const scene::Scene scene = blockRoom();
  std::vector<LayoutCase> layouts(3, {"As planned", scene.luminaires});
  layouts[1].name = "Half";
  layouts[1].luminaires[0].dimming = 0.5;
  layouts[2].name = "Two";
  layouts[2].luminaires.push_back(relight::testing::panel({1, 1, 2.9}, 0.6, 500.0));
  const auto figures = compareLayouts(solverOf(scene), scene.work_planes, layouts, 32, 1, {});
  ASSERT_TRUE(figures.ok());
  ASSERT_EQ(figures->size(), 3U);
  const auto& all = *figures;
  ASSERT_EQ(all[0].planes.size(), 1U);
  EXPECT_EQ(all[0].planes[0].lux.count, 6U);
  EXPECT_DOUBLE_EQ(all[0].emitted_lm, 1000.0);
  EXPECT_DOUBLE_EQ(all[1].emitted_lm, 500.0);
  EXPECT_DOUBLE_EQ(all[1].installed_lm, 1000.0);
  EXPECT_DOUBLE_EQ(all[2].installed_lm, 1500.0);
  EXPECT_EQ(all[2].luminaires_on, 2U);
  EXPECT_DOUBLE_EQ(all[0].lm_per_m2, 1000.0 / 3.0);
  // Linear: half the dimming, half the light; single precision in the light's columns.
  EXPECT_NEAR(all[1].planes[0].lux.mean, 0.5 * all[0].planes[0].lux.mean,
              1e-5 * all[0].planes[0].lux.mean);
  EXPECT_GT(all[2].planes[0].lux.mean, all[0].planes[0].lux.mean);
}

TEST(CompareLayouts, KeepsTheLightOfWhatStays) {
  const scene::Scene scene = blockRoom();
  std::vector<LayoutCase> layouts(2, {"A", scene.luminaires});
  layouts[1].luminaires.push_back(relight::testing::panel({1, 1, 2.9}));
  std::vector<std::uint64_t> points;
  const auto figures = compareLayouts(
      solverOf(scene), scene.work_planes, layouts, 16, 1, {},
      [&](std::size_t, const std::shared_ptr<const relight::Lighting>& lighting) -> Result<void> {
        points.push_back(lighting->counts().points);
        return {};
      });
  ASSERT_TRUE(figures.ok());
  EXPECT_EQ((*figures)[0].lights_computed, 1U);
  EXPECT_EQ((*figures)[1].lights_computed, 1U);
  ASSERT_EQ(points.size(), 2U);
  // The second layout computed one light as well, not two.
  EXPECT_LT(points[1] - points[0], 1.5 * static_cast<double>(points[0]));
}

TEST(CompareLayouts, NamesTheLayoutOfAFault) {
  const scene::Scene scene = blockRoom();
  std::vector<LayoutCase> layouts{{"Broken", scene.luminaires}};
  layouts[0].luminaires[0].shape = light::Rectangle{0.0, 1.0};
  const auto figures = compareLayouts(solverOf(scene), scene.work_planes, layouts, 16, 1, {});
  ASSERT_FALSE(figures.ok());
  EXPECT_THAT(figures.error().message(), HasSubstr("layouts.Broken"));
}

TEST(CompareLayouts, PassesTheVisitorsErrorOn) {
  const scene::Scene scene = blockRoom();
  const std::vector<LayoutCase> layouts{{"A", scene.luminaires}};
  const auto figures = compareLayouts(
      solverOf(scene), {}, layouts, 16, 1, {},
      [](std::size_t, const std::shared_ptr<const relight::Lighting>&) -> Result<void> {
        return Error{"picture", "disk full", ""};
      });
  ASSERT_FALSE(figures.ok());
  EXPECT_EQ(figures.error().what, "disk full");
}

}  // namespace
}  // namespace soffit::design
