// SPDX-License-Identifier: MIT
#include "core/io/project/move_project.h"

#include "core/scene/diff.h"
#include "core/scene/edits.h"
#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>

namespace soffit::io {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string kNamesEverything = R"({
  "soffit": 1, "name": "Moves",
  "geometry": [{"file": "models/quad.obj", "unit": 1.0, "up": "z"}],
  "luminaires": [
    {"name": "Spot", "shape": "point", "position": [0, 0, 2], "distribution": {"ies": "light/spot.ies"}},
    {"name": "Sign", "shape": {"mesh": "quad.obj"}, "position": [0, 0, 2], "flux": 100}],
  "layouts": [{"name": "Other", "luminaires": {"Spot": {"distribution": {"ies": "other.ies"}}}}],
  "kept": "by whoever wrote it"
})";

struct Everything : ProjectFolder {
  Everything() {
    write("models/quad.obj", kQuadObj);
    write("models/quad.mtl", kQuadMtl);
    write("light/spot.ies", kDiskIes);
    write("other.ies", kDiskIes);
  }
};

TEST(SaveProjectAs, TakesAlongAllThatTheProjectNames) {
  const Everything folder;
  auto project = folder.load(kNamesEverything);
  ASSERT_TRUE(project) << project.error().message();
  project->scene.luminaires[0].dimming = 0.5;
  const fs::path target = folder.path() / "far/away/moved.soffit";
  const auto moved = saveProjectAs(*project, target);
  ASSERT_TRUE(moved) << moved.error().message();
  EXPECT_EQ(moved->path, target);
  for (const char* name : {"models/quad.obj", "models/quad.mtl", "light/spot.ies", "other.ies",
                           "quad.obj", "quad.mtl"}) {
    EXPECT_TRUE(folder.has(std::string("far/away/") + name)) << name;
  }
  EXPECT_FALSE(folder.has("far/away/p.soffit"));
  // It stands on its own: without the old folder's files it loads the same.
  fs::remove_all(folder.path() / "models");
  fs::remove(folder.path() / "other.ies");
  const auto loaded = loadProject(target);
  ASSERT_TRUE(loaded) << loaded.error().message();
  EXPECT_FALSE(scene::diff(project->scene, loaded->scene).any());
  EXPECT_THAT(folder.read("far/away/moved.soffit"), HasSubstr("by whoever wrote it"));
}

TEST(SaveProjectAs, InItsOwnFolderIsAnotherName) {
  const Everything folder;
  const auto project = folder.load(kNamesEverything);
  ASSERT_TRUE(project);
  ASSERT_TRUE(saveProjectAs(*project, folder.path() / "second.soffit").ok());
  EXPECT_TRUE(loadProject(folder.path() / "second.soffit").ok());
}

TEST(SaveProjectAs, NeverReplacesAnotherFile) {
  const Everything folder;
  const auto project = folder.load(kNamesEverything);
  ASSERT_TRUE(project);
  folder.write("busy/other.ies", "somebody else's");
  const auto moved = saveProjectAs(*project, folder.path() / "busy/p.soffit");
  ASSERT_FALSE(moved.ok());
  EXPECT_THAT(moved.error().message(), HasSubstr("another file of this name is there already"));
  EXPECT_EQ(folder.read("busy/other.ies"), "somebody else's");
  EXPECT_FALSE(folder.has("busy/p.soffit"));
}

TEST(WithModel, AddsGeometryAndLeavesTheRest) {
  const Everything folder;
  auto project = folder.load(kNamesEverything);
  ASSERT_TRUE(project);
  project->scene.luminaires[0].dimming = 0.25;  // not saved yet
  const auto model = folder.write("elsewhere/chair.obj",
                                  "mtllib chair.mtl\nv 0 0 0\nv 200 0 0\nv 0 100 0\n"
                                  "usemtl oak\nf 1 2 3\n");
  folder.write("elsewhere/chair.mtl", "newmtl oak\nKd 0.4 0.3 0.2\n");
  ImportChoices choices;
  choices.unit = 0.01;
  std::vector<std::string> written;
  const auto grown = withModel(*project, model, choices, &written);
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_THAT(written, testing::ElementsAre("chair.mtl", "chair.obj"));
  EXPECT_EQ(grown->geometry.size(), 2U);
  EXPECT_EQ(grown->geometry[1].file, "chair.obj");
  EXPECT_TRUE(folder.has("chair.obj"));
  EXPECT_TRUE(folder.has("chair.mtl"));
  EXPECT_EQ(grown->scene.mesh->triangleCount(), project->scene.mesh->triangleCount() + 1);
  EXPECT_EQ(grown->scene.luminaires[0].dimming, 0.25);
  EXPECT_EQ(grown->scene.materials.back().name, "oak");
  EXPECT_EQ(grown->scene.mesh->bounds().size().x, 2.0F);
  // The file is untouched until it is saved.
  EXPECT_EQ(loadProject(folder.path() / "p.soffit")->geometry.size(), 1U);
  ASSERT_TRUE(saveProject(*grown, grown->path).ok());
  EXPECT_FALSE(scene::diff(grown->scene, loadProject(grown->path)->scene).any());
}

TEST(WithModel, ANameThatIsTakenGetsAFolder) {
  const Everything folder;
  const auto project = folder.load(kNamesEverything);
  ASSERT_TRUE(project);
  const auto model = folder.write("elsewhere/quad.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto grown = withModel(*project, model, {});
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_EQ(grown->geometry[1].file, "quad/quad.obj");
  EXPECT_EQ(folder.read("quad.obj"), kQuadObj);
}

TEST(WithModel, AnEmptyProjectGetsPlaces) {
  const ProjectFolder folder;
  const auto project = folder.load(R"({"soffit": 1, "geometry": []})");
  ASSERT_TRUE(project);
  const auto grown = withModel(*project, folder.path() / "quad.obj", {});
  ASSERT_TRUE(grown) << grown.error().message();
  EXPECT_EQ(grown->scene.cameras.size(), 1U);
}

TEST(MeasureModel, TellsTheSizeInMetres) {
  const ProjectFolder folder;
  ImportChoices choices;
  choices.unit = 0.5;
  choices.up = 'y';
  const auto size = measureModel(folder.path() / "quad.obj", choices);
  ASSERT_TRUE(size);
  EXPECT_EQ(size->size_m, dvec3(0.5, 0.5, 0.5));
  EXPECT_EQ(describeModel(*size), "3 triangles, 2 materials, 0.50 x 0.50 m in plan, 0.50 m high");
  EXPECT_FALSE(measureModel(folder.path() / "none.obj", {}).ok());
  EXPECT_TRUE(isModelFile("a.GLB"));
  EXPECT_FALSE(isModelFile("a.soffit"));
}

TEST(LoadOptions, ATextTakesThePlaceOfTheFiles) {
  const ProjectFolder folder;
  LoadOptions options;
  options.text = R"({"soffit": 1, "name": "Kept", "geometry": [{"file": "quad.obj"}]})";
  const auto project = loadProject(folder.path() / "not-there.soffit", options);
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.name, "Kept");
  EXPECT_EQ(project->path, folder.path() / "not-there.soffit");
}

}  // namespace
}  // namespace soffit::io
