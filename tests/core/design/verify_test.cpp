// SPDX-License-Identifier: MIT
#include "core/design/verify.h"

#include "tests/core/design/scenes.h"

#include <gmock/gmock.h>

namespace soffit::design {
namespace {

using namespace testing;
using ::testing::HasSubstr;

VerifyOptions quickOptions() {
  VerifyOptions options;
  options.receivers = 60;
  options.sensor_rays = 32;
  options.effort.error = 0.03;
  return options;
}

TEST(Verify, FindsTheEngineRightInAPlainRoom) {
  const scene::Scene scene = blockRoom();
  const auto report = verify(solverOf(scene), scene, quickOptions());
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->reached);
  EXPECT_GT(report->rays, 0U);
  const ErrorFigures& f = report->total.receivers;
  EXPECT_EQ(f.receivers, 60U);
  EXPECT_GT(f.mean_lux, 1.0);
  // 3 % of the larger of a value and a twentieth of the mean bounds the RMS of the noise by 3 %
  // of the RMS over mean, here below 2.
  EXPECT_LT(f.reference_stderr, 0.06);
  EXPECT_GT(f.reference_stderr, 0.001);
  // Coarse settings err by a few percent; what is tested is that both look at the same scene.
  EXPECT_LT(f.rms, 0.08);
  EXPECT_LT(std::abs(f.bias), 0.03);
  ASSERT_TRUE(report->total.work_planes.has_value());
  EXPECT_EQ(report->total.work_planes->receivers, 6U);
  EXPECT_LT(report->total.work_planes->rms, 0.08);
  ASSERT_EQ(report->total.planes.size(), 1U);
  EXPECT_EQ(report->total.planes[0].name, "Table");
  EXPECT_TRUE(report->total.zones.empty());  // one room
  EXPECT_FALSE(report->luminaire.has_value());
}

TEST(Verify, NoticesAnEngineThatIsWrong) {
  // The engine bakes and solves another room than the one that is verified: gray of 0.5 and 0.1.
  scene::Scene scene = blockRoom();
  const auto solver = solverOf(scene);
  scene.materials[0].diffuse = dvec3(0.1);
  const auto report = verify(solver, scene, quickOptions());
  ASSERT_TRUE(report.ok());
  EXPECT_GT(report->total.receivers.bias, 0.2);
  EXPECT_GT(report->total.receivers.rms, 0.2);
}

TEST(Verify, JudgesEachRoomByItsOwnMean) {
  const scene::Scene scene = twoRooms();
  const auto report = verify(solverOf(scene), scene, quickOptions());
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->total.zones.size(), 2U);
  EXPECT_EQ(report->total.zones[0].name, "Left");
  EXPECT_EQ(report->total.zones[1].name, "Right");
  EXPECT_GT(report->total.zones[0].figures.mean_lux, 5.0 * report->total.zones[1].figures.mean_lux);
  // The dark room's reference was driven to its own mean.
  EXPECT_LT(report->total.zones[1].figures.reference_stderr, 0.06);
}

TEST(Verify, ReportsOneLuminaireAlongAPath) {
  scene::Scene scene = blockRoom();
  scene.luminaires.push_back(relight::testing::panel({1.0, 4.0, 2.9}));
  scene.luminaires[1].name = "Second";
  VerifyOptions options = quickOptions();
  options.receivers = 30;
  options.luminaire = "Second";
  options.path = {{1.0, 4.0, 2.9}, {3.0, 4.0, 2.0}};
  const auto report = verify(solverOf(scene), scene, options);
  ASSERT_TRUE(report.ok());
  ASSERT_TRUE(report->luminaire.has_value());
  EXPECT_EQ(report->luminaire->name, "Second");
  ASSERT_EQ(report->luminaire->positions.size(), 2U);
  EXPECT_EQ(report->luminaire->alone.receivers.receivers, 60U);
  const auto& home = report->luminaire->positions[0];
  // Alone it gives about half of the light; where it stands, both together are the total.
  EXPECT_LT(home.alone.receivers.mean_lux, 0.7 * home.total.receivers.mean_lux);
  EXPECT_NEAR(home.total.receivers.mean_lux, report->total.receivers.mean_lux,
              0.03 * report->total.receivers.mean_lux);
  EXPECT_LT(report->luminaire->alone.receivers.rms, 0.1);
  EXPECT_LT(report->luminaire->positions[1].total.receivers.rms, 0.1);
}

TEST(Verify, TakesSensorsInsteadOfSurfaces) {
  const scene::Scene scene = blockRoom();
  VerifyOptions options = quickOptions();
  options.sensors = {{{3.0, 1.0, 0.8}, {0, 0, 1}}, {{3.0, 4.0, 1.2}, {0, 1, 0}}};
  const auto report = verify(solverOf(scene), scene, options);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->total.receivers.receivers, 2U);
  EXPECT_FALSE(report->total.work_planes.has_value());
}

TEST(Verify, StopsAtTheTimeLimitWithWhatItHas) {
  const scene::Scene scene = blockRoom();
  VerifyOptions options = quickOptions();
  options.effort.error = 1e-5;
  options.effort.time_limit_s = 0.2;
  const auto report = verify(solverOf(scene), scene, options);
  ASSERT_TRUE(report.ok());
  EXPECT_FALSE(report->reached);
  EXPECT_GT(report->total.receivers.mean_lux, 0.0);
}

TEST(Verify, SaysWhichLuminairesThereAre) {
  const scene::Scene scene = blockRoom();
  VerifyOptions options = quickOptions();
  options.luminaire = "Sun";
  const auto report = verify(solverOf(scene), scene, options);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().message(), "luminaires: there is no luminaire \"Sun\". It has: Panel.");
}

TEST(Verify, SaysWhenNothingIsLit) {
  scene::Scene scene = blockRoom();
  scene.luminaires.clear();
  scene.work_planes.clear();
  const auto report = verify(solverOf(scene), scene, quickOptions());
  ASSERT_FALSE(report.ok());
  EXPECT_THAT(report.error().message(), HasSubstr("no surface of the project is lit"));
}

TEST(Verify, CanBeCancelled) {
  const scene::Scene scene = blockRoom();
  std::stop_source stop;
  stop.request_stop();
  const auto solver = solverOf(scene);
  const auto report = verify(solver, scene, quickOptions(), {nullptr, stop.get_token()});
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.error().what, "cancelled");
}

}  // namespace
}  // namespace soffit::design
