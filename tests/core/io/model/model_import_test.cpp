// SPDX-License-Identifier: MIT
#include "core/io/model/model_import.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stop_token>

#include "core/geometry/components.h"
#include "tests/core/io/model/sample_models.h"
#include "tests/core/io/model/scratch_folder.h"

namespace soffit::io {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Round-off: the importer reads single precision, the largest coordinates are some 10 m.
constexpr float kRoundoff = 16 * 4 * 0x1p-24F;

void expectBounds(const geometry::Mesh& mesh, const dvec3& lo, const dvec3& hi, double scale = 1) {
  const Box box = mesh.bounds();
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mesh.origin[k] + double{box.lo[k]}, lo[k], scale * kRoundoff) << k;
    EXPECT_NEAR(mesh.origin[k] + double{box.hi[k]}, hi[k], scale * kRoundoff) << k;
  }
}

TEST(ModelImport, ReadsABlockAsASolid) {
  const ScratchFolder folder;
  const auto model = importModel(folder.write("block.obj", kBlockObj), {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->mesh.triangles.size(), 12U);
  EXPECT_THAT(model->mesh.objects, ElementsAre("block"));
  expectBounds(model->mesh, {0, 0, 0}, {4, 5, 2.8});
  const auto parts = geometry::findComponents(model->mesh);
  ASSERT_EQ(parts.list.size(), 1U);
  EXPECT_TRUE(parts.list[0].solid());
  EXPECT_NEAR(parts.list[0].signed_volume, 56.0, 56 * 64 * 0x1p-24);
  EXPECT_TRUE(model->warnings.empty());
}

TEST(ModelImport, AppliesUnitUpScaleRotationAndTranslationInThatOrder) {
  const ScratchFolder folder;
  const auto file = folder.write("block.obj", kBlockObj);
  ImportOptions options;
  options.unit = 0.001;
  auto model = importModel(file, options);
  ASSERT_TRUE(model);
  expectBounds(model->mesh, {0, 0, 0}, {0.004, 0.005, 0.0028}, 1e-3);
  options = {.up = 'y'};
  model = importModel(file, options);
  ASSERT_TRUE(model);
  expectBounds(model->mesh, {0, -2.8, 0}, {4, 0, 5});
  EXPECT_TRUE(geometry::findComponents(model->mesh).list.at(0).outward());
  options = {
      .unit = 0.5, .up = 'z', .translate = {10, 20, 30}, .rotate_deg = {0, 0, 90}, .scale = 4.0};
  model = importModel(file, options);
  ASSERT_TRUE(model);
  expectBounds(model->mesh, {10 - 10, 20, 30}, {10, 28, 35.6}, 4);
}

TEST(ModelImport, AMirroringScaleKeepsFrontsOutward) {
  const ScratchFolder folder;
  const auto model = importModel(folder.write("block.obj", kBlockObj), {.scale = -1.0});
  ASSERT_TRUE(model);
  expectBounds(model->mesh, {-4, -5, -2.8}, {0, 0, 0});
  EXPECT_TRUE(geometry::findComponents(model->mesh).list.at(0).outward());
  EXPECT_EQ(model->cleaning.turned, 0U);
}

TEST(ModelImport, CountsWhatItLeavesOut) {
  const ScratchFolder folder;
  const std::string text = std::string(kBlockObj) +
                           "p 1\np 2\nl 1 2\n"
                           "v nan 0 0\nf 1 2 9\n"  // not a number
                           "f 1 1 2\n"             // no area
                           "f 1 4 3\n";            // there already
  const auto model = importModel(folder.write("block.obj", text), {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_EQ(model->points, 2U);
  EXPECT_EQ(model->lines, 1U);
  EXPECT_EQ(model->cleaning.non_finite, 1U);
  EXPECT_EQ(model->cleaning.degenerate, 1U);
  EXPECT_EQ(model->cleaning.duplicate, 1U);
  EXPECT_EQ(model->mesh.triangles.size(), 12U);
  EXPECT_THAT(
      model->warnings,
      ElementsAre("1 triangles dropped: corners that are not finite numbers",
                  "1 triangles dropped: no area", "1 triangles dropped: duplicates of others",
                  "2 points left out", "1 lines left out"));
}

TEST(ModelImport, KeepsMaterialsAndObjectsApart) {
  const ScratchFolder folder;
  folder.write("room.mtl", "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0 0 1\n");
  const auto model = importModel(
      folder.write("room.obj",
                   "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                   "o left\nusemtl red\nf 1 2 3\no right\nusemtl blue\nf 1 2 4\nusemtl red\n"
                   "f 2 3 4\n"),
      {});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_THAT(model->mesh.materials, ElementsAre("red", "blue"));
  EXPECT_THAT(model->mesh.objects, ElementsAre("left", "right"));
  EXPECT_THAT(model->mesh.material_of, ElementsAre(0, 1, 0));
  EXPECT_THAT(model->mesh.object_of, ElementsAre(0, 1, 1));
  ASSERT_EQ(model->materials.size(), 2U);
  EXPECT_EQ(model->materials[0].name, "red");
  EXPECT_NEAR(model->materials[0].diffuse.x, 0.8, 1e-7);  // round-off of single precision
}

std::string messageOf(const std::filesystem::path& file, const ImportOptions& options = {}) {
  const auto model = importModel(file, options);
  EXPECT_FALSE(model);
  if (model) return {};
  EXPECT_EQ(model.error().message().find('\n'), std::string::npos);
  return model.error().message();
}

TEST(ModelImportErrors, NameTheFileAndARemedy) {
  const ScratchFolder folder;
  EXPECT_THAT(messageOf(folder.path() / "none.obj"),
              AllOf(HasSubstr("none.obj"), HasSubstr("does not exist"), HasSubstr("Check")));
  EXPECT_THAT(messageOf(folder.path()), HasSubstr("is not a file"));
  EXPECT_THAT(messageOf(folder.write("house.dwg", "x")),
              AllOf(HasSubstr("no model format"), HasSubstr("OBJ, glTF")));
  EXPECT_THAT(messageOf(folder.write("empty.obj", "")), HasSubstr("cannot be read"));
  EXPECT_THAT(messageOf(folder.write("noise.gltf", "not json at all")),
              AllOf(HasSubstr("noise.gltf: cannot be read"), HasSubstr("Export")));
  EXPECT_THAT(messageOf(folder.write("noise.ifc", "not STEP at all")), HasSubstr("IFC 2x3"));
  EXPECT_THAT(messageOf(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")),
              HasSubstr("holds no triangles"));
  EXPECT_THAT(messageOf(folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")),
              HasSubstr("all of its 1 triangles are degenerate"));
  EXPECT_THAT(messageOf(folder.write("head.ply", "ply\nformat ascii 1.0\nelement vertex 8\n")),
              HasSubstr("end_header"));
}

TEST(ModelImportErrors, OptionsAreChecked) {
  const ScratchFolder folder;
  const auto file = folder.write("block.obj", kBlockObj);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double unit : {0.0, -1.0, nan}) {
    EXPECT_THAT(messageOf(file, {.unit = unit}), HasSubstr("unit must be a positive number"));
  }
  for (const double scale : {0.0, nan}) {
    EXPECT_THAT(messageOf(file, {.scale = scale}), HasSubstr("scale must be a number other"));
  }
  EXPECT_THAT(messageOf(file, {.up = 'x'}), HasSubstr("up axis must be y or z"));
  EXPECT_THAT(messageOf(file, {.translate = {nan, 0, 0}}), HasSubstr("finite numbers"));
  EXPECT_THAT(messageOf(file, {.rotate_deg = {0, nan, 0}}), HasSubstr("finite numbers"));
}

TEST(ModelImportErrors, SideFilesStayInTheFolder) {
  const ScratchFolder folder;
  folder.write("secret.mtl", "newmtl red\nKd 0.8 0.1 0.1\n");
  const std::string text = "mtllib ../secret.mtl\nusemtl red\n" + std::string(kBlockObj);
  const auto file = folder.write("project/block.obj", text);
  EXPECT_THAT(messageOf(file), AllOf(HasSubstr("secret.mtl"), HasSubstr("outside")));
  const auto model = importModel(file, {.folder = folder.path()});
  ASSERT_TRUE(model) << model.error().message();
  EXPECT_TRUE(model->described.at(0));
  ASSERT_EQ(model->side_files.size(), 1U);
  EXPECT_EQ(model->side_files[0].filename(), "secret.mtl");
}

TEST(ModelImportErrors, AStopRequestEndsIt) {
  const ScratchFolder folder;
  std::stop_source source;
  source.request_stop();
  const auto model =
      importModel(folder.write("block.obj", kBlockObj), {}, Job{.stop = source.get_token()});
  ASSERT_FALSE(model);
  EXPECT_THAT(model.error().message(), HasSubstr("cancelled"));
}

TEST(ModelImport, ReportsProgress) {
  struct Listener : ProgressObserver {
    void onProgress(std::string_view stage, double done) override {
      EXPECT_GE(done, 0.0);
      EXPECT_LE(done, 1.0);
      stages.emplace_back(stage);
    }
    std::vector<std::string> stages;
  } listener;
  const ScratchFolder folder;
  ASSERT_TRUE(importModel(folder.write("block.obj", kBlockObj), {}, Job{.observer = &listener}));
  EXPECT_THAT(listener.stages, Contains("reading the model"));
  EXPECT_THAT(listener.stages, Contains("cleaning the model"));
}

TEST(ModelImport, WorksFromTheCurrentFolder) {
  const ScratchFolder folder;
  folder.write("block.obj", kBlockObj);
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const auto model = importModel("block.obj", {});
  std::filesystem::current_path(before);
  EXPECT_TRUE(model);
}

}  // namespace
}  // namespace soffit::io
