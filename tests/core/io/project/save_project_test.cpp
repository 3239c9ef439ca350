// SPDX-License-Identifier: MIT
#include "core/io/project/json.h"
#include "core/io/project/project.h"
#include "core/scene/diff.h"
#include "core/scene/edits.h"
#include "core/scene/equality.h"
#include "tests/core/io/project/example_project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

namespace soffit::io {
namespace {

/// A loaded project in a folder of its own.
struct Saved : ProjectFolder {
  explicit Saved(const std::string& text = kFullProject) : project(load(text).value()) {}

  /// Saves, loads again, and expects the same scene.
  Project roundTrip() {
    const auto saved = saveProject(project, project.path);
    EXPECT_TRUE(saved) << saved.error().message();
    auto again = loadProject(project.path);
    EXPECT_TRUE(again) << again.error().message();
    EXPECT_FALSE(scene::diff(project.scene, again->scene).any());
    return *again;
  }
  [[nodiscard]] Json json() const { return *parseJson(read("p.soffit"), "p"); }

  Project project;
};

TEST(SaveProject, AnUntouchedProjectKeepsItsContentAndSpelling) {
  Saved folder;
  const Json before = folder.json();
  folder.roundTrip();
  EXPECT_EQ(folder.json(), before);
  EXPECT_EQ(folder.read("p.soffit"), formatJson(before)) << "same order, same spelling of numbers";
  EXPECT_EQ(folder.read("p.soffit~"), kFullProject) << "the previous version, comments and all";
}

TEST(SaveProject, WritesOnlyWhatChanged) {
  Saved folder;
  Json expected = folder.json();
  folder.project.scene.luminaires[0].position = {2.5, 1.5, 2.75};
  folder.project.scene.luminaires[1].flux = 123.456;
  (*expected["luminaires"].asArray())[0]["position"] = Json::array({2.5, 1.5, 2.75});
  (*expected["luminaires"].asArray())[1]["flux"] = 123.456;
  folder.roundTrip();
  EXPECT_EQ(folder.read("p.soffit"), formatJson(expected));
}

TEST(SaveProject, DoublesAreLossless) {
  Saved folder;
  folder.project.scene.luminaires[0].position = {0.1 + 0.2, 1.0 / 3.0, 1e-17};
  folder.project.scene.cameras[0].target = {std::nextafter(1.0, 2.0), 5e-324,
                                            std::nextafter(-1e7, 0.0)};
  folder.project.scene.view.exposure = 0.1F;
  folder.roundTrip();  // compares without tolerance
}

TEST(SaveProject, EverySectionSurvivesAnEdit) {
  Saved folder;
  scene::Scene& scene = folder.project.scene;
  scene.name = "Renamed";
  scene.luminaires[0].shape = light::Polygon{{{0, 0}, {1, 0}, {0.5, 0.7}}};
  scene.luminaires[0].colour = light::Colour{std::nullopt, {1, 0.5, 0.25}};
  scene.luminaires[0].rotation_deg = {0, 45, 0};
  scene.luminaires[1].on = false;
  scene.layouts[1].edits["Panel 1"].shape = light::Tube{1.5, 0.01};
  scene.layouts[1].edits.erase("Candle");
  scene.layouts[0].edits["Spot 1.2"].dimming = 0.5;
  scene.cameras.push_back({"Second", {0, 0, 1}, {1, 1, 1}, 40});
  scene.work_planes[0].nu = 3;
  scene.view.ocio_look = "Contrast";
  scene.quality.settings["gather_rays"] = 100;
  scene.materials[0].diffuse = {0.11, 0.22, 0.33};
  scene.materials[1].roughness = 0.9;
  folder.project.geometry[0].rotate_deg = {0, 0, 90};
  const auto saved = saveProject(folder.project, folder.project.path);
  ASSERT_TRUE(saved) << saved.error().message();
  const auto again = loadProject(folder.project.path);
  ASSERT_TRUE(again) << again.error().message();
  scene::SceneDiff difference = scene::diff(scene, again->scene);
  EXPECT_TRUE(difference.geometry) << "it was turned";
  difference.geometry = false;
  EXPECT_FALSE(difference.any());
  EXPECT_EQ(again->geometry[0].rotate_deg, dvec3(0, 0, 90));
}

TEST(SaveProject, ARoughnessMapIsWrittenAndReadAgain) {
  Saved folder;
  folder.write("rough.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                                std::string("\x80\x40\x80\x80\x80\x20\x80\x80", 8));
  folder.project.scene.materials[1].roughness_map = "rough.hdr";
  ASSERT_TRUE(saveProject(folder.project, folder.project.path));
  EXPECT_EQ(folder.json()["materials"]["wall"]["roughness_map"], Json("rough.hdr"));
  const auto again = loadProject(folder.project.path);
  ASSERT_TRUE(again) << again.error().message();
  const auto& image = again->scene.materials[1].roughness_image;
  ASSERT_NE(image, nullptr);
  EXPECT_EQ(image->pixels[1], 0.25F);
  EXPECT_EQ(image->pixels[4], 0.125F);
}

TEST(SaveProject, SurroundingsAreWrittenOfEveryKind) {
  Saved folder;
  folder.write("probe.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                                std::string("\x80\x80\x80\x81\x80\x80\x80\x81", 8));
  auto& environment = folder.project.scene.environment;
  environment = scene::Environment{"", scene::Sky{.cie = 12,
                                                  .sun_azimuth_deg = 200.5,
                                                  .sun_altitude_deg = 33.0,
                                                  .horizontal_illuminance = 12000.0,
                                                  .direct_normal_illuminance = 50000.0,
                                                  .ground_reflectance = 0.25}};
  const auto again = [&] {
    EXPECT_TRUE(saveProject(folder.project, folder.project.path));
    const auto loaded = loadProject(folder.project.path);
    EXPECT_TRUE(loaded) << loaded.error().message();
    return loaded->scene.environment;
  };
  const auto sky = again();
  ASSERT_TRUE(sky);
  EXPECT_TRUE(scene::same(*sky, *environment));
  scene::Probe probe{"probe.hdr", scene::ProbeLayout::angular, 30.0, 2.0, nullptr};
  environment = scene::Environment{"", probe};
  const auto picture = again();
  ASSERT_TRUE(picture);
  probe.image = std::get<scene::Probe>(picture->light).image;
  EXPECT_NE(probe.image, nullptr);
  EXPECT_TRUE(scene::same(*picture, scene::Environment{"", probe}));
  environment = scene::Environment{"", scene::PatchLight{.side_gain = 3.0, .rotation_deg = 15.0}};
  const auto patches = again();
  ASSERT_TRUE(patches);
  EXPECT_NEAR(std::get<scene::PatchLight>(patches->light).side_azimuth_rad, 2.5, 1e-15);
  environment.reset();
  EXPECT_FALSE(again());
}

TEST(SaveProject, KeysOfASkyThatNobodyKnowsStay) {
  std::string text = kFullProject;
  text.insert(text.rfind('}'),
              R"(, "environment": { "sky": { "cie": 1, "station": "roof" }, "note": "by day",
                                    "horizontal_illuminance": 10000 })");
  Saved folder(text);
  std::get<scene::Sky>(folder.project.scene.environment->light).cie = 3;
  EXPECT_TRUE(saveProject(folder.project, folder.project.path));
  const std::string saved = folder.read("p.soffit");
  EXPECT_NE(saved.find("roof"), std::string::npos);
  EXPECT_NE(saved.find("by day"), std::string::npos);
  EXPECT_NE(saved.find("\"cie\": 3"), std::string::npos);
}

TEST(SaveProject, UnknownKeysSurviveEdits) {
  Saved folder;
  folder.project.scene.luminaires[0].flux = 1.0;
  folder.project.scene.layouts[1].edits["Panel 1"].dimming = 0.4;
  folder.project.scene.materials[1].diffuse = dvec3(0.1);
  folder.roundTrip();
  const std::string text = folder.read("p.soffit");
  for (const char* kept : {"\"author\": \"somebody\"", "\"article\": \"X-1\"",
                           "\"note\": \"later\"", "\"sheen\": 1"}) {
    EXPECT_NE(text.find(kept), std::string::npos) << kept;
  }
}

TEST(SaveProject, ARenamedLuminaireKeepsItsUnknownKeys) {
  Saved folder;
  folder.project.scene = *scene::withLuminaireRenamed(folder.project.scene, "Panel 1", "Panel A");
  folder.roundTrip();
  const Json first = (*folder.json()["luminaires"].asArray())[0];
  EXPECT_EQ(*first.find("name"), Json("Panel A"));
  EXPECT_EQ(*first.find("article"), Json("X-1"));
}

TEST(SaveProject, AddedAndRemovedLuminaires) {
  Saved folder;
  light::Luminaire spot;
  spot.name = "New";
  spot.shape = light::Disk{0.05};
  spot.flux = 500.0;
  folder.project.scene = *scene::withLuminaire(folder.project.scene, "", spot);
  folder.project.scene = *scene::withoutLuminaire(folder.project.scene, "Panel 1");
  folder.roundTrip();
  EXPECT_EQ(folder.json()["luminaires"].asArray()->size(), 2U);
}

TEST(SaveProject, AMaterialThatReturnsToTheFilesLosesItsOverride) {
  Saved folder;
  const auto wall =
      std::ranges::find(folder.project.file_materials, "wall", &scene::Material::name);
  folder.project.scene.materials[1].diffuse = wall->diffuse;
  folder.roundTrip();
  EXPECT_EQ(folder.json()["materials"]["wall"], Json::object({{"sheen", 1}}));
}

TEST(SaveProject, GlassComesAndGoes) {
  Saved folder;
  folder.project.scene.materials[1].glass = scene::Glass{1.6, 0.8};
  folder.project.scene.materials[1].diffuse = dvec3(0.0);
  const Project again = folder.roundTrip();
  EXPECT_EQ(again.scene.materials[1].glass->index, 1.6);
  const Json* diffuse = folder.json()["materials"]["wall"].find("diffuse");
  ASSERT_NE(diffuse, nullptr) << "the paint under the glass stays";
  folder.project = again;
  folder.project.scene.materials[1].glass = std::nullopt;
  folder.project.scene.materials[1].diffuse = dvec3(0.3);
  folder.roundTrip();
  EXPECT_EQ(folder.json()["materials"]["wall"].find("glass"), nullptr);
}

TEST(SaveProject, TheEnvironmentIsWrittenBackUntouched) {
  Saved folder(
      R"({"soffit": 1, "environment": {"sky": {"cie": 5, "sun": [1.50, 2]}, "horizontal_illuminance": 1e4}})");
  const Json before = *folder.json().find("environment");
  folder.project.scene.name = "x";
  folder.roundTrip();
  EXPECT_EQ(*folder.json().find("environment"), before);
}

TEST(SaveProject, ANewProjectNeedsNoDocument) {
  const TemporaryFolder folder;
  Project project;
  project.scene.name = "New";
  project.scene.mesh = std::make_shared<const geometry::Mesh>();
  light::Luminaire lamp;
  lamp.name = "Lamp";
  lamp.flux = 10.0;
  project.scene.luminaires = {lamp};
  ASSERT_TRUE(saveProject(project, folder.path() / "n.soffit"));
  const auto again = loadProject(folder.path());
  ASSERT_TRUE(again) << again.error().message();
  EXPECT_FALSE(scene::diff(project.scene, again->scene).any());
}

TEST(SaveProject, RefusesWhatWouldLoseTheBase) {
  const ProjectFolder folder;
  LoadOptions options;
  options.layout = "Evening";
  const auto project = folder.load(kFullProject, options);
  ASSERT_TRUE(project);
  const auto saved = saveProject(*project, project->path);
  ASSERT_FALSE(saved);
  EXPECT_EQ(
      folder.local(saved.error().message()),
      "p.soffit: a project under a layout or --set cannot be saved: its base would be lost. Load "
      "it without them, edit and save that.");
}

TEST(SaveProject, RefusesFaultsAndLeavesTheFileAlone) {
  Saved folder;
  const std::string before = folder.read("p.soffit");
  folder.project.scene.materials[0].diffuse.x = 2.0;
  const auto saved = saveProject(folder.project, folder.project.path);
  ASSERT_FALSE(saved);
  EXPECT_EQ(
      folder.local(saved.error().message()),
      "p.soffit: materials.floor.diffuse: expected a number from 0 to 1, found 2. Correct the "
      "number.");
  EXPECT_EQ(folder.read("p.soffit"), before);
  EXPECT_FALSE(folder.has("p.soffit~"));
}

}  // namespace
}  // namespace soffit::io
