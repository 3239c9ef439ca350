// SPDX-License-Identifier: MIT
#include "core/io/project/import_project.h"

#include "tests/core/io/project/example_project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace soffit::io {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A closed room of 6 x 4 x 3 units with one material.
const std::string kRoomObj =
    "mtllib room.mtl\n"
    "v 0 0 0\nv 6 0 0\nv 6 4 0\nv 0 4 0\nv 0 0 3\nv 6 0 3\nv 6 4 3\nv 0 4 3\n"
    "usemtl plaster\nf 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

TEST(ImportProject, CopiesTheModelAndWritesAProjectThatLoads) {
  const TemporaryFolder folder;
  const auto model = folder.write("in/room.obj", kRoomObj);
  folder.write("in/room.mtl", "newmtl plaster\nKd 0.7 0.6 0.5\n");
  const auto made = importProject(model, folder.path() / "out/house.soffit", {});
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_EQ(folder.read("out/room.obj"), kRoomObj);
  EXPECT_TRUE(folder.has("out/room.mtl"));
  const auto project = loadProject(folder.path() / "out");
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_TRUE(project->warnings.empty());
  EXPECT_EQ(project->scene.name, "house");
  EXPECT_EQ(project->scene.mesh->triangleCount(), 12U);
  EXPECT_EQ(project->scene.materials[0].diffuse, dvec3(0.7, 0.6, 0.5)) << "as its author wrote it";
  ASSERT_EQ(project->scene.layouts.size(), 1U);
  EXPECT_EQ(project->scene.layouts[0].name, "Layout 1");
  EXPECT_EQ(project->scene.cameras.size(), 1U);
  EXPECT_EQ(project->scene.work_planes.size(), 1U);
  EXPECT_TRUE(project->scene.luminaires.empty());
}

TEST(ImportProject, UnitAndUpAxisAreKeptInTheProject) {
  const TemporaryFolder folder;
  const auto model = folder.write("room.obj", kRoomObj);
  ImportChoices choices;
  choices.unit = 0.5;
  choices.up = 'y';
  ASSERT_TRUE(importProject(model, folder.path() / "p.soffit", choices));
  const auto project = loadProject(folder.path());
  ASSERT_TRUE(project) << project.error().message();
  EXPECT_EQ(project->scene.mesh->bounds().size(), vec3(3.0F, 1.5F, 2.0F));
}

TEST(ImportProject, AMaterialThatTheModelDoesNotDescribeStaysOpen) {
  const TemporaryFolder folder;
  const auto model = folder.write("room.obj", kRoomObj);
  const auto made = importProject(model, folder.path() / "p.soffit", {});
  ASSERT_TRUE(made) << made.error().message();
  EXPECT_THAT(made->warnings, Contains(HasSubstr("tells no colour")));
  const auto project = loadProject(folder.path());
  ASSERT_TRUE(project);
  EXPECT_THAT(project->warnings, Contains(HasSubstr("diffuse 0.5 is taken")));
}

TEST(ImportProject, NothingIsOverwritten) {
  const TemporaryFolder folder;
  const auto model = folder.write("in/room.obj", kRoomObj);
  folder.write("out/room.obj", "something else");
  const auto made = importProject(model, folder.path() / "out/house.soffit", {});
  ASSERT_FALSE(made);
  EXPECT_EQ(
      made.error().message(),
      (folder.path() / "out/room.obj").string() +
          ": another file of this name is there already. Choose another folder for the project, or "
          "remove that file.");
  EXPECT_FALSE(folder.has("out/house.soffit"));
  EXPECT_EQ(folder.read("out/room.obj"), "something else");
}

TEST(ImportProject, AnExistingProjectIsKeptAsBackup) {
  const TemporaryFolder folder;
  const auto model = folder.write("room.obj", kRoomObj);
  folder.write("p.soffit", "precious");
  ASSERT_TRUE(importProject(model, folder.path() / "p.soffit", {}));
  EXPECT_EQ(folder.read("p.soffit~"), "precious");
}

TEST(ImportProject, RefusesOtherNamesAndBrokenModels) {
  const TemporaryFolder folder;
  const auto model = folder.write("room.obj", kRoomObj);
  const auto name = importProject(model, folder.path() / "p.json", {});
  ASSERT_FALSE(name);
  EXPECT_EQ(name.error().what, "a project's name ends in .soffit");
  const auto broken = folder.write("empty.obj", "");
  EXPECT_FALSE(importProject(broken, folder.path() / "out/p.soffit", {}));
  EXPECT_FALSE(importProject(folder.path() / "none.obj", folder.path() / "out/p.soffit", {}));
  EXPECT_FALSE(folder.has("out")) << "nothing is half written";
}

}  // namespace
}  // namespace soffit::io
