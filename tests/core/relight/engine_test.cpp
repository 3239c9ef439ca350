// SPDX-License-Identifier: MIT
#include "core/relight/engine.h"

#include "tests/core/relight/readings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace soffit::relight {
namespace {

using ::testing::HasSubstr;

Error errorOf(const scene::Quality& quality) {
  const auto result = qualitySettings(quality);
  EXPECT_FALSE(result.ok());
  return result.ok() ? Error{} : result.error();
}

TEST(QualitySettings, PresetsGrowWithTheirNames) {
  const auto draft = qualitySettings({"draft", {}});
  const auto interactive = qualitySettings({"interactive", {}});
  const auto final_quality = qualitySettings({"final", {}});
  ASSERT_TRUE(draft.ok() && interactive.ok() && final_quality.ok());
  EXPECT_LT(draft->bake.texels, interactive->bake.texels);
  EXPECT_LT(interactive->bake.texels, final_quality->bake.texels);
  EXPECT_GE(draft->bake.tolerance, interactive->bake.tolerance);
  EXPECT_GE(interactive->bake.tolerance, final_quality->bake.tolerance);
  EXPECT_LT(draft->sensor_rays, final_quality->sensor_rays);
  const auto unnamed = qualitySettings({"", {}});
  ASSERT_TRUE(unnamed.ok());
  EXPECT_EQ(unnamed->bake.texels, interactive->bake.texels);
}

TEST(QualitySettings, SingleSettingsOverrideThePreset) {
  const auto q = qualitySettings({"draft",
                                  {{"texels", 1234},
                                   {"least_cell", 0.05},
                                   {"patch", 64},
                                   {"node_rays", 6},
                                   {"trainings", 40},
                                   {"field_rays", 10},
                                   {"list_rays", 20},
                                   {"max_rank", 9},
                                   {"tolerance", 0.1},
                                   {"sensor_rays", 12}}});
  ASSERT_TRUE(q.ok());
  EXPECT_EQ(q->bake.texels, 1234);
  EXPECT_EQ(q->bake.least_cell, 0.05);
  EXPECT_EQ(q->bake.patch, 64U);
  EXPECT_EQ(q->bake.node_rays, 6);
  EXPECT_EQ(q->bake.trainings, 40);
  EXPECT_EQ(q->bake.field_rays, 10);
  EXPECT_EQ(q->bake.list_rays, 20);
  EXPECT_EQ(q->bake.max_rank, 9);
  EXPECT_EQ(q->bake.tolerance, 0.1);
  EXPECT_EQ(q->sensor_rays, 12);
}

TEST(QualitySettings, SayWhatIsWrong) {
  const Error preset = errorOf({"best", {}});
  EXPECT_EQ(preset.place, "quality");
  EXPECT_EQ(preset.what, "there is no quality \"best\"");
  EXPECT_EQ(preset.hint, "Choose draft, interactive or final.");
  const Error name = errorOf({"draft", {{"texel", 1000}}});
  EXPECT_EQ(name.place, "quality.texel");
  EXPECT_EQ(name.what, "there is no such setting");
  EXPECT_THAT(name.hint, HasSubstr("texels"));
  for (const double value : {0.0, -5.0, 1e9, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    const Error range = errorOf({"draft", {{"texels", value}}});
    EXPECT_EQ(range.place, "quality.texels");
    EXPECT_THAT(range.what, HasSubstr("expected 100 to "));
    EXPECT_EQ(range.hint, "Choose a value in that range, or leave the setting out.");
  }
}

scene::Scene smallScene() {
  scene::Scene scene;
  scene.mesh = testing::blockRoom();
  scene.materials.resize(1);
  scene.luminaires = {testing::panel({2, 2.5, 2.9})};
  return scene;
}

TEST(QualitySettings, TakeAMethodOfDirectLightWithItsNumbers) {
  scene::Quality quality;
  EXPECT_FALSE(qualitySettings(quality)->local);
  quality.methods["direct"] = "exact";
  EXPECT_FALSE(qualitySettings(quality)->local);
  quality.methods["direct"] = "cubes";
  quality.settings = {{"bands", 7}, {"cube_side", 24}};
  const auto cubes = qualitySettings(quality);
  ASSERT_TRUE(cubes.ok());
  ASSERT_TRUE(cubes->local);
  EXPECT_EQ(cubes->local->method, prt::LocalMethod::cubes);
  EXPECT_EQ(cubes->local->bands, 7);
  EXPECT_EQ(cubes->local->cube_side, 24);
  quality.methods["direct"] = "magic";
  const auto unknown = qualitySettings(quality);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(
      unknown.error().message(),
      "quality.direct: there is no method \"magic\". Choose one of: exact, harmonics, cubes.");
  quality.methods = {{"texels", "many"}};
  const auto text = qualitySettings(quality);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.error().place, "quality.texels");
  EXPECT_EQ(text.error().what, "expected a number, found \"many\"");
}

TEST(QualitySettings, ListSaysWhatEachIs) {
  scene::Quality quality;
  quality.preset = "draft";
  quality.methods["direct"] = "harmonics";
  quality.settings["reach"] = 2.5;
  const auto list = listSettings(quality);
  ASSERT_TRUE(list.ok());
  const auto named = [&](const std::string& name) {
    return *std::find_if(list->begin(), list->end(),
                         [&](const SettingInfo& s) { return s.name == name; });
  };
  EXPECT_EQ(named("texels").value, 16000.0);
  EXPECT_TRUE(named("texels").whole);
  EXPECT_FALSE(named("texels").of_method);
  EXPECT_EQ(named("reach").value, 2.5);
  EXPECT_TRUE(named("reach").of_method);
  EXPECT_FALSE(named("reach").whole);
}

// The papers' methods light the same room: within what their few bands resolve.
TEST(MakeSolver, OtherMethodsOfDirectLightComeNearTheExactOne) {
  scene::Scene scene = smallScene();
  scene.quality.settings = {{"texels", 1500},  {"trainings", 8}, {"field_rays", 8},
                            {"list_rays", 16}, {"node_rays", 4}, {"max_rank", 8}};
  const auto light = [&](const char* method) {
    scene.quality.methods["direct"] = method;
    EngineReport report;
    const auto solver = makeSolver(scene, *qualitySettings(scene.quality), false, {}, report);
    EXPECT_TRUE(solver.ok());
    Lighting lighting(*solver);
    EXPECT_TRUE(lighting.setLuminaires(scene.luminaires).ok());
    return std::pair(lighting.total()[1], *solver);
  };
  const auto [exact, solver] = light("exact");
  const std::vector<float>& area = solver->operators().area;
  for (const char* method : {"harmonics", "cubes"}) {
    const auto [found, other] = light(method);
    ASSERT_NE(other->directMethod(), nullptr);
    double sum = 0.0;
    double mean = 0.0;
    double whole = 0.0;
    for (std::size_t s = 0; s < exact.size(); ++s) {
      const double a = area[s];
      sum += a * std::pow(double{found[s]} - exact[s], 2);
      mean += a * exact[s];
      whole += a;
    }
    const double rms = std::sqrt(sum / whole) / (mean / whole);
    EXPECT_LT(rms, 0.5) << method;
    EXPECT_GT(rms, 1e-4) << method << " is another method";
  }
}

TEST(MakeSolver, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  EngineReport report;
  const auto solver = makeSolver(smallScene(), {}, false, {nullptr, stop.get_token()}, report);
  ASSERT_FALSE(solver.ok());
  EXPECT_EQ(solver.error().what, "cancelled");
}

TEST(Lighting, SettingLuminairesCanBeCancelled) {
  auto settings = testing::quickSettings();
  settings.texels = 500;
  Lighting lighting(testing::solverFor(testing::blockRoom(), {dvec3(0.5)}, settings));
  std::stop_source stop;
  stop.request_stop();
  const auto set = lighting.setLuminaires(smallScene().luminaires, {nullptr, stop.get_token()});
  ASSERT_FALSE(set.ok());
  EXPECT_EQ(set.error().place, "light");
  EXPECT_EQ(set.error().what, "cancelled");
}

TEST(Lighting, ABrokenLuminaireIsNamed) {
  auto settings = testing::quickSettings();
  settings.texels = 500;
  Lighting lighting(testing::solverFor(testing::blockRoom(), {dvec3(0.5)}, settings));
  auto luminaires = smallScene().luminaires;
  luminaires[0].flux = -1.0;
  const auto set = lighting.setLuminaires(luminaires);
  ASSERT_FALSE(set.ok());
  EXPECT_THAT(set.error().message(), HasSubstr("flux"));
  EXPECT_TRUE(lighting.emitters().empty());  // nothing is half set
}

TEST(FreeSpace, HasDirectLightAlone) {
  scene::Scene scene;
  scene.mesh = std::make_shared<geometry::Mesh>();
  scene.luminaires = {testing::panel({0, 0, 2})};
  EngineReport report;
  const auto solver = makeSolver(scene, {}, false, {}, report);
  ASSERT_TRUE(solver.ok());
  const std::vector<scene::Sensor> sensors = {{{0, 0, 0}, {0, 0, 1}}};
  const testing::Readings found = testing::readIn(*solver, scene.luminaires, sensors);
  // 1000 lm over 0.36 m^2 at 2 m on the axis: L times the configuration factor of a square (Howell
  // B-4).
  const double a = 0.3 / 2.0;
  const double f = 4 * 2 * a / std::sqrt(1 + a * a) * std::atan(a / std::sqrt(1 + a * a)) /
                   (2 * 3.14159265358979);
  EXPECT_NEAR(found.direct[0], 1000.0 / 0.36 * f, 1e-5 * found.direct[0]);
  EXPECT_EQ(found.indirect[0], 0.0);
}

}  // namespace
}  // namespace soffit::relight
