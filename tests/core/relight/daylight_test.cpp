// SPDX-License-Identifier: MIT
#include "core/reference/estimate.h"
#include "core/relight/direct_light.h"
#include "core/relight/engine.h"
#include "core/relight/sky_cache.h"
#include "core/transfer/cache_key.h"
#include "tests/core/relight/readings.h"
#include "tests/core/relight/window_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

/// Sky, sun and glass in the engine against the path tracer and closed forms.
namespace soffit::relight::testing {
namespace {

std::vector<scene::Sensor> deskSensors() {
  auto sensors = grid({0.3, 0.4, 0.85}, {3.4, 0, 0}, {0, 4.3, 0}, 4, 5);
  sensors.push_back({{2.0, 5.0, 1.5}, {0, -1, 0}});
  sensors.push_back({{0.0, 2.0, 1.2}, {1, 0, 0}});
  sensors.push_back({{2.5, 2.5, 3.0}, {0, 0, -1}});
  return sensors;
}

struct Figures {
  double rms, bias, direct_rms, mean, noise;
};

/// Engine against path tracer at sensors, relative to the mean.
Figures compare(scene::Scene scene, const std::shared_ptr<const Solver>& solver,
                const std::vector<light::Luminaire>& luminaires,
                const std::vector<scene::Sensor>& sensors, double error) {
  Lighting lighting(solver);
  EXPECT_TRUE(lighting.setLuminaires(luminaires).ok());
  if (scene.environment) {
    EXPECT_TRUE(
        lighting.setEnvironment(std::make_shared<daylight::Environment>(*scene.environment)).ok());
  }
  const Readings found = read(lighting, sensors);
  const auto reference = reference::ReferenceScene::make(scene, luminaires).value();
  reference::EstimateOptions options;
  options.relative_error = error;
  const auto wanted = reference::estimate(reference, sensors, options).sensors;
  Figures out{};
  const auto n = static_cast<double>(sensors.size());
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const double total = found.direct[i] + found.indirect[i];
    out.mean += wanted[i].total / n;
    out.bias += (total - wanted[i].total) / n;
    out.rms += std::pow(total - wanted[i].total, 2.0) / n;
    out.direct_rms += std::pow(found.direct[i] - wanted[i].direct, 2.0) / n;
    out.noise += std::pow(wanted[i].standard_error, 2.0) / n;
  }
  // The reference's own noise is not the engine's: subtracted in squares (numerics.md, Measuring).
  out.rms = std::sqrt(std::max(0.0, out.rms - out.noise)) / out.mean;
  out.direct_rms = std::sqrt(std::max(0.0, out.direct_rms - out.noise)) / out.mean;
  out.bias /= out.mean;
  out.noise = std::sqrt(out.noise) / out.mean;
  printf("  mean %.1f lx, rms %.3f %%, bias %+.3f %%, direct rms %.3f %%, noise %.3f %%\n",
         out.mean, 100 * out.rms, 100 * out.bias, 100 * out.direct_rms, 100 * out.noise);
  return out;
}

scene::Environment sky(scene::Sky parameters) {
  return {"", parameters};
}

TEST(Daylight, AnOvercastSkyThroughGlassAgreesWithThePathTracer) {
  scene::Scene scene = windowRoom(true);
  scene.environment = sky({.cie = 1, .horizontal_illuminance = 10000.0, .ground_reflectance = 0.2});
  const Figures f = compare(scene, windowSolver(true), {}, deskSensors(), 0.005);
  EXPECT_LT(f.rms, 0.01);
  EXPECT_LT(f.direct_rms, 0.01);
  EXPECT_LT(std::abs(f.bias), 0.005);
}

TEST(Daylight, AnOpeningWithoutGlassIsTreatedAlike) {
  scene::Scene scene = windowRoom(false);
  scene.environment =
      sky({.cie = 16, .horizontal_illuminance = 10000.0, .ground_reflectance = 0.2});
  const Figures f = compare(scene, windowSolver(false), {}, deskSensors(), 0.01);
  EXPECT_LT(f.rms, 0.01);
  EXPECT_LT(f.direct_rms, 0.01);
  EXPECT_LT(std::abs(f.bias), 0.005);
}

TEST(Daylight, AClearSkyWithItsSunAgreesWithThePathTracer) {
  scene::Scene scene = windowRoom(true);
  // From the window's side, -y: azimuth 180; the sun reaches the floor and the desk.
  scene.environment = sky({.cie = 12,
                           .sun_azimuth_deg = 195.0,
                           .sun_altitude_deg = 40.0,
                           .horizontal_illuminance = 15000.0,
                           .direct_normal_illuminance = 70000.0,
                           .ground_reflectance = 0.15});
  // Away from the edge of the sun's patch, where lux per centimetre decide.
  std::vector<scene::Sensor> sensors = deskSensors();
  sensors.push_back({{2.0, 1.5, 0.0}, {0, 0, 1}});
  sensors.push_back({{2.2, 1.3, 0.0}, {0, 0, 1}});
  const Figures f = compare(scene, windowSolver(true), {}, sensors, 0.01);
  EXPECT_LT(f.rms, 0.015);
  EXPECT_LT(f.direct_rms, 0.01);
  EXPECT_LT(std::abs(f.bias), 0.01);
}

TEST(Daylight, LuminairesShineThroughAPartitionOfGlass) {
  // Two halves of a room, a pane from floor to ceiling between them; the lamp is in one.
  scene::Scene scene;
  auto mesh = emptyMesh();
  mesh->materials = {"wall", "glass"};
  addBox(*mesh, {0, 0, 0}, {4, 5, 3}, true, 0);
  addQuad(*mesh, {0, 2.5F, 0}, {4, 2.5F, 0}, {4, 2.5F, 3}, {0, 2.5F, 3}, 1);
  scene.mesh = mesh;
  scene.materials.resize(2);
  scene.materials[0].name = "wall";
  scene.materials[1].name = "glass";
  scene.materials[1].glass = scene::Glass{1.52, 0.8};
  light::Luminaire panel;
  panel.name = "P";
  panel.shape = light::Rectangle{0.6, 0.6};
  panel.position = {2.0, 1.2, 2.9};
  panel.flux = 3000.0;
  const auto far = grid({0.3, 2.8, 0.8}, {3.4, 0, 0}, {0, 2.0, 0}, 4, 3);
  const Figures f = compare(scene, solverOf(scene), {panel}, far, 0.006);
  EXPECT_LT(f.direct_rms, 0.005);
  // The image of the lamp in the pane lights the lamp's own half alone and is left out: less light.
  EXPECT_LT(f.rms, 0.025);
  EXPECT_GT(f.bias, -0.02);
  EXPECT_LT(f.bias, 0.005);
}

TEST(Daylight, DirectLightThroughGlassFollowsTheSlab) {
  scene::Scene scene;
  auto mesh = emptyMesh();
  mesh->materials = {"glass"};
  addQuad(*mesh, {-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1}, 0);
  scene.mesh = mesh;
  scene.materials.resize(1);
  scene.materials[0].glass = scene::Glass{1.52, 0.88};
  const auto fixed = makeStaticScene(scene);
  light::Luminaire lamp;
  lamp.shape = light::Sphere{0.02};
  lamp.position = {1.5, 0.0, 2.0};
  lamp.flux = 1000.0;
  const std::vector<vec3> p{vec3(0, 0, 0), vec3(1.5F, 0, 0), vec3(0, 0, 3)};
  const std::vector<vec3> n(3, vec3(0, 0, 1));
  const light::PreparedLight prepared(light::makeEmitter(lamp).value());
  const light::Receivers receivers = light::makeReceivers(p, n, 16);
  std::vector<float> with(receivers.slotCount());
  std::vector<float> without(receivers.slotCount());
  std::vector<std::uint8_t> lit(receivers.clusters.size());
  directLight(*fixed, prepared, receivers, {}, with, lit);
  light::directIlluminance(prepared, receivers, fixed->blockers, {}, without, lit);
  const daylight::Slab slab(*scene.materials[0].glass);
  const auto share = [&](std::size_t i) {
    return double(with[receivers.slot_of[i]]) / double(without[receivers.slot_of[i]]);
  };
  // Truncation: the slab over the lamp's half degree.
  EXPECT_NEAR(share(0), slab.at(0.8).transmitted, 1e-4);
  EXPECT_NEAR(share(1), 0.88, 1e-4);
  EXPECT_EQ(with[receivers.slot_of[2]], without[receivers.slot_of[2]]) << "above the pane";
}

TEST(Daylight, AnotherSkyTakesNoNewLook) {
  Lighting lighting(windowSolver(true));
  ASSERT_TRUE(lighting.setLuminaires({}).ok());
  const auto shine = [&](scene::Sky s) {
    EXPECT_TRUE(lighting.setEnvironment(std::make_shared<daylight::Environment>(sky(s))).ok());
    return lighting.total();
  };
  const Planes one = shine({.cie = 5, .horizontal_illuminance = 1000.0});
  const auto look = lighting.solver().openSky();
  const Planes two = shine({.cie = 5, .horizontal_illuminance = 2000.0});
  EXPECT_EQ(lighting.solver().openSky(), look);
  double worst = 0.0;
  double most = 0.0;
  for (std::size_t s = 0; s < one[1].size(); ++s) {
    worst = std::max(worst, std::abs(2.0 * double(one[1][s]) - double(two[1][s])));
    most = std::max(most, double(two[1][s]));
  }
  EXPECT_GT(most, 100.0);
  EXPECT_LT(worst, 1e-5 * most) << "linear up to rounding";
}

TEST(Daylight, SkyAndLuminairesAdd) {
  light::Luminaire panel;
  panel.name = "P";
  panel.shape = light::Rectangle{0.6, 0.6};
  panel.position = {2.0, 2.5, 2.9};
  panel.flux = 3000.0;
  const auto environment =
      std::make_shared<daylight::Environment>(sky({.cie = 3, .horizontal_illuminance = 5000.0}));
  const auto mean_of = [&](bool lamp, bool outside) {
    Lighting lighting(windowSolver(true));
    EXPECT_TRUE(lighting.setLuminaires(std::vector(lamp ? 1 : 0, panel)).ok());
    if (outside) {
      EXPECT_TRUE(lighting.setEnvironment(environment).ok());
    }
    const Readings r = read(lighting, deskSensors());
    return mean(r.direct) + mean(r.indirect);
  };
  EXPECT_NEAR(mean_of(true, true), mean_of(true, false) + mean_of(false, true),
              1e-5 * mean_of(true, true));
}

TEST(Daylight, WhoHasNoGlassAndNoSkyPaysNothing) {
  scene::Scene scene = windowRoom(false);
  scene.materials[1].glass.reset();
  const auto fixed = makeStaticScene(scene);
  EXPECT_EQ(fixed->panes, nullptr);
  EXPECT_TRUE(fixed->pane_faces.empty());
  const std::string before = transfer::cacheKey(*fixed, quickSettings());
  scene.environment = sky({.cie = 1, .horizontal_illuminance = 1e4});
  EXPECT_EQ(transfer::cacheKey(*makeStaticScene(scene), quickSettings()), before)
      << "the bake knows of no sky";
  Lighting lighting(windowSolver(false));
  ASSERT_TRUE(lighting.setLuminaires({}).ok());
  ASSERT_TRUE(lighting.setEnvironment(nullptr).ok());
  EXPECT_EQ(lighting.environment(), nullptr);
  EXPECT_TRUE(lighting.skyDirect()[0].empty());
}

TEST(Daylight, TheBakeKnowsItsGlass) {
  scene::Scene scene = windowRoom(true);
  const std::string before = transfer::cacheKey(*makeStaticScene(scene), quickSettings());
  scene.materials[0].diffuse = dvec3(0.1);
  EXPECT_EQ(transfer::cacheKey(*makeStaticScene(scene), quickSettings()), before);
  scene.materials[1].glass->transmittance = 0.5;
  EXPECT_NE(transfer::cacheKey(*makeStaticScene(scene), quickSettings()), before);
}

TEST(Daylight, ALookIsKeptAndFoundAgain) {
  const auto open = windowSolver(true)->openSky();
  const auto folder = std::filesystem::temp_directory_path() / "soffit-daylight-test";
  const auto path = folder / "one-sky.bake";
  std::filesystem::remove_all(folder);
  EXPECT_EQ(readSky(path, open->normals()), nullptr) << "not there yet";
  writeSky(path, *open);
  const auto again = readSky(path, open->normals());
  ASSERT_NE(again, nullptr);
  EXPECT_EQ(again->found().first, open->found().first);
  EXPECT_EQ(again->found().leaves, open->found().leaves);
  std::vector<vec3> others(open->normals().begin(), open->normals().end());
  others[0] = -others[0];
  EXPECT_EQ(readSky(path, others), nullptr) << "other receivers";
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(200);
  file.put('x');
  file.close();
  EXPECT_EQ(readSky(path, open->normals()), nullptr) << "damaged";
  std::filesystem::resize_file(path, 150);
  EXPECT_EQ(readSky(path, open->normals()), nullptr) << "cut short";
  std::filesystem::remove_all(folder);
}

TEST(Daylight, ACancelledLookLeavesNoSky) {
  std::stop_source stop;
  stop.request_stop();
  Lighting lighting(solverOf(windowRoom(false)));
  const auto done = lighting.setEnvironment(
      std::make_shared<daylight::Environment>(sky({.cie = 5, .horizontal_illuminance = 1.0})),
      Job{nullptr, stop.get_token()});
  EXPECT_FALSE(done.ok());
  EXPECT_EQ(lighting.environment(), nullptr);
}

}  // namespace
}  // namespace soffit::relight::testing
